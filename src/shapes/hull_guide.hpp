#pragma once

#include <span>

#include "toccata/shapes/convex_hull.hpp"

// Where walks along the edges of large hulls begin: directions are sorted into the cells of a grid on the sides of a
// cube, one cell for each vertex or fewer, and for each cell a vertex is kept that is far along its middle. So a walk
// to the farthest vertex takes a step or two, however large the hull is. (S. A. Ehmann, M. C. Lin, "Accelerated
// proximity queries between convex polyhedra by multi-level Voronoi marching", 2000, have such a table.)
namespace toccata {

/// The cells for a hull of so many vertices; 0: none.
[[nodiscard]] Index guide_size(Index vertices);

/// Walks from the vertex of one cell to that of the next. What it finds is rounded: good to begin with.
void fill_guide(const ConvexHull& hull, std::span<Index> guide);

/// The cell of a direction that is finite and not zero; else some cell. There are `size` cells, not none.
[[nodiscard]] Index guide_cell(const Vec3& direction, std::size_t size);

}  // namespace toccata
