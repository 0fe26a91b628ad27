#include "narrow/triangles/ray_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/bounded_number.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

// Signs of volumes tell whether the ray's line passes through a triangle a, b, c, seen from the ray's origin:
// det(m, b, c), det(m, c, a) and det(m, a, b) are all positive or all negative where it passes through the inside; two
// of different signs prove that it misses, and zeros among others that it passes through the rim (M. Segura, F. Feito,
// "Algorithms to test ray-triangle intersection: comparative study", 2001). All three are zero for a line in the
// triangle's plane.
//
// What is rounded: let M be the greatest coordinate of a, b, c and m̂ that of m, u = 2^-53. Coordinates of a, b, c are
// off by u M, those of b × c by 8 u M², a determinant by 40 u m̂ M², all to first order. Nothing underflows by more than
// the bounds while all sizes are within 2^±200.
constexpr double unit = 0x1p-53;

/// The interval's greatest half width, of the whole way.
constexpr double most_off = 0x1p-43;

enum class Line { unknown, misses, passes };

double greatest_of_three(double a, double b, double c) { return std::max(std::max(a, b), c); }
double least_of_three(double a, double b, double c) { return std::min(std::min(a, b), c); }
inline double greatest_of(const Vec3& v) { return greatest_of_three(std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)); }

bool is_of_plain_size(double size) { return size > 0x1p-200 && size < 0x1p200; }

/// A triangle from the ray's origin.
struct Seen {
  Seen(const PreparedRay& ray, const Triangle& target)
      : a(target[0] - ray.origin),
        b(target[1] - ray.origin),
        c(target[2] - ray.origin),
        size(greatest_of_three(greatest_of(a), greatest_of(b), greatest_of(c))) {}
  Vec3 a, b, c;
  double size;
};

Line line_in_doubles(const PreparedRay& ray, const Seen& seen) {
  if (!is_of_plain_size(seen.size) || !is_of_plain_size(ray.largest)) return Line::unknown;
  const double bound = 64 * unit * ray.largest * seen.size * seen.size;
  const double u = dot(ray.motion, cross(seen.b, seen.c)), v = dot(ray.motion, cross(seen.c, seen.a)),
               w = dot(ray.motion, cross(seen.a, seen.b));
  const double low = least_of_three(u, v, w), high = greatest_of_three(u, v, w);
  if (low < -bound && high > bound) return Line::misses;
  return low > bound || high < -bound ? Line::passes : Line::unknown;
}

Line line_by_signs(const PreparedRay& ray, const Triangle& target) {
  bool left = false, right = false;
  for (int i = 0; i < 3; ++i) {
    const Difference from{target[i], ray.origin}, to{target[(i + 1) % 3], ray.origin};
    const Sign turn = triple_product_sign(from, to, {ray.motion, {}});
    left |= turn == Sign::positive;
    right |= turn == Sign::negative;
  }
  if (left && right) return Line::misses;
  return left || right ? Line::passes : Line::unknown;
}

/// When a line that passes through the triangle does so.
struct Passing {
  double time = 0;
  double off = HUGE_VAL;  ///< the exact time is within that of it; NaN where nothing is known
};

/// (a · n) / (m · n), n being the cross product of two edges. With S the greatest coordinate of an edge, n is off by
/// 8 u S², so m · n by 40 u m̂ S² and a · n by 40 u M S².
Passing passing_in_doubles(const PreparedRay& ray, const Triangle& target, const Seen& seen) {
  const Vec3 e = target[1] - target[0], f = target[2] - target[0];
  const Vec3 normal = cross(e, f);
  const double size = std::max(greatest_of(e), greatest_of(f));
  if (!is_of_plain_size(size) || !is_of_plain_size(seen.size) || !is_of_plain_size(ray.largest)) return {};
  const double bound = 64 * unit * size * size;
  const double time = dot(seen.a, normal) / dot(ray.motion, normal);
  const double sure_speed = std::fabs(dot(ray.motion, normal)) - bound * ray.largest;
  if (!(sure_speed > 0)) return {};
  return {time, bound * (seen.size + std::fabs(time) * ray.largest) / sure_speed + 4 * unit * std::fabs(time)};
}

