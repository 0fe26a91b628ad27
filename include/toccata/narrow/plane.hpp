#pragma once

#include <cstdint>

#include "toccata/math/predicates.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// The plane through three points of the world, given by them: its normal and offset need not be doubles, so signs are
/// decided from the points. It is a tool, not a shape. The normal is (b − a) × (c − a): it points to the side from
/// which a, b, c turn counter-clockwise. (The lecture's slide has (c − a) × (b − a), which points the other way.)
class Plane {
 public:
  /// Throws Error when a coordinate is not finite or the points lie on one line.
  Plane(const Vec3& a, const Vec3& b, const Vec3& c);

  [[nodiscard]] const Vec3& a() const { return a_; }
  [[nodiscard]] const Vec3& b() const { return b_; }
  [[nodiscard]] const Vec3& c() const { return c_; }

 private:
  Vec3 a_;
  Vec3 b_;
  Vec3 c_;
};

/// The side on which `point` lies: positive where the normal points to, zero in the plane. Exact.
[[nodiscard]] Sign side(const Plane& plane, const Vec3& point);

/// The normal, unscaled; each coordinate is the double nearest to the exact one, so huge and tiny planes may over- or
/// underflow.
[[nodiscard]] Vec3 normal(const Plane& plane);

enum class PlaneCutKind : std::uint8_t {
  none,   ///< nothing in common (for a line: parallel to the plane)
  point,  ///< exactly one point
  whole,  ///< all of it lies in the plane
};

/// What a segment or line has in common with a plane. The kind is exact; the point has in each coordinate the double
/// nearest to the exact one (±∞ where that is beyond all doubles, which only a line can reach).
struct PlaneCut {
  PlaneCutKind kind = PlaneCutKind::none;
  Vec3 point;
};

/// The closed segment from p to q, which may be one point.
[[nodiscard]] PlaneCut cut_segment(const Plane& plane, const Vec3& p, const Vec3& q);

/// The line through p and q. Throws Error when they are the same point.
[[nodiscard]] PlaneCut cut_line(const Plane& plane, const Vec3& p, const Vec3& q);

}  // namespace toccata
