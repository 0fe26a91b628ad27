#include "narrow/convex/apart_cores.hpp"

#include <array>
#include <limits>
#include <span>

#include "narrow/convex/gjk.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/nearest_certificate.hpp"
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
VertexPairs likely_features_of_segments(const PosedPolytope& a, const PosedPolytope& b) {
  const SegmentWeights at = nearest_weights_of_segments(a.vertex(0) - b.vertex(0), edge_of(a), edge_of(b));
  const SegmentFeature of_a(at.s), of_b(at.t);
  VertexPairs pairs;
  for (std::size_t i = 0; i < of_a.count; ++i) pairs.append(of_a.vertex[i], of_b.vertex[0]);
  for (std::size_t i = 1; i < of_b.count; ++i) pairs.append(of_a.vertex[0], of_b.vertex[i]);
  return pairs;
}

/// The nearest features, if doubles have found and double-words proved them.
std::optional<CertainNearest> nearest_of_apart_cores(const PosedPolytope& a, const PosedPolytope& b) {
  const SupportKernels kernels = support_kernels();
  const SupportSearch search_a(a, kernels), search_b(b, kernels);
  if (a.vertex_count() <= 2 && b.vertex_count() <= 2)
    if (auto found = certain_nearest(search_a, search_b, likely_features_of_segments(a, b))) return found;
  const GjkEnd end = search_nearest(search_a, search_b, {}, {std::numeric_limits<double>::quiet_NaN()});
  if (end.inside) return {};
  if (std::optional<CertainNearest> found = certain_nearest(search_a, search_b, end.simplex.pairs)) return found;
  return certain_nearest_along(search_a, search_b, end.nearest);
}

ExactNearest exact_nearest_from(const PosedPolytope& a, const PosedPolytope& b, const CertainNearest& found) {
  if (found.unique()) return exact_nearest(a, b, found.pairs);
  return exact_nearest_of_faces(a, b, found.pairs, std::span(found.face_a.vertex).first(found.face_a.count),
                                std::span(found.face_b.vertex).first(found.face_b.count));
}

}  // namespace

std::optional<ConvexSeparation> part_apart_cores(const PosedPolytope& a, const PosedPolytope& b) {
  const std::optional<CertainNearest> found = nearest_of_apart_cores(a, b);
  if (!found) return {};
  if (found->unique())
    if (const auto depth = rounded_depth(*found, a.radius(), b.radius())) return ConvexSeparation{*depth, found->pairs};
  const ExactNearest nearest = exact_nearest_from(a, b, *found);
  return ConvexSeparation{rounded_depth(nearest, a.radius(), b.radius(), {}), nearest.simplex};
}

}  // namespace toccata
