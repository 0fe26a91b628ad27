#include <cmath>

#include "methods/minkowski/sum_side.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The side of the core alone on which the point is.
Sign side_of_core(const MinkowskiSum::Parts& sum, const Vec3& point) {
  if (sum.dimension < 3) return exact_side_of_flat(sum, point);
  const Vec3 q = sum.frame.local(point);
  const double size = largest_magnitude(q) + sum.frame.reach;
  Sign side = Sign::negative;
  for (Index f = 0; f < sum.kinds.size(); ++f) {
    const SumPlane plane = plane_in_frame(sum, f);
    const double height = dot(plane.normal, q) - plane.height, error = plane.error * size;
    if (height > error) return Sign::positive;
    if (height < -error) continue;
    const Sign exact = exact_height(sum, f, point);
    if (exact == Sign::positive) return exact;
    if (exact == Sign::zero) side = Sign::zero;
  }
  return side;
}

}  // namespace

Sign with_radius(const MinkowskiSum::Parts& sum, Sign side, const Vec3& point) {
  if (!sum.rounded_core) return side;
  return side == Sign::positive ? compare_with_radius(sum, point) : Sign::negative;
}

Sign MinkowskiSum::side_of(const Vec3& point) const {
  if (!is_finite(point)) throw Error("a point whose side of a sum is asked for has a coordinate that is not finite");
  return with_radius(*parts_, side_of_core(*parts_, point), point);
}

}  // namespace toccata
