#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "toccata/core/type_list.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

enum class WhenLeftOut : std::uint8_t { refused, zero };

/// One of the numbers and vectors that a shape is made of.
template <class S, class Value>
struct ShapeParameter {
  constexpr ShapeParameter(const char* name_in_files, Value (S::*getter)() const,
                           WhenLeftOut left_out = WhenLeftOut::refused)
      : name(name_in_files), value(getter), when_left_out(left_out) {}

  const char* name;
  Value (S::*value)() const;
  WhenLeftOut when_left_out;  ///< what becomes of it where a file leaves it out
};

/// A shape that is made of numbers and vectors alone says what it is, and files and messages go by that:
///  - name: what it is called;
///  - words: how people read of it, with the values of its parameters in the braces;
///  - parameters: what its constructor takes, in that order.
template <class S>
concept DescribedShape = requires {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::words } -> std::convertible_to<std::string_view>;
  S::parameters;
};

/// What constructors of shapes check: throws Error unless the number is positive and finite. `what` begins the message:
/// "the radius of a sphere".
void require_positive(double value, std::string_view what);

/// One point, in the shape's own frame. A surface: it has no interior.
class Point {
 public:
  /// Throws Error when the position is not finite.
  explicit Point(const Vec3& position = {});

  [[nodiscard]] const Vec3& position() const { return position_; }

  static constexpr std::string_view name = "point", words = "point {}";
  static constexpr std::tuple parameters{ShapeParameter("position", &Point::position, WhenLeftOut::zero)};

 private:
  Vec3 position_;
};

/// The segment between two points of the shape's own frame, which may be equal. A surface: it has no interior.
class Segment {
 public:
  /// Throws Error when an end is not finite.
  Segment(const Vec3& start, const Vec3& end);

  [[nodiscard]] const Vec3& start() const { return start_; }
  [[nodiscard]] const Vec3& end() const { return end_; }

  static constexpr std::string_view name = "segment", words = "segment from {} to {}";
  static constexpr std::tuple parameters{ShapeParameter("start", &Segment::start),
                                         ShapeParameter("end", &Segment::end)};

 private:
  Vec3 start_;
  Vec3 end_;
};

/// Three vertices; the set is their convex hull, which may be a segment or a point. Its normal is
/// (v1 − v0) × (v2 − v0): out of the solid when vertices turn counter-clockwise seen from outside.
struct Triangle {
  std::array<Vec3, 3> vertex;

  constexpr const Vec3& operator[](int i) const { return vertex[static_cast<std::size_t>(i)]; }
  constexpr Vec3& operator[](int i) { return vertex[static_cast<std::size_t>(i)]; }

  friend constexpr bool operator==(const Triangle&, const Triangle&) = default;
};

/// Whether it is neither a segment nor a point; exact.
[[nodiscard]] bool has_area(const Triangle& t);

/// A solid ball: all points within `radius` of the centre, which is in the shape's own frame. Its pose may not deform
/// it (docs/truth.md).
class Sphere {
 public:
  /// Throws Error when the radius is not positive, or a number is not finite.
  explicit Sphere(double radius, const Vec3& centre = {});

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }

  static constexpr std::string_view name = "sphere", words = "sphere of radius {} around {}";
  static constexpr std::tuple parameters{ShapeParameter("radius", &Sphere::radius),
                                         ShapeParameter("centre", &Sphere::centre, WhenLeftOut::zero)};

 private:
  Vec3 centre_;
  double radius_;
};

/// A solid capsule: all points within `radius` of the segment between two points of the shape's own frame, which may be
/// equal. Its pose may not deform it (docs/truth.md).
class Capsule {
 public:
  /// Throws Error when the radius is not positive, or a number is not finite.
  Capsule(const Vec3& start, const Vec3& end, double radius);

  [[nodiscard]] const Vec3& start() const { return start_; }
  [[nodiscard]] const Vec3& end() const { return end_; }
  [[nodiscard]] double radius() const { return radius_; }

  static constexpr std::string_view name = "capsule", words = "capsule of radius {2} from {0} to {1}";
  static constexpr std::tuple parameters{ShapeParameter("start", &Capsule::start), ShapeParameter("end", &Capsule::end),
                                         ShapeParameter("radius", &Capsule::radius)};

 private:
  Vec3 start_;
  Vec3 end_;
  double radius_;
};

/// A solid box along the axes of the shape's own frame. In the world it is the convex hull of its eight corners, each
/// rounded by itself.
class Box {
 public:
  /// `half_extents`: from the centre to the faces. Throws Error when one is not positive, a number is not finite, or a
  /// corner centre ± half extent overflows or falls together with its opposite.
  explicit Box(const Vec3& half_extents, const Vec3& centre = {});

  [[nodiscard]] const Vec3& half_extents() const { return half_extents_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }

