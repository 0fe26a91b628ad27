#pragma once

#include <string>
#include <vector>

#include "toccata/query/overlap.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// What two models have in common, as closed meshes in the world: one of each two parts that overlap.
struct OverlapBodies {
  std::vector<TriangleMesh> pieces{};
  std::string missing{};     ///< why there is no piece of some of them; else empty
  bool are_within = false;   ///< a round shape takes part, and polyhedra within such stand for them
  bool may_overlap = false;  ///< the pieces, as parts of one model overlap each other: only together they are the body
  OverlapVolume volume{};    ///< of all, where both are solids
};

/// The boundary of the body consists of the parts of each surface that lie in the other solid, cut into triangles;
/// which these are is exact, and the corners at which surfaces cross are rounded. A piece is told only where the volume
/// that it encloses is, but for that rounding, in its bracket; where the two merely touch beside the body, a mesh may
/// have a sheet without thickness. Throws Error as `overlap` does.
[[nodiscard]] OverlapBodies overlap_bodies(const Model& a, const Model& b, const PairQuery& query,
                                           Workspace& workspace);

}  // namespace toccata
