#pragma once

#include "query/meshes/cull_bounds.hpp"
#include "query/meshes/pair_cull.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {

/// The directions along which two posed meshes are compared, as constants of a walk over their wide trees. The pads of
/// `cull` and all that is rounded here are in those of the result (docs/design/fast-core.md).
[[nodiscard]] WideCull wide_cull(const PairCull& cull, const PosedMesh& a, const PosedMesh& b);

/// The axes of one frame in which both trees are: boxes that are no farther than `reach` from each other along each of
/// them are kept.
[[nodiscard]] WideCull wide_cull_in_one_frame(const WideBvh& a, const WideBvh& b, double reach);

/// A world direction along which the mesh and the region are compared: for a local point x, its world point along the
/// direction is on_mesh · x + offset, up to `pad`.
struct RegionDirection {
  Vec3 on_mesh;
  double offset = 0;
  FormRange region{};
  double pad = 0;
};

/// Adds it to a probe, unless floats cannot hold it.
void add_axis(const RegionDirection& direction, const WideBvh& tree, WideProbe& probe);

}  // namespace toccata
