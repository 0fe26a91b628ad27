#include "query/distance/least_distance.hpp"

#include <variant>

#include "narrow/exact/within.hpp"
#include "query/keep_least.hpp"
#include "query/nearest/nearest_triangles.hpp"
#include "query/numbered.hpp"

namespace toccata {

double LeastDistance::limit(double before) const {
  if (!least_) return before;
  // Parts that meet have boxes that do, and of those the first come first. Else the lower ends of intervals count too.
  return least_->upper > 0 ? limit_from(least_->upper) : -1;
}

bool LeastDistance::is_farther(const PosedPart& a, const PosedPart& b) const {
  constexpr Index few_vertices = 16;  // their distance is as quick
  const auto* convex_a = std::get_if<PosedPolytope>(&a.shape);
  const auto* convex_b = std::get_if<PosedPolytope>(&b.shape);
  return least_ && convex_a && convex_b && convex_a->vertex_count() + convex_b->vertex_count() > few_vertices &&
         certainly_beyond(*convex_a, *convex_b, limit_from(least_->upper), &scratch_.convex);
}

void LeastDistance::keep(const Distance& found, const PosedPart& a, const PosedPart& b) {
  const std::pair parts{&a, &b};
  const bool is_earlier = least_ && found.upper == least_->upper && parts < parts_;
  if (!least_ || found.upper < least_->upper || is_earlier) parts_ = parts;
  if (is_earlier) {
    std::optional<Distance> first = numbered(found, a, b);
    keep_least(first, *least_);
    least_ = first;
  } else {
    keep_least(least_, numbered(found, a, b));
  }
}

}  // namespace toccata
