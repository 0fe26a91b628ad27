#pragma once

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// The same as `triangulate`; the mesh takes the vertices over.
[[nodiscard]] TriangleMesh triangulated(PolygonMesh polygons);

}  // namespace toccata
