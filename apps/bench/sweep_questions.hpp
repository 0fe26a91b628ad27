#pragma once

#include "arguments.hpp"
#include "sweeps.hpp"

namespace toccata::bench {

/// Five sets of convex bodies that move past each other, each drawn from the seed: `translations`, `rotations`,
/// `thin boxes`, `thin walls` and `rods`. None of them meets at the start.
std::vector<SweepWork> sweeps_of_bodies(const MotionArguments& arguments);

/// Two bunnies, one of which turns: free at a gap of 1 % and meeting; and two spheres with a rough surface that meet,
/// of 1,280 to 81,920 triangles each.
std::vector<SweepWork> sweeps_of_meshes(const MotionArguments& arguments);

}  // namespace toccata::bench
