#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <variant>

#include "toccata/core/type_list.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/height_field.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A bounded convex shape of flat faces grown by a ball: all points within `radius` of the core. Solid. Its pose may
/// not deform it (docs/truth.md). Around a point it is a sphere, around a segment a capsule.
class Rounded {
 public:
  using Core = std::variant<Point, Segment, Triangle, Box, ConvexHull>;

  /// Throws Error when the radius is not positive, or a number is not finite.
  Rounded(Core core, double radius);

  [[nodiscard]] const Core& core() const { return core_; }
  [[nodiscard]] double radius() const { return radius_; }

 private:
  Core core_;
  double radius_;
};

struct CompoundPart;

/// How deep compounds may stand in compounds: what walks them calls itself once a level, and the stack is finite.
inline constexpr int most_compound_levels = 1000;

/// The union of posed shapes; solid if all parts are. Shared and immutable; copies share all. A part may be a compound.
class Compound {
 public:
  /// The part's pose is relative to the compound. Throws Error when there is no part, a pose is not finite, or there
  /// are more than `most_compound_levels` levels of compounds.
  explicit Compound(std::span<const CompoundPart> parts);
  explicit Compound(std::initializer_list<CompoundPart> parts);

  [[nodiscard]] std::span<const CompoundPart> parts() const;

 private:
  struct Parts;
  [[nodiscard]] static int levels_of(std::span<const CompoundPart> parts);

  std::shared_ptr<const Parts> parts_;
};

template <class... Quadrics>
using ShapesWith = TypeList<Point, Segment, Triangle, HalfSpace, Sphere, Box, Capsule, ConvexHull, Rounded, Quadrics...,
                            HeightField, std::shared_ptr<const TriangleMesh>, Compound>;
using AllShapes = QuadricShapes::put_into<ShapesWith>;

/// Any shape. Sets and classes: docs/truth.md.
using Shape = AllShapes::put_into<std::variant>;

struct CompoundPart {
  Shape shape;
  Pose pose{};
};

/// The kinds in the order of Shape's alternatives. Quadrics have no names here: theirs are `shape_kind<Cone>`.
enum class ShapeKind : std::uint8_t {
  point,
  segment,
  triangle,
  half_space,
  sphere,
  box,
  capsule,
  convex_hull,
  rounded,
  first_quadric,
  height_field = first_quadric + QuadricShapes::size,
  mesh,
  compound,
};

inline constexpr std::size_t shape_kind_count = AllShapes::size;

template <class S>
requires(AllShapes::has<S>) inline constexpr ShapeKind shape_kind = static_cast<ShapeKind>(AllShapes::place_of<S>());
static_assert(shape_kind<Compound> == ShapeKind::compound);

[[nodiscard]] constexpr bool is_quadric(ShapeKind kind) {
  return kind >= ShapeKind::first_quadric && kind < ShapeKind::height_field;
}

[[nodiscard]] inline ShapeKind kind_of(const Shape& shape) { return static_cast<ShapeKind>(shape.index()); }

/// "point", "segment", "triangle", "half-space", "sphere", "box", "capsule", "convex hull", "rounded shape",
/// "cylinder", "cone", "ellipsoid", "height field", "mesh", "compound": for messages and reports.
[[nodiscard]] std::string_view name_of(ShapeKind kind);
[[nodiscard]] std::string_view name_of(const Shape& shape);

/// A pose may not deform it: a half-space, a shape with a radius, a compound with such a part (docs/truth.md). Units
/// and uniform scales go into its own numbers, and for all others into the pose.
[[nodiscard]] bool keeps_its_form(const Shape& shape);

/// The shape `factor` times as large, for shapes that keep their form: every length and coordinate multiplied once. In
/// a compound, the translations of the poses and, of parts that do not keep their form, the linear parts. Other shapes
/// are returned as they are: scale their pose. Throws Error when a number overflows or a length becomes zero.
[[nodiscard]] Shape scaled_in_itself(const Shape& shape, double factor);

/// The triangles of a mesh or a height field; null for all other shapes.
[[nodiscard]] std::shared_ptr<const TriangleMesh> mesh_of(const Shape& shape);

}  // namespace toccata
