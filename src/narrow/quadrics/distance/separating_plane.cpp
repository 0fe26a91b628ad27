#include "narrow/quadrics/distance/separating_plane.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/shape_places.hpp"
#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata {
namespace {

using Normals = std::vector<IntegerVector>;

IntegerVector wide_vector(const Vec3& v) {
  const std::array<Vec3, 1> one{v};
  return scaled_wide(v, common_exponent(one));
}

IntegerVector wide_difference(const Vec3& p, const Vec3& q) {
  const std::array<Vec3, 2> both{p, q};
  const int unit = common_exponent(both);
  return scaled_wide(p, unit) - scaled_wide(q, unit);
}

/// Without what all coordinates are divisible by: signs along it are found with fewer digits.
IntegerVector shortened(IntegerVector v) {
  const WideInteger common = gcd(gcd(v[0], v[1]), v[2]);
  if (common <= 1) return v;
  for (WideInteger& x : v.along) x /= common;
  return v;
}

/// The normals of planes that touch the shape at the point, which is on its boundary.
Normals outward_normals(const PosedQuadric& shape, const Vec3& point) {
  const UnitPlace place = unit_place(exact_place(shape, point));
  Normals found;
  with_kind(shape.kind(), [&](auto kind) { kind.append_outward_normals(found, place); });
  return found;
}

void append_face_normals(Normals& found, const PosedPolytope& shape, const Vec3& point) {
  const HullTopology topology = shape.topology();
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Index start = topology.face_start[face];
    if (topology.face_start[face + 1] - start < 3) continue;
    const auto corner = [&](Index i) { return shape.vertex(topology.origin[start + i]); };
    const Vec3 p = corner(0), q = corner(1), r = corner(2), normal = cross(q - p, r - p), seen = point - p;
    // Certainly not in this plane, or of no use.
    const double off = 0x1p-30 * plain_length(normal) * (plain_length(seen) + plain_length(q - p));
    if (!(std::fabs(dot(normal, seen)) <= off)) continue;
    const IntegerVector across = cross(wide_difference(q, p), wide_difference(r, p));
    // A mirroring pose turns all faces round.
    const bool is_outward = dot(normal, middle_of(shape) - p) <= 0;
    found.push_back(is_outward ? across : -across);
  }
}

/// From the points of the core that may be the nearest.
void append_normals_of_offset(Normals& found, const PosedPolytope& shape, const Vec3& point) {
  Vec3 least = shape.vertex(0), greatest = least;
  const Index few = std::min<Index>(shape.vertex_count(), 8);
  for (Index i = 0; i < shape.vertex_count(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], shape.vertex(i)[axis]);
      greatest[axis] = std::max(greatest[axis], shape.vertex(i)[axis]);
    }
  Vec3 within;
  for (int axis = 0; axis < 3; ++axis) within[axis] = std::clamp(point[axis], least[axis], greatest[axis]);
  found.push_back(wide_difference(point, within));
  for (Index i = 0; i < few; ++i) found.push_back(wide_difference(point, shape.vertex(i)));
}

Normals outward_normals(const PosedPolytope& shape, const Vec3& point) {
  Normals found;
  if (shape.radius() > 0)
    append_normals_of_offset(found, shape, point);
  else
    append_face_normals(found, shape, point);
  return found;
}

template <class B>
class SeparatingPlane {
 public:
  SeparatingPlane(const PosedQuadric& a, const B& b, const Vec3& point) : a_(a), b_(b), point_(point) {}

  std::optional<Vec3> normal() {
    const Normals of_a = outward_normals(a_, point_), of_b = outward_normals(b_, point_);
    if (parts_one_of(of_a, 1) || parts_one_of(of_b, -1) || parts_along_axis()) return found_;
    if (parts(sum_of(of_a)) || parts(-sum_of(of_b))) return found_;
    const Vec3 between = middle_of(b_) - middle_of(a_);
    if (is_finite(between) && parts(wide_vector(between))) return found_;
    return {};
  }

 private:
  bool parts_one_of(const Normals& normals, int sign) {
    return std::any_of(normals.begin(), normals.end(),
                       [&](const IntegerVector& n) { return parts(sign > 0 ? n : -n); });
  }

  bool parts_along_axis() {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int sign : {1, -1}) {
        IntegerVector n;
        n[axis] = sign;
        if (parts(n)) return true;
      }
    return false;
  }

  static IntegerVector sum_of(const Normals& normals) {
    Vec3 sum;
    for (const IntegerVector& n : normals) sum = sum + rounded_unit(n);
    return wide_vector(sum);
  }

  static Vec3 rounded_unit(const IntegerVector& n) { return is_zero(n) ? Vec3{} : unit_or_zero(rounded_direction(n)); }

  /// A lies behind the plane and B before it.
  bool parts(const IntegerVector& along) {
    if (is_zero(along)) return false;
    const IntegerVector n = shortened(along);
    if (exact_sign_of_height(a_, point_, -n) == Sign::negative) return false;
    if (exact_sign_of_height(b_, point_, n) == Sign::negative) return false;
    found_ = rounded_unit(n);
    return true;
  }

  const PosedQuadric& a_;
  const B& b_;
  Vec3 point_;
  Vec3 found_;
};

}  // namespace

std::optional<Vec3> separating_normal(const PosedQuadric& a, const PosedQuadric& b, const Vec3& point) {
  return SeparatingPlane(a, b, point).normal();
}
std::optional<Vec3> separating_normal(const PosedQuadric& a, const PosedPolytope& b, const Vec3& point) {
  return SeparatingPlane(a, b, point).normal();
}

}  // namespace toccata
