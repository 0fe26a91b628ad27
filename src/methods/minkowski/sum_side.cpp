#include "methods/minkowski/sum_side.hpp"

#include "math/filter.hpp"
#include "math/wide_integer.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

/// Coordinates over the unit that all vertices of the sum and a point have in common.
class ExactSum {
 public:
  ExactSum(const SumParts& sum, const Vec3& point) : sum_(sum) {
    exponent_ = std::min(
        {common_exponent(sum.a.points()), common_exponent(sum.b.points()), common_exponent(std::span(&point, 1))});
    point_ = scaled_wide(point, exponent_);
  }

  [[nodiscard]] const IntegerVector& point() const { return point_; }
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] IntegerVector vertex(Index i) const {
    return scaled_wide(sum_.a.points()[sum_.vertices[i].on_a], exponent_) +
           scaled_wide(sum_.b.points()[sum_.vertices[i].on_b], exponent_);
  }
  [[nodiscard]] IntegerVector normal(Index face) const {
    return cross(vector(sum_.planes[face][0]), vector(sum_.planes[face][1]));
  }

 private:
  [[nodiscard]] IntegerVector vector(const PlaneVector& v) const {
    const Difference d = sum_.difference_of(v);
    return scaled_wide(d.head, exponent_) - scaled_wide(d.tail, exponent_);
  }

  const SumParts& sum_;
  int exponent_ = 0;
  IntegerVector point_;
};

/// A point and a segment have no facets.
Sign side_of_line(const ExactSum& exact, Index vertices) {
  const IntegerVector start = exact.vertex(0), to_point = exact.point() - start;
  if (vertices == 1) return is_zero(to_point) ? Sign::zero : Sign::positive;
  const IntegerVector along = exact.vertex(1) - start;
  if (!is_zero(cross(along, to_point))) return Sign::positive;
  const WideInteger height = dot(along, to_point);
  return height < 0 || height > dot(along, along) ? Sign::positive : Sign::zero;
}

/// A squared distance, numerator / denominator.
struct Square {
  WideInteger numerator, denominator;
};

/// The point's foot on the edge, if it lies within.
std::optional<Square> square_from_edge(const IntegerVector& from, const IntegerVector& to, const IntegerVector& point) {
  const IntegerVector along = to - from, to_point = point - from;
  const WideInteger height = dot(along, to_point), length = dot(along, along);
  if (height <= 0 || height >= length) return {};
  return Square{dot(to_point, to_point) * length - height * height, length};
}

}  // namespace

SumPlane plane_in_frame(const SumParts& sum, Index face) {
  const SumFrame& frame = sum.frame;
  const FilteredCross n = filtered_cross(frame.local(sum.difference_of(sum.planes[face][0])),
                                         frame.local(sum.difference_of(sum.planes[face][1])));
  const SumVertex& anchor = sum.vertices[sum.origin[sum.face_start[face]]];
  const double height = dot(n.value, frame.local(sum.a.points()[anchor.on_a], sum.b.points()[anchor.on_b]));
  // With S the sum of the products' magnitudes, each of the normal's components is off by at most 2^-50 of its part of
  // S, points in the frame by 2^-50 (|q| + reach), and the dot products round thrice.
  return {n.value, height, 0x1p-46 * sum_of_magnitudes(n.magnitude)};
}

Sign exact_height(const SumParts& sum, Index face, const Vec3& point) {
  const Difference u = sum.difference_of(sum.planes[face][0]), v = sum.difference_of(sum.planes[face][1]);
  const SumVertex& anchor = sum.vertices[sum.origin[sum.face_start[face]]];
  const Vec3 &a = sum.a.points()[anchor.on_a], &b = sum.b.points()[anchor.on_b];
  // Where point − a is a double nothing longer is needed.
  const TwoPart x = two_difference(point.x, a.x), y = two_difference(point.y, a.y), z = two_difference(point.z, a.z);
  if (x.low == 0 && y.low == 0 && z.low == 0) return triple_product_sign(u, v, {{x.high, y.high, z.high}, b});
  const ExactSum exact(sum, point);
  return sign_of(dot(exact.normal(face), exact.point() - exact.vertex(sum.origin[sum.face_start[face]])));
}

