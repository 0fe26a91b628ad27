#pragma once

#include <array>
#include <utility>
#include <vector>

#include "query/subdivision/adaptive_levels.hpp"

namespace toccata {

struct LimitTriangle {
  std::array<Index, 3> corners{};
  Index cage_face = 0;
  double distance = 0;  ///< between it and what of the limit surface it stands for, both ways
};

/// The leaves as one mesh without cracks: every vertex is where the finest level has it, and a leaf takes the vertices
/// that finer neighbours have on its border into its own.
class LevelTriangles {
 public:
  explicit LevelTriangles(const AdaptiveLevels& levels);

  /// Corners of the triangles, and these.
  [[nodiscard]] std::pair<std::vector<Vec3>, std::vector<LimitTriangle>> taken() && {
    return {std::move(points_), std::move(triangles_)};
  }

 private:
  /// A vertex of the border of a leaf, and where the leaf alone would have it.
  struct BorderPoint {
    Index point = 0;
    Vec3 own{};
  };
  struct Between {
    Index point = 0;
    double share = 0;  ///< of the way along the side
  };

  Index point_of(std::size_t level, Index vertex);
  void add_between(std::size_t level, Index side, double from, double to, std::vector<Between>& found);
  void take_border(std::size_t level, Index face);
  void add_leaf(std::size_t level, Index face);
  void add_fan(std::size_t level, Index face, double distance);
  void add_quadrangle(const LevelMesh& mesh, Index face, double distance);

  const AdaptiveLevels& levels_;
  std::vector<std::vector<Index>> known_;  ///< of each level's vertices, their points
  std::vector<BorderPoint> border_;
  std::vector<Vec3> points_;
  std::vector<LimitTriangle> triangles_;
};

/// The leaves as a mesh, faces in the order of the cage's.
struct LeafMesh {
  TriangleMesh mesh;
  std::vector<double> triangle_distances;
};
[[nodiscard]] LeafMesh leaf_mesh(const AdaptiveLevels& levels);

/// What rounding alone contributes to the distance of every triangle of a level and of all later ones.
[[nodiscard]] double rounding_of_triangles(const LevelMesh& mesh);

}  // namespace toccata
