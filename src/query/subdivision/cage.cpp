#include <algorithm>
#include <utility>

#include "query/subdivision/cage_checks.hpp"

namespace toccata {

SubdivisionCage::SubdivisionCage(PolygonMesh polygons, SubdivisionScheme scheme, CageFeatures features)
    : polygons_(std::move(polygons)), scheme_(scheme), features_(std::move(features)) {
  const LevelMesh mesh = checked_level(polygons_, scheme_, features_, {.points = polygons_.vertices});
  part_at_vertices(mesh, polygons_, features_);
  closed_ = std::none_of(mesh.edges.begin(), mesh.edges.end(),
                         [](const LevelEdge& edge) { return edge.sides[1] == no_index; });
}

SubdivisionCage SubdivisionCage::posed(const Pose& pose) const {
  return {{transform(pose, polygons_.vertices), polygons_.corners, polygons_.first}, scheme_, features_};
}

}  // namespace toccata
