#include "methods/voronoi/walk_start.hpp"

#include "narrow/convex/gjk.hpp"
#include "shapes/hull_guide.hpp"

namespace toccata {
namespace {

/// Uphill from a vertex; the direction is in the shape's own frame. It ends, as heights only grow.
Index highest_from(const RegionParts& parts, const Vec3& direction, Index start) {
  Index highest = start;
  double height = dot(direction, parts.vertex(start));
  for (Index from = parts.vertex_count; from != highest;) {
    from = highest;
    for (const RegionParts::Spoke& spoke : parts.spokes_at(from))
      if (const double other = dot(direction, parts.vertex(spoke.vertex)); other > height) {
        height = other;
        highest = spoke.vertex;
      }
  }
  return highest;
}

Index farthest_vertex(const PosedPolytope& shape, const WalkBody& body, const Vec3& direction) {
  const std::span<const Index> guide = body.parts->topology.guide;
  if (guide.empty()) return SupportSearch(shape, support_kernels(), GjkSupport::scan).least(-direction);
  const Vec3 own = body.own(direction);
  return highest_from(*body.parts, own, guide[guide_cell(own, guide.size())]);
}

}  // namespace

std::array<Index, 2> facing_vertices(const PosedPolytope& a, const WalkBody& body_a, const PosedPolytope& b,
                                     const WalkBody& body_b) {
  const Vec3 way = body_b.point(body_b.parts->middle) - body_a.point(body_a.parts->middle);
  return {farthest_vertex(a, body_a, way), farthest_vertex(b, body_b, -way)};
}

}  // namespace toccata
