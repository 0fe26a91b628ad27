#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <variant>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/box.hpp"
#include "toccata/shapes/capsule.hpp"
#include "toccata/shapes/cone.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/cylinder.hpp"
#include "toccata/shapes/ellipsoid.hpp"
#include "toccata/shapes/half_space.hpp"
#include "toccata/shapes/height_field.hpp"
#include "toccata/shapes/point.hpp"
#include "toccata/shapes/rounded.hpp"
#include "toccata/shapes/segment.hpp"
#include "toccata/shapes/sphere.hpp"
#include "toccata/shapes/triangle.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

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

[[nodiscard]] inline ShapeKind kind_of(const Shape& shape) { return static_cast<ShapeKind>(shape.index()); }

/// "point", "segment", "triangle", "half-space", "sphere", "box", "capsule", "convex hull", "rounded shape",
/// "cylinder", "cone", "ellipsoid", "height field", "mesh", "compound": for messages and reports.
[[nodiscard]] std::string_view name_of(ShapeKind kind);
[[nodiscard]] std::string_view name_of(const Shape& shape);

}  // namespace toccata
