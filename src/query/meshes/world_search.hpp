#pragma once

#include "query/meshes/body_ranges.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "trees/wide_probe.hpp"

namespace toccata {

/// A world triangle as a region that boxes of the mesh's tree are compared with: along its normal, and along the
/// normals of its sides in its plane.
[[nodiscard]] WideProbe probe_of(const PosedMesh& mesh, const Triangle& triangle);

/// Calls `visit(triangle)` for all triangles that meet `region`, a closed world box, and only for such whose world
/// boxes meet it, in no particular but always the same order; ends early when `visit` returns false. The upper side of
/// the region may be infinite along one axis: the ray from p along +x is {p, {∞, p.y, p.z}}.
void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, FunctionRef<bool(Index)> visit);

/// The same of a body that lies in the region and in the ranges: also without triangles that one of these tells from
/// it.
void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, const RegionRanges& body,
                          FunctionRef<bool(Index)> visit);

/// The same of what is in the ranges, without a region: also triangles that the tree cannot tell from those that meet
/// it.
void visit_triangles_in(const PosedMesh& mesh, const RegionRanges& ranges, FunctionRef<bool(Index)> visit);

/// A triangle in the world, with its box.
struct MeshTriangle {
  Index number = 0;
  Triangle corners{};
  Aabb box;
};

/// The same, each with its corners; to the end.
void visit_world_triangles(const PosedMesh& mesh, const Aabb& region, FunctionRef<void(const MeshTriangle&)> visit);

/// Calls `visit(triangle)` for all triangles that meet the half-space, and for such as the tree cannot tell from these,
/// in the same sense.
void visit_triangles_near(const PosedMesh& mesh, const PosedHalfSpace& half_space, FunctionRef<bool(Index)> visit);

}  // namespace toccata
