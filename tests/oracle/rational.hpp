#pragma once

#include <vector>

#include "oracle/rational_number.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"

/// The truth page (docs/truth.md) as slow, obvious code in rational arithmetic. Uses nothing of the library but the
/// plain structs that hold input: Vec3, Pose, Triangle, TriangleMesh.
namespace toccata::oracle {

/// A point or a vector with exact coordinates.
struct RationalPoint {
  Rational x;
  Rational y;
  Rational z;
  friend bool operator==(const RationalPoint& a, const RationalPoint& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};

/// Lexicographic; for sorting only.
bool operator<(const RationalPoint& a, const RationalPoint& b);

RationalPoint operator+(const RationalPoint& a, const RationalPoint& b);
RationalPoint operator-(const RationalPoint& a, const RationalPoint& b);
RationalPoint operator-(const RationalPoint& a);
RationalPoint operator*(const Rational& s, const RationalPoint& a);
Rational dot(const RationalPoint& a, const RationalPoint& b);
RationalPoint cross(const RationalPoint& a, const RationalPoint& b);
bool is_zero(const RationalPoint& a);
RationalPoint centroid(const std::vector<RationalPoint>& points);

/// The number a finite double stands for, without rounding.
Rational exact(double value);
RationalPoint exact(const Vec3& point);

/// Each coordinate as the nearest double.
Vec3 rounded(const RationalPoint& point);

/// Oracle of `transform`: the world vertex in doubles, by the formula of the truth page.
Vec3 world_vertex(const Pose& pose, const Vec3& local);

/// Oracle of `is_singular`: the exact determinant of R is zero.
bool is_singular(const Pose& pose);

/// Whether rounded shapes and half-spaces may have this pose: ‖RᵀR − I‖∞ ≤ 2⁻⁴⁰, exactly.
bool keeps_balls_round(const Pose& pose);

/// The oracle of `orient3d`: ((b − a) × (c − a)) · (d − a).
Rational orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d);

/// All points lie in one plane.
bool are_coplanar(const std::vector<RationalPoint>& points);

/// A plane, or the closed half-space of the points x with normal · x ≤ offset.
struct HalfSpace {
  RationalPoint normal;
  Rational offset;
};

/// The half-space behind a plane: its points p have (p − point) · normal ≤ 0.
HalfSpace half_space(const RationalPoint& point, const RationalPoint& normal);

/// normal · p − offset: negative inside the half-space, positive outside.
Rational height_above(const HalfSpace& half_space, const RationalPoint& p);

/// The part of a convex polygon (or segment, or point) inside a closed half-space. The corners come in cyclic order and
/// may repeat; an empty answer means no common point.
std::vector<RationalPoint> clipped(const std::vector<RationalPoint>& polygon, const HalfSpace& half_space);

}  // namespace toccata::oracle
