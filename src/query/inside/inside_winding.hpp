#pragma once

#include "query/inside/inside_point.hpp"
#include "query/meshes/posed_mesh.hpp"

namespace toccata {

/// How a closed mesh winds around the two ends of a short segment through a point, along a coordinate axis.
struct LineWinding {
  int ahead = 0;                  ///< winding number just beyond the point, in the direction of the axis
  int behind = 0;                 ///< just before it
  bool on_face = false;           ///< the point lies on a triangle
  bool on_sheet = false;          ///< on a triangle with area
  bool on_another_plane = false;  ///< on one that is not in the plane asked about
};

/// Counts the triangles that the line through `p` in the direction of `axis` crosses beyond p and in p, after p was
/// moved by (ε, ε²) in the other two coordinates (in cyclic order) for an infinitely small ε > 0: so it meets no edge,
/// and both numbers are those of space just beside the line, near p, off all faces
/// (docs/methods/relations-of-solids.md). Symbolic perturbation after H. Edelsbrunner, E. P. Mücke, "Simulation of
/// simplicity", 1990. Exact. Only the two flags have a meaning for an open mesh. `plane` is a triangle with area.
[[nodiscard]] LineWinding wind_along(const PosedMesh& mesh, const ExactPoint& p, int axis, const Triangle& plane);

/// The same without a plane: `on_another_plane` stays false.
[[nodiscard]] LineWinding wind_along(const PosedMesh& mesh, const ExactPoint& p, int axis);

}  // namespace toccata
