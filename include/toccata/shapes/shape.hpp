#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <variant>

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

/// Any shape. Sets and classes: docs/truth.md.
using Shape = std::variant<Point, Segment, Triangle, HalfSpace, Sphere, Box, Capsule, ConvexHull, Rounded, Cylinder,
                           Cone, Ellipsoid, HeightField, std::shared_ptr<const TriangleMesh>, Compound>;

/// A shape of which only the real image is posed: `PosedQuadric`.
template <class S>
concept QuadricShape = std::same_as<S, Cylinder> || std::same_as<S, Cone> || std::same_as<S, Ellipsoid>;

struct CompoundPart {
  Shape shape;
  Pose pose{};
};

/// In the order of Shape's alternatives.
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
  cylinder,
  cone,
  ellipsoid,
  height_field,
  mesh,
  compound,
};

inline constexpr std::size_t shape_kind_count = std::variant_size_v<Shape>;

[[nodiscard]] constexpr bool is_quadric(ShapeKind kind) {
  return kind == ShapeKind::cylinder || kind == ShapeKind::cone || kind == ShapeKind::ellipsoid;
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
