#include "narrow/exact/feature_pair.hpp"

#include <algorithm>

#include "math/filter.hpp"

namespace toccata {
namespace {

bool certainly_below(const BoundedNumber& a, const BoundedNumber& b) { return (b - a).is_positive(); }

/// What decides whether the foot of the origin on the plane first + span(u, w) lies within the triangle or the
/// parallelogram: its shares of u and w, and the square of the normal, which stands for a share of 1.
struct PlaneShares {
  Filtered u, w, whole;
};

/// A product of cross products: each term meets four differences, two products, two of their differences, a product and
/// two sums, eleven roundings, for which 16 · 2^-53 is enough. Underflow is within the floors of `FilteredCross`.
Filtered filtered_dot(const FilteredCross& p, const FilteredCross& q) {
  return {dot(p.value, q.value), 0x1p-49 * (dot(p.magnitude, q.magnitude) + filter::floor)};
}

PlaneShares plane_shares(const Vec3& first, const Vec3& u, const Vec3& w) {
  const FilteredCross normal = filtered_cross(u, w);
  return {filtered_dot(filtered_cross(w, first), normal), filtered_dot(filtered_cross(first, u), normal),
          filtered_dot(normal, normal)};
}

Filtered less(const Filtered& a, const Filtered& b) {
  // Twice what the numbers are off by is enough for the rounding of their difference, too.
  return {a.value - b.value, 2 * (a.error + b.error)};
}

}  // namespace

FeaturePair::FeaturePair(const PosedPolytope& a, const PosedPolytope& b, const NearestFeatures& features)
    : features_(features), first_a_(a.vertex(features.a[0])), first_b_(b.vertex(features.b[0])) {
  for (std::size_t i = 1; i < features.count_a; ++i) edge_[edges_++] = {a.vertex(features.a[i]), first_a_};
  for (std::size_t i = 1; i < features.count_b; ++i) edge_[edges_++] = {first_b_, b.vertex(features.b[i])};
}

bool FeaturePair::solve() {
  const BoundedVector first = bounded_difference(first_a_, first_b_);
  if (edges_ == 0) return at_vertices(first);
  return edges_ == 1 ? on_edge(first) : on_plane(first);
}

BoundedVector FeaturePair::on_a() const {
  if (features_.count_a == 1) return exactly(first_a_);
  if (features_.count_b == 1) return exactly(first_b_) + difference_;
  return exactly(first_a_) + share_ * along(0);
}

BoundedVector FeaturePair::on_b() const {
  if (features_.count_b == 1) return exactly(first_b_);
  return (features_.count_a == 1 ? exactly(first_a_) : on_a()) - difference_;
}

BoundedVector FeaturePair::along(std::size_t edge) const {
  return bounded_difference(edge_[edge].head, edge_[edge].tail);
}

bool FeaturePair::at_vertices(const BoundedVector& first) {
  difference_ = first;
  distance_ = length(first);
  return distance_.is_positive();
}

bool FeaturePair::on_edge(const BoundedVector& first) {
  const BoundedVector edge = along(0);
  const BoundedNumber squared = dot(edge, edge), forth = -dot(first, edge);
  if (!forth.is_positive() || !certainly_below(forth, squared)) return false;
  share_ = forth / squared;
  difference_ = first + share_ * edge;
  distance_ = length(difference_);
  return distance_.is_positive();
}

bool FeaturePair::on_plane(const BoundedVector& first) {
  const Inside inside = likely_inside();
  if (inside == Inside::no) return false;
  const BoundedVector u = along(0), w = along(1), normal = cross(u, w);
  const BoundedNumber squared = dot(normal, normal), height = dot(normal, first);
  if (!height.is_positive() && !height.is_negative()) return false;
  if (inside == Inside::unknown && !certainly_inside(first, normal, squared)) return false;
  side_ = height.is_positive() ? Sign::positive : Sign::negative;
  difference_ = (height / squared) * normal;
  distance_ = (height.is_positive() ? height : -height) / square_root(squared);
  if (features_.count_a == 2) share_ = dot(cross(w, first), normal) / squared;
  return distance_.is_positive();
}

FeaturePair::Inside FeaturePair::likely_inside() const {
  const auto edge = [this](std::size_t i) { return edge_[i].head - edge_[i].tail; };
  const PlaneShares share = plane_shares(first_a_ - first_b_, edge(0), edge(1));
  const Filtered not_u = less(share.whole, share.u);
  const bool edges = features_.count_a == 2;
  const std::array<Filtered, 4> conditions = {share.u, share.w, edges ? not_u : less(not_u, share.w),
                                              edges ? less(share.whole, share.w) : share.u};
  if (std::ranges::all_of(conditions, &Filtered::is_positive)) return Inside::yes;
  return std::ranges::any_of(conditions, &Filtered::is_negative) ? Inside::no : Inside::unknown;
}

bool FeaturePair::certainly_inside(const BoundedVector& first, const BoundedVector& normal,
                                   const BoundedNumber& whole) const {
  const BoundedNumber u = dot(cross(along(1), first), normal), w = dot(cross(first, along(0)), normal);
  if (!u.is_positive() || !w.is_positive()) return false;
  if (features_.count_a == 2) return certainly_below(u, whole) && certainly_below(w, whole);
  return certainly_below(u + w, whole);
}

}  // namespace toccata
