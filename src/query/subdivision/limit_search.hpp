#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "query/subdivision/limit_bound.hpp"

namespace toccata {

/// What a search is to find out: how far apart, or only whether they meet.
enum class LimitGoal { distance, overlap };

/// What is known of the distance of a limit surface and a model, both taken as surfaces or the model as a solid.
struct LimitFinding {
  double lower = 0;
  LimitDistance best{.upper = std::numeric_limits<double>::infinity()};
  bool is_proved_contact = false;  ///< a point of the limit surface certainly lies within the solid
  bool is_exhausted = false;       ///< it ended early
  int level = 0;
};

/// Level by level, keeps the faces whose limit may be the nearest and refines those alone.
class LimitSearch {
 public:
  /// The cage is in the world, the model where `query` has it.
  LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal);

  [[nodiscard]] LimitFinding found();

 private:
  /// A face and the least distance that its limit may have.
  struct Candidate {
    Index face = 0;
    double lower = 0;
  };

  void look_at_level();
  [[nodiscard]] double looked_at(Index face, double within);
  [[nodiscard]] double looked_at(const Triangle& triangle, Index face, double within);
  [[nodiscard]] bool is_deep_inside(const Triangle& triangle, double within) const;
  [[nodiscard]] bool is_open(double lower) const;
  [[nodiscard]] bool is_enough() const;
  [[nodiscard]] std::vector<char> open_faces();

  const Model& model_;
  LimitQuery query_;
  LimitGoal goal_;
  bool is_solid_ = false;
  LevelMesh mesh_;
  std::vector<Candidate> candidates_;
  double settled_ = std::numeric_limits<double>::infinity();  ///< the least of faces that are not refined further
  LimitFinding finding_;
  Workspace workspace_;
};

}  // namespace toccata