  /// Corner i, of 8, in the shape's own frame: its x is centre.x + half_extents.x where bit 0 of i is set and
  /// centre.x − half_extents.x where not; bit 1 is y, bit 2 is z.
  [[nodiscard]] Vec3 corner(int i) const {
    const auto along = [i, this](int axis) {
      return (i >> axis & 1) != 0 ? centre_[axis] + half_extents_[axis] : centre_[axis] - half_extents_[axis];
    };
    return {along(0), along(1), along(2)};
  }

  static constexpr std::string_view name = "box", words = "box of half extents {} around {}";
  static constexpr std::tuple parameters{ShapeParameter("half_extents", &Box::half_extents),
                                         ShapeParameter("centre", &Box::centre, WhenLeftOut::zero)};

 private:
  Vec3 centre_;
  Vec3 half_extents_;
};

/// All points p with (p − point) · normal ≤ 0, in the shape's own frame: solid, and without end on the side away from
/// the normal. Its pose may not deform it (docs/truth.md).
class HalfSpace {
 public:
  /// The normal points out of the solid and need not have length 1. Throws Error when it is zero, or a number is not
  /// finite.
  HalfSpace(const Vec3& point, const Vec3& normal);

  [[nodiscard]] const Vec3& point() const { return point_; }
  [[nodiscard]] const Vec3& normal() const { return normal_; }

  static constexpr std::string_view name = "half-space", words = "half-space behind {}, normal {}";
  static constexpr std::tuple parameters{ShapeParameter("point", &HalfSpace::point, WhenLeftOut::zero),
                                         ShapeParameter("normal", &HalfSpace::normal)};

 private:
  Vec3 point_;
  Vec3 normal_;
};

/// A solid cylinder around the z axis of its own frame, from z = −half_height to z = half_height. Any pose that is not
/// singular may place it, one that deforms included (docs/truth.md, "quadric").
class Cylinder {
 public:
  /// Throws Error when a number is not positive, or not finite.
  Cylinder(double radius, double half_height) : radius_(radius), half_height_(half_height) {
    require_positive(radius, "the radius of a cylinder");
    require_positive(half_height, "the half height of a cylinder");
  }

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double half_height() const { return half_height_; }
  /// The radius twice, and the half height.
  [[nodiscard]] Vec3 half_axes() const { return {radius_, radius_, half_height_}; }

  static constexpr std::string_view name = "cylinder", words = "cylinder of radius {} and half height {} along z";
  static constexpr std::tuple parameters{ShapeParameter("radius", &Cylinder::radius),
                                         ShapeParameter("half_height", &Cylinder::half_height)};

 private:
  double radius_;
  double half_height_;
};

/// A solid cone around the z axis of its own frame: its base, a disc of the radius, at z = −half_height, its tip at
/// z = half_height. Any pose that is not singular may place it, one that deforms included (docs/truth.md, "quadric").
class Cone {
 public:
  /// Throws Error when a number is not positive, or not finite.
  Cone(double radius, double half_height) : radius_(radius), half_height_(half_height) {
    require_positive(radius, "the radius of a cone");
    require_positive(half_height, "the half height of a cone");
  }

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double half_height() const { return half_height_; }
  /// The radius twice, and the half height.
  [[nodiscard]] Vec3 half_axes() const { return {radius_, radius_, half_height_}; }

  static constexpr std::string_view name = "cone", words = "cone of radius {} and half height {} along z";
  static constexpr std::tuple parameters{ShapeParameter("radius", &Cone::radius),
                                         ShapeParameter("half_height", &Cone::half_height)};

 private:
  double radius_;
  double half_height_;
};

/// A solid ellipsoid around the origin of its own frame, its half axes along the axes. Any pose that is not singular
/// may place it, one that deforms included (docs/truth.md, "quadric").
class Ellipsoid {
 public:
  /// Throws Error when a half axis is not positive, or not finite.
  explicit Ellipsoid(const Vec3& half_axes) : half_axes_(half_axes) {
    require_positive(half_axes.x, "the half axis along x of an ellipsoid");
    require_positive(half_axes.y, "the half axis along y of an ellipsoid");
    require_positive(half_axes.z, "the half axis along z of an ellipsoid");
  }

  [[nodiscard]] const Vec3& half_axes() const { return half_axes_; }

  static constexpr std::string_view name = "ellipsoid", words = "ellipsoid of half axes {}";
  static constexpr std::tuple parameters{ShapeParameter("half_axes", &Ellipsoid::half_axes)};

 private:
  Vec3 half_axes_;
};

/// All shapes of which only the real image is posed (PosedQuadric). Each has `half_axes()`, by which it is the image of
/// the shape of its kind within |x|, |y|, |z| ≤ 1. What else is known of a kind is in src/narrow/quadrics/kinds.
using QuadricShapes = TypeList<Cylinder, Cone, Ellipsoid>;

template <class S>
concept QuadricShape = QuadricShapes::has<S>;

}  // namespace toccata
