#pragma once

#include <memory>
#include <span>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A surface above a grid in the x-y plane of its own frame: the vertex of column i and row j is
/// (i · spacing_x, j · spacing_y, height). Every cell is split along the diagonal from (i, j) to (i + 1, j + 1) into
/// the triangles 2c (with (i + 1, j)) and 2c + 1 (with (i, j + 1)), where c = j · (columns − 1) + i; their normals
/// point up. Shared and immutable; copies share all.
class HeightField {
 public:
  /// `heights`: row by row, columns · rows of them. Throws Error when there are fewer than two columns or rows, the
  /// number of heights is another, a spacing is not positive, or a number is not finite.
  HeightField(Index columns, Index rows, double spacing_x, double spacing_y, std::span<const double> heights);

  [[nodiscard]] Index columns() const;
  [[nodiscard]] Index rows() const;
  [[nodiscard]] double spacing_x() const;
  [[nodiscard]] double spacing_y() const;
  [[nodiscard]] Vec3 vertex(Index column, Index row) const;

  /// Its triangles as a mesh; the surface that questions are answered about. Face c is the cell c.
  [[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
