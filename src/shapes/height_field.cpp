#include "toccata/shapes/height_field.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "shapes/validation.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

struct HeightGrid {
  Index columns;
  Index rows;
  double spacing_x;
  double spacing_y;

  [[nodiscard]] std::size_t vertex_count() const { return std::size_t{columns} * rows; }
  [[nodiscard]] Index vertex(Index column, Index row) const { return row * columns + column; }
};

void require_size(const HeightGrid& grid, std::size_t heights) {
  if (grid.columns < 2 || grid.rows < 2)
    throw Error(fmt::format("a height field of {} columns and {} rows has no cell; give at least two of both",
                            grid.columns, grid.rows));
  if (grid.vertex_count() > std::numeric_limits<Index>::max() / 2)
    throw Error(fmt::format("a height field of {} columns and {} rows has more than 2147483647 vertices; cut it up",
                            grid.columns, grid.rows));
  if (heights != grid.vertex_count())
    throw Error(fmt::format("a height field of {} columns and {} rows needs {} heights, row by row, and was given {}",
                            grid.columns, grid.rows, grid.vertex_count(), heights));
}

void require_spacing(double spacing, Index count, std::string_view what) {
  require_positive(spacing, what);
  if (!std::isfinite(spacing * (count - 1)))
    throw Error(fmt::format("{} is {}, which times {} is not finite; give a smaller one", what, spacing, count - 1));
}

void require_heights(const HeightGrid& grid, std::span<const double> heights) {
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isfinite(heights[i]))
      throw Error(fmt::format("the height of column {}, row {} is {}; give a finite number", i % grid.columns,
                              i / grid.columns, heights[i]));
}

std::vector<Vec3> vertices_of(const HeightGrid& grid, std::span<const double> heights) {
  std::vector<Vec3> vertices;
  vertices.reserve(heights.size());
  for (Index row = 0; row < grid.rows; ++row)
    for (Index column = 0; column < grid.columns; ++column)
      vertices.push_back({column * grid.spacing_x, row * grid.spacing_y, heights[grid.vertex(column, row)]});
  return vertices;
}

TriangleMesh mesh_of(const HeightGrid& grid, std::span<const double> heights) {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> cells;
  for (Index row = 0; row + 1 < grid.rows; ++row)
    for (Index column = 0; column + 1 < grid.columns; ++column) {
      const Index first = grid.vertex(column, row), last = grid.vertex(column + 1, row + 1);
      triangles.push_back({first, grid.vertex(column + 1, row), last});
      triangles.push_back({first, last, grid.vertex(column, row + 1)});
      cells.insert(cells.end(), 2, row * (grid.columns - 1) + column);
    }
  return {vertices_of(grid, heights), std::move(triangles), std::move(cells)};
}

std::shared_ptr<const TriangleMesh> checked_mesh(const HeightGrid& grid, std::span<const double> heights) {
  require_size(grid, heights.size());
  require_spacing(grid.spacing_x, grid.columns, "the spacing of a height field along x");
  require_spacing(grid.spacing_y, grid.rows, "the spacing of a height field along y");
  require_heights(grid, heights);
  return std::make_shared<const TriangleMesh>(mesh_of(grid, heights));
}

}  // namespace

struct HeightField::Parts {
  Index columns;
  Index rows;
  std::shared_ptr<const TriangleMesh> mesh;
};

HeightField::HeightField(Index columns, Index rows, double spacing_x, double spacing_y, std::span<const double> heights)
    : parts_(std::make_shared<const Parts>(
          Parts{columns, rows, checked_mesh({columns, rows, spacing_x, spacing_y}, heights)})) {}

Index HeightField::columns() const { return parts_->columns; }
Index HeightField::rows() const { return parts_->rows; }
double HeightField::spacing_x() const { return vertex(1, 0).x; }
double HeightField::spacing_y() const { return vertex(0, 1).y; }
Vec3 HeightField::vertex(Index column, Index row) const {
  return parts_->mesh->vertices()[std::size_t{row} * parts_->columns + column];
}
const std::shared_ptr<const TriangleMesh>& HeightField::mesh() const { return parts_->mesh; }

}  // namespace toccata
