#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "query/semantics.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// A question about two models, made ready: each posed and its semantics settled. Throws Error, naming the model, for
/// what was asked wrongly, whatever the answer would have been.
struct PosedMeshPair {
  PosedMeshPair(const Model& model_a, const Model& model_b, const PairQuery& query)
      : a(model_a, query.pose_a, "model a"),
        b(model_b, query.pose_b, "model b"),
        a_solid(taken_as_solid(model_a, query.pose_a, query.solid_a, "model a")),
        b_solid(taken_as_solid(model_b, query.pose_b, query.solid_b, "model b")) {}

  PosedMesh a;
  PosedMesh b;
  bool a_solid;
  bool b_solid;
};

}  // namespace toccata