Passing passing_in_bounded_numbers(const PreparedRay& ray, const Triangle& target) {
  const BoundedVector a = bounded_difference(target[0], ray.origin);
  const BoundedVector normal =
      cross(bounded_difference(target[1], target[0]), bounded_difference(target[2], target[0]));
  const BoundedNumber time = dot(normal, a) / dot(normal, exactly(ray.motion));
  const double high = time.value.high;
  return {high, distance_from_high(time) + 4 * unit * std::fabs(high)};
}

bool is_settled(const Passing& passing) {
  const double lower = passing.time - passing.off, upper = passing.time + passing.off;
  return upper < 0 || lower > 1 || (passing.off <= most_off && lower > 0 && upper < 1);
}

/// Nothing where only exact arithmetic can tell.
std::optional<RayTime> certain_time_of_passing(const PreparedRay& ray, const Triangle& target, const Seen& seen) {
  Passing passing = passing_in_doubles(ray, target, seen);
  if (!is_settled(passing)) passing = passing_in_bounded_numbers(ray, target);
  if (!is_settled(passing)) return {};
  if (passing.time < 0 || passing.time > 1) return RayTime{};
  return RayTime{true, passing.time - passing.off, passing.time + passing.off};
}

std::optional<RayTime> certain_time(const PreparedRay& ray, const Triangle& target) {
  const Seen seen(ray, target);
  Line line = line_in_doubles(ray, seen);
  if (line == Line::unknown) line = line_by_signs(ray, target);
  if (line == Line::misses) return RayTime{};
  if (line == Line::unknown) return {};
  return certain_time_of_passing(ray, target, seen);
}

RayTime exact_time(const PreparedRay& ray, const Triangle& target) {
  const std::optional<Cast> cast = cast_ray(ray.origin, ray.motion, PosedPolytope(target));
  if (!cast) return {false, 0, 0, true};
  return {true, cast->lower, cast->upper, true};
}

/// The unit normal of a triangle with area and edges that are neither tiny nor huge.
Vec3 unit_normal(const Triangle& t) {
  const Vec3 e = t[1] - t[0], f = t[2] - t[0];
  Vec3 normal = cross(e, f);
  const bool cancels = dot(normal, normal) < 0x1p-40 * (dot(e, e) * dot(f, f));
  if (cancels) normal = high_parts(cross(bounded_difference(t[1], t[0]), bounded_difference(t[2], t[0])));
  const double largest = greatest_of(normal);
  normal = {normal.x / largest, normal.y / largest, normal.z / largest};
  return (1 / std::sqrt(dot(normal, normal))) * normal;
}

}  // namespace

PreparedRay::PreparedRay(const Vec3& from, const Vec3& along)
    : origin(from), motion(along), largest(greatest_of(along)) {
  if (!is_finite(from)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (!is_finite(along)) throw Error("a ray: its motion has a coordinate that is not finite");
  if (along == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
}

RayTime ray_time(const PreparedRay& ray, const Triangle& target) {
  const auto certain = certain_time(ray, target);
  return certain ? *certain : exact_time(ray, target);
}

RayTime ray_time_of_passing(const PreparedRay& ray, const Triangle& target) {
  const auto certain = certain_time_of_passing(ray, target, Seen(ray, target));
  return certain ? *certain : exact_time(ray, target);
}

Cast ray_hit(const PreparedRay& ray, const Triangle& target, const RayTime& time) {
  if (time.exact) return *cast_ray(ray.origin, ray.motion, PosedPolytope(target));
  Cast cast;
  cast.lower = time.lower;
  cast.upper = time.upper;
  cast.point = ray.origin + (0.5 * (time.lower + time.upper)) * ray.motion;
  const Vec3 normal = unit_normal(target);
  cast.normal = dot(normal, ray.motion) > 0 ? -normal : normal;
  return cast;
}

}  // namespace toccata
