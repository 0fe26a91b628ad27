#pragma once

#include "query/search_scratch.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// Two models that are not apart, at their places, and how narrow their depth is asked.
struct OverlappingModels {
  const Model& a;
  const Model& b;
  const PairQuery& query;
  const DepthOptions& depth;
};

/// Tells how deep they are by the shortest translation that parts them, where that is defined: the narrower of what is
/// known and what is found.
void tell_depth(PairAnswer& answer, const OverlappingModels& models, Workspace& workspace);

/// Tells how the overlap stands to the tolerance, and the depth by which that was decided. Of two meshes of which
/// neither holds the other it is decided by how deep they are at single places, where that tells; else by the
/// translation.
void tell_verdict(PairAnswer& answer, double tolerance, const OverlappingModels& models, Workspace& workspace);

}  // namespace toccata
