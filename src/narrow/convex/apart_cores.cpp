#include "narrow/convex/apart_cores.hpp"

#include <limits>
#include <span>

#include "narrow/convex/gjk.hpp"
#include "narrow/convex/likely_features.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/nearest_certificate.hpp"

namespace toccata {
namespace {

/// The nearest features, if doubles have found and double-words proved them.
std::optional<CertainNearest> nearest_of_apart_cores(const PosedPolytope& a, const PosedPolytope& b) {
  const SupportKernels kernels = support_kernels();
  const SupportSearch search_a(a, kernels), search_b(b, kernels);
  if (const VertexPairs likely = likely_features(a, b); likely.size > 0)
    if (auto found = certain_nearest(search_a, search_b, likely)) return found;
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
