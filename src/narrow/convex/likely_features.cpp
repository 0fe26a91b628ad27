#include "narrow/convex/likely_features.hpp"

#include <array>
#include <utility>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/primitives/closed_forms.hpp"

namespace toccata {
namespace {

Vec3 edge_of(const PosedPolytope& core) { return core.vertex(core.vertex_count() - 1) - core.vertex(0); }

/// Of a point or a segment: which of its vertices hold the point at the share of its edge.
struct SegmentFeature {
  std::array<Index, 2> vertex{};
  std::size_t count = 1;

  explicit SegmentFeature(double share) {
    if (share >= 1) vertex[0] = 1;
    if (!(share > 0 && share < 1)) return;
    vertex[1] = 1;
    count = 2;
  }
};

/// Of points and segments: by the formula, without a search.
VertexPairs of_segments(const PosedPolytope& a, const PosedPolytope& b) {
  const SegmentWeights at = nearest_weights_of_segments(a.vertex(0) - b.vertex(0), edge_of(a), edge_of(b));
  const SegmentFeature of_a(at.s), of_b(at.t);
  VertexPairs pairs;
  for (std::size_t i = 0; i < of_a.count; ++i) pairs.append(of_a.vertex[i], of_b.vertex[0]);
  for (std::size_t i = 1; i < of_b.count; ++i) pairs.append(of_a.vertex[0], of_b.vertex[i]);
  return pairs;
}

/// Of a point beside a box: the corner, two ends of an edge, or three corners of a face around the foot. None of one
/// that is inside.
struct BoxFeature {
  std::array<Index, 3> corner{};
  std::size_t count = 0;

  BoxFeature(const Vec3& point, const PosedPolytope& box) {
    const Vec3 origin = box.vertex(0), from = point - origin;
    Index near = 0;  // the corner from which the free edges start
    std::array<Index, 3> free{};
    std::array<double, 3> share{};
    std::size_t free_count = 0;
    for (const Index bit : {1U, 2U, 4U}) {
      const Vec3 edge = box.vertex(bit) - origin;
      const double at = dot(from, edge) / dot(edge, edge);
      if (at >= 1) near |= bit;
      if (!(at > 0 && at < 1)) continue;
      share[free_count] = at;
      free[free_count++] = bit;
    }
    if (free_count == 3) return;
    const bool is_beyond = free_count == 2 && share[0] + share[1] > 1;
    const Index first = is_beyond ? near | free[0] | free[1] : near;
    corner = {first, first ^ free[0], first ^ free[1]};
    count = free_count + 1;
  }
};

VertexPairs exchanged(VertexPairs pairs) {
  std::swap(pairs.a, pairs.b);
  return pairs;
}

VertexPairs of_point_and_box(const PosedPolytope& point, const PosedPolytope& box) {
  const BoxFeature feature(point.vertex(0), box);
  VertexPairs pairs;
  for (std::size_t i = 0; i < feature.count; ++i) pairs.append(0, feature.corner[i]);
  return pairs;
}

}  // namespace

VertexPairs likely_features(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.vertex_count() <= 2 && b.vertex_count() <= 2) return of_segments(a, b);
  if (a.vertex_count() == 1 && is_box(b)) return of_point_and_box(a, b);
  if (b.vertex_count() == 1 && is_box(a)) return exchanged(of_point_and_box(b, a));
  return {};
}

}  // namespace toccata
