#include "narrow/exact/intersection_certificate.hpp"

#include <algorithm>

#include "math/filter.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

BoundedNumber volume(const BoundedVector& p, const BoundedVector& q, const BoundedVector& r) {
  return dot(cross(p, q), r);
}

}  // namespace

bool contains_origin(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex) {
  if (simplex.size != 4) return false;
  std::array<Difference, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = {a.vertex(simplex.a[i]), b.vertex(simplex.b[i])};
  const std::array<Sign, 4> weight = {triple_product_sign(p[1], p[2], p[3]), -triple_product_sign(p[0], p[2], p[3]),
                                      triple_product_sign(p[0], p[1], p[3]), -triple_product_sign(p[0], p[1], p[2])};
  const auto has = [&weight](Sign sign) { return std::find(weight.begin(), weight.end(), sign) != weight.end(); };
  return has(Sign::positive) != has(Sign::negative);
}

BoundedVector common_point(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex) {
  std::array<Vec3, 4> on_a;
  std::array<BoundedVector, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    on_a[i] = a.vertex(simplex.a[i]);
    p[i] = bounded_difference(on_a[i], b.vertex(simplex.b[i]));
  }
  const std::array<BoundedNumber, 4> weight = {volume(p[1], p[2], p[3]), -volume(p[0], p[2], p[3]),
                                               volume(p[0], p[1], p[3]), -volume(p[0], p[1], p[2])};
  const BoundedNumber total = (weight[0] + weight[1]) + (weight[2] + weight[3]);
  BoundedVector sum = weight[0] * exactly(on_a[0]);
  for (std::size_t i = 1; i < 4; ++i) sum = sum + weight[i] * exactly(on_a[i]);
  return {sum[0] / total, sum[1] / total, sum[2] / total};
}

// Weights w that are off by e place the point off by the sum of the e (a − point) over the sum of the w, and no vertex
// is farther from the point than twice the greatest coordinate, in each coordinate. Quotients and sums round by ten
// units of the greatest coordinate.
std::optional<Vec3> plain_common_point(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex) {
  constexpr double most_off = 0x1p-43;
  if (simplex.size != 4) return {};
  std::array<Vec3, 4> on_a, p;
  for (std::size_t i = 0; i < 4; ++i) {
    on_a[i] = a.vertex(simplex.a[i]);
    p[i] = on_a[i] - b.vertex(simplex.b[i]);
  }
  const FilteredCross first = filtered_cross(p[0], p[1]), last = filtered_cross(p[2], p[3]);
  const std::array<Filtered, 4> weight = {filtered_triple_product(last, p[1]), filtered_triple_product(last, -p[0]),
                                          filtered_triple_product(first, p[3]), filtered_triple_product(first, -p[2])};
  const bool are_positive =
      std::all_of(weight.begin(), weight.end(), [](const Filtered& w) { return w.is_positive(); });
  const bool are_negative =
      std::all_of(weight.begin(), weight.end(), [](const Filtered& w) { return w.is_negative(); });
  const double total = (weight[0].value + weight[1].value) + (weight[2].value + weight[3].value);
  const double off = (weight[0].error + weight[1].error) + (weight[2].error + weight[3].error);
  if (!(are_positive || are_negative) || !(off < most_off * std::fabs(total))) return {};
  Vec3 point;
  for (std::size_t i = 0; i < 4; ++i) point = point + (weight[i].value / total) * on_a[i];
  return point;
}

}  // namespace toccata
