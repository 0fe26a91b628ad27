#include "narrow/convex/swept_overlap.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

#include "narrow/exact/exact_simplex.hpp"
#include "narrow/exact/exact_support.hpp"

namespace toccata {
namespace {

/// A unit that all of them are whole multiples of; of zeros any is.
int unit_of(std::initializer_list<double> values) {
  const int exponent = common_exponent(values);
  return exponent == std::numeric_limits<int>::max() ? 0 : exponent;
}

/// Vertices of A are numbered twice: 2 i where it starts, 2 i + 1 where it ends.
class SweptPair {
 public:
  SweptPair(const PosedPolytope& a, const Vec3& motion, double until, const PosedPolytope& b) : a_(a), b_(b) {
    const BinaryFraction time = binary_fraction(until);
    const int unit = unit_of({motion.x, motion.y, motion.z});
    shift_ = WideInteger(time.mantissa) * scaled_wide(motion, unit);
    shift_exponent_ = time.exponent + unit;
    radius_exponent_ = unit_of({a.radius(), b.radius()});
    reach_ = scaled_wide(a.radius(), radius_exponent_) + scaled_wide(b.radius(), radius_exponent_);
  }

  [[nodiscard]] IntegerSimplex simplex_of(const VertexPairs& pairs) const {
    IntegerSimplex simplex;
    simplex.pairs = pairs;
    std::array<Vec3, 8> vertices;
    for (std::size_t i = 0; i < pairs.size; ++i) {
      vertices[2 * i] = a_.vertex(pairs.a[i] / 2);
      vertices[2 * i + 1] = b_.vertex(pairs.b[i]);
    }
    simplex.exponent = std::min(common_exponent({vertices.data(), 2 * pairs.size}), shift_exponent_);
    const WideInteger scale = WideInteger(1) << static_cast<unsigned>(shift_exponent_ - simplex.exponent);
    for (std::size_t i = 0; i < pairs.size; ++i) {
      simplex.a[i] = scaled_wide(vertices[2 * i], simplex.exponent);
      if (pairs.a[i] % 2 == 1) simplex.a[i] = simplex.a[i] + scale * shift_;
      simplex.point[i] = simplex.a[i] - scaled_wide(vertices[2 * i + 1], simplex.exponent);
    }
    return simplex;
  }

  /// The pair that lies lowest along a direction.
  [[nodiscard]] VertexPairs with_lowest(VertexPairs pairs, const IntegerVector& direction) const {
    const Index of_a = least_vertices(a_, direction).front(), of_b = least_vertices(b_, -direction).front();
    pairs.append(2 * of_a + (dot(direction, shift_) < 0 ? 1 : 0), of_b);
    return pairs;
  }

  /// The simplex's nearest point is not farther from the origin than the radii reach.
  [[nodiscard]] bool is_within_reach(const IntegerSimplex& simplex, const SimplexNearest& nearest) const {
    IntegerVector foot;
    for (std::size_t i = 0; i < simplex.pairs.size; ++i) foot = foot + nearest.weight[i] * simplex.point[i];
    // The foot is foot / total; its product with any point of the simplex's hyperplane is its square.
    const WideInteger squared = dot(foot, simplex.point[0]);
    const int unit = std::min(simplex.exponent, radius_exponent_);
    const WideInteger core = squared << static_cast<unsigned>(2 * (simplex.exponent - unit));
    const WideInteger reach = reach_ << static_cast<unsigned>(radius_exponent_ - unit);
    return core <= nearest.total * reach * reach;
  }

 private:
  const PosedPolytope& a_;
  const PosedPolytope& b_;
  IntegerVector shift_;  // in 2^shift_exponent_, like the next ones
  int shift_exponent_ = 0;
  WideInteger reach_;
  int radius_exponent_ = 0;
};

}  // namespace

bool swept_meets(const PosedPolytope& a, const Vec3& motion, double until, const PosedPolytope& b) {
  const SweptPair pair(a, motion, until, b);
  VertexPairs pairs;
  pairs.append(0, 0);
  while (true) {
    const IntegerSimplex simplex = pair.simplex_of(pairs);
    const SimplexNearest nearest = nearest_of(simplex);
    if (is_zero(nearest.direction) || pair.is_within_reach(simplex, nearest)) return true;
    const IntegerSimplex more = pair.simplex_of(pair.with_lowest(pairs, nearest.direction));
    const IntegerVector &first = more.point[0], &last = more.point[more.pairs.size - 1];
    if (dot(nearest.direction, last) >= dot(nearest.direction, first)) return false;
    pairs = needed_pairs(more);
  }
}

}  // namespace toccata
