#pragma once

#include <cstdint>

#include "toccata/narrow/convex_convex.hpp"

// The search of E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between
// complex objects in three-dimensional space", 1988, for itself: without formulas for single pairs of kinds, and in the
// manner that is asked for. `distance` and `overlap` choose the manner themselves.
namespace toccata {

/// How the vertex that is the farthest along a direction is found.
enum class GjkSupport : std::uint8_t {
  automatic,      ///< the faster of the two for so many vertices, as measured
  scan,           ///< all vertices are looked at, with vector instructions
  hill_climbing,  ///< of a hull: along edges to ever farther neighbours, from the last vertex found; others are scanned
};

/// Whether the search aims along the nearest point so far, or farther ahead.
enum class GjkAcceleration : std::uint8_t {
  none,
  /// With momentum, after L. Montaut, Q. Le Lidec, V. Petrik, J. Sivic, J. Carpentier, "Collision Detection
  /// Accelerated: An Optimization Perspective", 2022. Goes on without where it stalls.
  nesterov,
};

struct GjkOptions {
  GjkSupport support = GjkSupport::automatic;
  GjkAcceleration acceleration = GjkAcceleration::none;
};

/// What `overlap` and `distance` promise, holds here too; where these use a formula for the pair, other numbers of the
/// same interval may be told. Every bit of the answers is the same whatever the options are; what they save is told by
/// the counts of the workspace: `steps` and `heights`.
[[nodiscard]] bool overlap_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options = {},
                                  SimplexCache* workspace = nullptr);
[[nodiscard]] Distance distance_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options = {},
                                       SimplexCache* workspace = nullptr);

}  // namespace toccata
