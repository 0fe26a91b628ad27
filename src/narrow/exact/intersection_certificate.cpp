#include "narrow/exact/intersection_certificate.hpp"

#include <algorithm>

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

}  // namespace toccata
