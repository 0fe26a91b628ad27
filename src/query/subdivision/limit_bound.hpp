#pragma once

#include <vector>

#include "query/subdivision/difference_growth.hpp"
#include "query/subdivision/level_mesh.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// How far the limit surface of a face is from the face, flat or bilinear, point by point.
struct FaceBound {
  /// No point moves farther than this in all levels that follow, nor in some of them.
  double to_limit = 0;
  /// Two triangles, or any that cover the face with its border, are nowhere farther than this from the bilinear
  /// quadrangle of the same corners; 0 of triangles.
  double from_triangles = 0;
};

/// Bounds of whole faces of a level, with the proof of docs/methods/subdivision-surfaces.md. With Catmull–Clark all
/// faces must be quadrangles.
class LimitBounds {
 public:
  explicit LimitBounds(const LevelMesh& mesh) : mesh_(mesh), known_(mesh.points.size()), boxes_(mesh.points.size()) {}

  [[nodiscard]] FaceBound of(Index face);

  /// What of the points around a face bounds what later levels move.
  struct FaceDifferences {
    bool is_settled = true;  ///< no sharpness ends at a later level: if one does, only hulls bound what follows
    bool is_regular = true;
    SecondDifferences differences{};
    DifferenceGrowth growth;
  };
  [[nodiscard]] FaceDifferences differences_around(Index face);

 private:
  struct Surroundings {
    bool is_known = false;
    bool is_settled = true;
    bool is_regular = false;
    bool has_creases = false;
    SecondDifferences differences{};
    DifferenceGrowth growth;
  };

  const Surroundings& around(Index vertex);
  [[nodiscard]] Surroundings looked_at(Index vertex);
  void measure_spoke(Index vertex, Index edge, VertexRule rule, Surroundings& found) const;
  [[nodiscard]] double across(Index vertex, const LevelEdge& edge) const;
  [[nodiscard]] double by_hull(Index face);
  const Aabb& box_around(Index vertex);

  const LevelMesh& mesh_;
  std::vector<Surroundings> known_;
  std::vector<Aabb> boxes_;  ///< of all corners of the faces at a vertex; empty until somebody asks
  Spokes spokes_;
};

/// What rounding alone contributes to the bound of every face of the level; refining makes it no smaller.
[[nodiscard]] double rounding_of_bounds(const LevelMesh& mesh);

}  // namespace toccata
