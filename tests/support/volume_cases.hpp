#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata::test {

/// Two clouds of points, triangles, and a pose.
struct VolumeCase {
  std::vector<Vec3> a;
  std::vector<Vec3> b;
  std::vector<Triangle> triangles;  ///< of points of a
  Pose pose;
  bool shared = false;  ///< a and b have a point in common
};

/// random; grid: of small whole numbers, where much touches; flat: in a plane that is no coordinate plane; line; point:
/// all the same; needle: 1e9 times as long as thick; far: from the origin; tiny: about 1e-300; huge: about 1e300.
const std::vector<std::string>& volume_regimes();

/// Poses are rigid, scaled, sheared, mirrored, singular, or the identity, in turn by chance.
VolumeCase volume_case(const std::string& regime, Random& random);

std::vector<Vec3> corners(const std::vector<Triangle>& triangles);

/// p − q where that is a vector of doubles.
std::optional<Vec3> exact_difference_of(const Vec3& p, const Vec3& q);

/// Not above the distance of any two of the points, exactly.
bool found_less_than_every_pair(double gap, const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// The x of a point of a volume, where this is the box around it. It was added up from numbers as large as those of
/// the box, so it may be off by a few roundings of the largest, however near to zero it is itself.
bool holds_but_for_rounding(const Aabb& box, double x);

/// All numbers in full precision.
std::string to_text(const VolumeCase& input);

}  // namespace toccata::test
