#pragma once

#include <algorithm>
#include <array>
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

/// How often faces are compared.
struct FaceComparisons {
  std::size_t most = 0;
  Progress progress{};
  std::size_t taken = 0;

  [[nodiscard]] bool are_spent() const { return taken >= most; }
  void count() {
    constexpr std::size_t often = 256;
    if (++taken % often == 0 && progress) progress(taken, most);
  }
};

/// The faces of a cage that are still of interest at a level.
struct CageSide {
  /// A face and the least distance that its limit may have.
  struct Candidate {
    Index face = 0;
    double lower = 0;
    bool is_settled = false;  ///< what is open about it is rounding
  };

  explicit CageSide(const SubdivisionCage& cage) : mesh(first_level(cage)) {}

  /// Takes the faces that may be as near as `upper`, with the least distance that each may have.
  void keep(const std::vector<double>& lowers, double upper);
  [[nodiscard]] double least() const;
  [[nodiscard]] std::vector<Triangle> triangles_of(Index face) const;

  LevelMesh mesh;
  std::vector<double> within;  ///< how near its limit each face is
  std::vector<Candidate> candidates;
};

/// What is known of the faces of two sides at a level, which are in `within`.
struct PairOfSides {
  LimitDistance best;
  std::array<std::vector<double>, 2> lowers;  ///< of each face the least distance that its limit may have
};

/// `best` is the nearest so far. Faces that can only be farther need not be told apart: their lowers are infinite. When
/// the comparisons are spent, only `best` is of use.
[[nodiscard]] PairOfSides nearest_of_sides(const CageSide& first, const CageSide& second, const LimitDistance& best,
                                           FaceComparisons& comparisons);

/// Level by level, keeps the faces whose limit may be the nearest and refines those alone; of two cages on both sides.
class LimitSearch {
 public:
  /// The cage is in the world, the model where `query` has it.
  LimitSearch(const SubdivisionCage& cage, const Model& model, const LimitQuery& query, LimitGoal goal);
  /// Both are in the world.
  LimitSearch(const SubdivisionCage& cage, const SubdivisionCage& other, const LimitQuery& query, LimitGoal goal);

  [[nodiscard]] LimitFinding found();

 private:
  /// Those of a side that are to be refined, and the least distance of the others that may count.
  struct OpenFaces {
    std::vector<char> marks;
    std::size_t count = 0;
    double settled = 0;
  };

  [[nodiscard]] double proved_lower() const;
  void look_at_level();
  void look_at_model();
  void look_at_both();
  [[nodiscard]] double looked_at(const Triangle& triangle, Index face);
  [[nodiscard]] bool is_deep_inside(const Triangle& triangle, double within) const;
  [[nodiscard]] bool is_open(double lower) const;
  [[nodiscard]] bool is_enough() const;
  [[nodiscard]] OpenFaces open_faces(const CageSide& side) const;
  [[nodiscard]] bool refine_open_faces();

  LimitQuery query_;
  LimitGoal goal_;
  std::optional<Model> model_;  ///< none of two cages
  bool is_solid_ = false;       ///< the model
  std::vector<CageSide> sides_;
  double settled_ = std::numeric_limits<double>::infinity();  ///< the least of faces that are not refined further
  LimitFinding finding_;
  FaceComparisons comparisons_;
  Workspace workspace_;
};

/// More than the rounding of a sum of two.
inline constexpr double up_by_sum = 1 + 0x1p-50;

inline double sum_up(double a, double b) { return (a + b) * up_by_sum; }

/// At most a − b, and not below 0.
inline double difference_down(double a, double b) { return std::max(0.0, a - b * up_by_sum - a * 0x1p-50); }

}  // namespace toccata