Sign exact_side_of_flat(const SumParts& sum, const Vec3& point) {
  const ExactSum exact(sum, point);
  if (sum.dimension < 2) return side_of_line(exact, static_cast<Index>(sum.vertices.size()));
  const IntegerVector normal = exact.normal(0);
  if (dot(normal, exact.point() - exact.vertex(sum.origin[0])) != 0) return Sign::positive;
  const HullTopology topology = sum.topology();
  for (Index h = topology.face_start[0]; h < topology.face_start[1]; ++h) {
    const IntegerVector from = exact.vertex(topology.origin[h]), along = exact.vertex(topology.target(h)) - from;
    if (dot(cross(along, normal), exact.point() - from) > 0) return Sign::positive;
  }
  return Sign::zero;
}

// Each square is that of the distance from some point of the core, and the nearest one is among them.
Sign compare_exactly_with_radius(const SumParts& sum, const Vec3& point) {
  const ExactSum exact(sum, point);
  const int unit = std::min({exact.exponent(), common_exponent({sum.radius_a}), common_exponent({sum.radius_b})});
  const WideInteger radius = scaled_wide(sum.radius_a, unit) + scaled_wide(sum.radius_b, unit);
  Sign least = Sign::positive;
  const auto take = [&](const Square& square) {
    const auto shift = static_cast<unsigned>(2 * (exact.exponent() - unit));
    const Sign sign = sign_of((square.numerator << shift) - radius * radius * square.denominator);
    least = std::min(least, sign);
  };
  const HullTopology topology = sum.topology();
  for (Index i = 0; i < sum.vertices.size(); ++i) {
    const IntegerVector d = exact.point() - exact.vertex(i);
    take({dot(d, d), 1});
  }
  for (Index h = 0; h < topology.origin.size(); ++h) {
    if (h > topology.twin[h]) continue;
    const auto square =
        square_from_edge(exact.vertex(topology.origin[h]), exact.vertex(topology.target(h)), exact.point());
    if (square) take(*square);
  }
  for (Index f = 0; sum.dimension > 1 && f < topology.face_count(); ++f) {
    const IntegerVector normal = exact.normal(f);
    bool within = true;
    for (Index h = topology.face_start[f]; within && h < topology.face_start[f + 1]; ++h) {
      const IntegerVector from = exact.vertex(topology.origin[h]), along = exact.vertex(topology.target(h)) - from;
      within = dot(cross(along, normal), exact.point() - from) <= 0;
    }
    const WideInteger height = dot(normal, exact.point() - exact.vertex(topology.origin[topology.face_start[f]]));
    // From behind, the foot on a face may be outside of the core's boundary only where the point is within.
    if (within && height >= 0) take({height * height, dot(normal, normal)});
  }
  return least;
}

Sign compare_with_radius(const SumParts& sum, const Vec3& point) {
  const Distance distance_of_rounded = distance(PosedPolytope(Point{point}), PosedPolytope(*sum.rounded_core));
  double largest = 0;
  for (Index i = 0; i < sum.rounded_core->vertex_count(); ++i)
    largest = std::max(largest, largest_magnitude(sum.rounded_core->vertex(i)));
  // Each vertex of the rounded core is off by half a last place along every axis; radii by 2^-53 of their sum.
  const double radius = sum.radius_a + sum.radius_b, off = 0x1p-51 * (largest + radius) + 0x1p-1070;
  if (distance_of_rounded.lower - radius > off) return Sign::positive;
  if (distance_of_rounded.upper - radius < -off) return Sign::negative;
  return compare_exactly_with_radius(sum, point);
}

}  // namespace toccata
