#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "query/subdivision/limit_bound.hpp"

namespace toccata {

/// What a search is to find out: how far apart, or only whether they meet.
enum class LimitGoal { distance, overlap };

/// What is known of the distance of a limit surface and a model, both taken as surfaces or the model as a solid; or of
/// two limit surfaces.
struct LimitFinding {
  double lower = 0;
  LimitDistance best{.upper = std::numeric_limits<double>::infinity()};
  bool is_proved_contact = false;  ///< a point of the limit surface certainly lies within the solid
  int level = 0;
};

/// Level by level, keeps the faces whose limit may be the nearest and refines those alone; of two cages on both sides.
class LimitSearch {
 public:
  /// The cage is in the world, the model where `query` has it.
  LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal);
  /// Both are in the world.
  LimitSearch(const SubdivisionCage& cage, const SubdivisionCage& other, const LimitQuery& query, LimitGoal goal);

  [[nodiscard]] LimitFinding found();

 private:
  /// A face and the least distance that its limit may have.
  struct Candidate {
    Index face = 0;
    double lower = 0;
    bool is_settled = false;  ///< what is open about it is rounding
  };
  /// The faces of a cage that are still of interest.
  struct CageSide {
    LevelMesh mesh;
    std::vector<double> within;  ///< how near its limit each face is
    std::vector<Candidate> candidates;
  };
  /// What the faces of a side are held against: a model, or the faces of the other side.
  struct Opposite {
    Model model;
    double within = 0;  ///< how near its limit it is, at most
    PairQuery pair;
    std::vector<Index> cage_faces;  ///< of its triangles; none of a model
  };

  void look_at_level();
  void look_at(CageSide& side, const Opposite& opposite, bool is_first);
  [[nodiscard]] double looked_at(const CageSide& side, Index face, const Opposite& opposite, bool is_first);
  [[nodiscard]] double looked_at(const CageSide& side, const Triangle& triangle, Index face, const Opposite& opposite,
                                 bool is_first);
  [[nodiscard]] static Opposite as_opposite(const CageSide& side);
  [[nodiscard]] bool is_deep_inside(const Triangle& triangle, double within) const;
  [[nodiscard]] bool is_open(double lower) const;
  [[nodiscard]] bool is_enough() const;
  [[nodiscard]] std::vector<char> open_faces(const CageSide& side);
  [[nodiscard]] bool refine_open_faces();

  LimitQuery query_;
  LimitGoal goal_;
  bool is_solid_ = false;  ///< the model
  std::optional<Opposite> model_;
  std::vector<CageSide> sides_;
  double settled_ = std::numeric_limits<double>::infinity();  ///< the least of faces that are not refined further
  LimitFinding finding_;
  Workspace workspace_;
};

}  // namespace toccata
