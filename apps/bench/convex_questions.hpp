#pragma once

#include "arguments.hpp"
#include "convex_library.hpp"

namespace toccata::bench {

/// Pairs and poses for a benchmark of convex shapes; sizes are about 1. Deterministic by the seed.
ConvexWork convex_work(const ConvexArguments& arguments);

/// The shape in the world. Throws Error for one with round sides.
PosedPolytope posed(const ConvexBody& body, const Pose& pose);

}  // namespace toccata::bench
