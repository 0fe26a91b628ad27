#pragma once

#include <functional>
#include <vector>

#include "query/subdivision/level_mesh.hpp"
#include "query/subdivision/limit_bound.hpp"

namespace toccata {

/// The levels of a cage, each of what of the one before was refined. What is whole and not refined are leaves: together
/// they cover the surface once.
struct AdaptiveLevels {
  std::vector<LevelMesh> meshes;
  std::vector<std::vector<char>> refined;      ///< which faces of each level; of the last none
  std::vector<std::vector<FaceBound>> bounds;  ///< of the whole faces of each level
  bool are_complete = true;                    ///< tolerance and levels were reached
};

/// How far a face, flat or bilinear, may be from the limit surface of it.
using AllowedDistance = std::function<double(const LevelMesh& mesh, Index face)>;

/// Refines until every leaf has the levels and, with what a finer neighbour may move on its border, is as near the
/// limit as is allowed. The tolerance of the options is not looked at.
[[nodiscard]] AdaptiveLevels adaptive_levels(const SubdivisionCage& cage, const RefinementOptions& options,
                                             const AllowedDistance& allowed);

}  // namespace toccata
