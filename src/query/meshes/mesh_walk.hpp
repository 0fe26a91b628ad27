#pragma once

#include "query/meshes/pair_cull.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/meshes/wide_cull.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {

/// A walk over two posed meshes with its constants.
class MeshWalk {
 public:
  MeshWalk(const PosedMesh& a, const PosedMesh& b)
      : cull_(wide_cull(PairCull(a, b), a, b)), walk_(a.model().wide_bvh(), b.model().wide_bvh(), cull_) {}
  // The walk refers to the constants.
  MeshWalk(const MeshWalk&) = delete;
  MeshWalk& operator=(const MeshWalk&) = delete;

  [[nodiscard]] const WideWalk* operator->() const { return &walk_; }

 private:
  WideCull cull_;
  WideWalk walk_;
};

}  // namespace toccata
