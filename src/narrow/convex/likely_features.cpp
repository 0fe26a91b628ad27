#include "narrow/convex/likely_features.hpp"

#include <array>

#include "narrow/boxes/box_axes.hpp"
#include "narrow/exact/feature_pair.hpp"
#include "narrow/primitives/closed_forms.hpp"

namespace toccata {
namespace {

Vec3 edge_of(const PosedPolytope& core) { return core.vertex(core.vertex_count() - 1) - core.vertex(0); }

/// The corners of one shape's feature, as NearestFeatures has them.
using CornersOfFace = std::array<Index, 3>;

/// Sets the vertices of a point or a segment that hold the point at the share of its edge. Returns how many they are.
std::size_t set_ends(double share, CornersOfFace& ends) {
  const bool is_between = share > 0 && share < 1;
  ends = {share >= 1 ? 1U : 0U, is_between ? 1U : 0U, 0};
  return is_between ? 2 : 1;
}

/// The features of points and segments: by the formula, without a search.
NearestFeatures of_segments(const PosedPolytope& a, const PosedPolytope& b) {
  const SegmentWeights at = nearest_weights_of_segments(a.vertex(0) - b.vertex(0), edge_of(a), edge_of(b));
  NearestFeatures features;
  features.count_a = set_ends(at.s, features.a);
  features.count_b = set_ends(at.t, features.b);
  return features;
}

/// Sets the corners of a box beside a point: the corner, two ends of an edge, or three corners of a face around the
/// foot. None where the point is inside.
std::size_t set_corners(const Vec3& point, const PosedPolytope& box, CornersOfFace& corners) {
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
  if (free_count == 3) return 0;
  const bool is_beyond = free_count == 2 && share[0] + share[1] > 1;
  const Index first = is_beyond ? near | free[0] | free[1] : near;
  corners = {first, first ^ free[0], first ^ free[1]};
  return free_count + 1;
}

}  // namespace

VertexPairs likely_features(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.vertex_count() <= 2 && b.vertex_count() <= 2) return pairs_of(of_segments(a, b));
  NearestFeatures features;
  features.count_a = features.count_b = 1;
  if (a.vertex_count() == 1 && is_box(b))
    features.count_b = set_corners(a.vertex(0), b, features.b);
  else if (b.vertex_count() == 1 && is_box(a))
    features.count_a = set_corners(b.vertex(0), a, features.a);
  else
    return {};
  return features.count_a > 0 && features.count_b > 0 ? pairs_of(features) : VertexPairs{};
}

}  // namespace toccata
