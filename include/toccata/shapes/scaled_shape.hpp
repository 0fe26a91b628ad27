#pragma once

#include <memory>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

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
