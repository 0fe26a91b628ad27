#include "narrow/pose_checks.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "math/exact.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double deformation_limit = 0x1p-10;

// Where no number of R is above 1.01, each computed entry of RᵀR − I is off by less than 2^-49 (three products of sum
// at most 3.1, four roundings of 2^-53 each, and underflow), and a sum of three of them by less than 2^-47.
constexpr double filter_margin = 0x1p-46;
constexpr double largest_of_filter = 1.01;

/// The largest row sum of |RᵀR − I|, rounded.
double deformation(const Mat3& m) {
  const Vec3 x = m.column(0), y = m.column(1), z = m.column(2);
  const double xy = std::fabs(dot(x, y)), yz = std::fabs(dot(y, z)), zx = std::fabs(dot(z, x));
  const double of_x = (std::fabs(dot(x, x) - 1) + xy) + zx, of_y = (std::fabs(dot(y, y) - 1) + xy) + yz,
               of_z = (std::fabs(dot(z, z) - 1) + yz) + zx;
  return std::fmax(std::fmax(of_x, of_y), of_z);
}

bool deforms_exactly(const Mat3& linear) {
  for (int row = 0; row < 3; ++row) {
    Rational sum = 0;
    for (int other = 0; other < 3; ++other) {
      const Rational product = dot(to_rational(linear.column(row)), to_rational(linear.column(other)));
      sum += abs(Rational(product - (row == other ? 1 : 0)));
    }
    if (sum > to_rational(deformation_limit)) return true;
  }
  return false;
}

}  // namespace

bool deforms(const Mat3& linear) {
  // A column with a number above this has a squared length of more than 1.02.
  for (const Vec3& r : linear.row)
    if (std::fmax(std::fmax(std::fabs(r.x), std::fabs(r.y)), std::fabs(r.z)) > largest_of_filter) return true;
  const double largest_sum = deformation(linear);
  if (largest_sum < deformation_limit - filter_margin) return false;
  if (largest_sum > deformation_limit + filter_margin) return true;
  return deforms_exactly(linear);
}

void require_finite(const Pose& pose, std::string_view who) {
  if (is_finite(pose)) return;
  throw Error(fmt::format("{}: the pose ({}) has a number that is not finite", who, fmt::join(pose.numbers(), ", ")));
}

void require_undeformed(const Pose& pose, std::string_view who) {
  if (!deforms(pose.linear)) return;
  throw Error(fmt::format(
      "{}: the pose ({}) deforms it: the largest row sum of |RᵀR − I| is {:.3g}, and at most 2⁻¹⁰ = {} is allowed; "
      "make a rotation of what drifted (Pose::nearest_rigid), put a scale into the numbers of the shape, or use an "
      "ellipsoid",
      who, fmt::join(pose.numbers(), ", "), deformation(pose.linear), deformation_limit));
}

void require_regular(const Pose& pose, std::string_view who) {
  if (!is_singular(pose.linear)) return;
  throw Error(
      fmt::format("{}: the pose ({}) is singular (its 3×3 part has determinant 0) and flattens the solid; give another "
                  "pose",
                  who, fmt::join(pose.numbers(), ", ")));
}

void refuse_vertex(std::size_t number, const Vec3& local, const Pose& pose, std::string_view who) {
  throw Error(
      fmt::format("{}: vertex {} ({}, {}, {}) is not finite in the world under the pose ({}); use smaller "
                  "coordinates or a smaller scale",
                  who, number, local.x, local.y, local.z, fmt::join(pose.numbers(), ", ")));
}

}  // namespace toccata
