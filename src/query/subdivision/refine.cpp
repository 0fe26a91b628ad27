#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "query/subdivision/adaptive_levels.hpp"
#include "query/subdivision/level_triangles.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void check_refinement(const SubdivisionCage& cage, const RefinementOptions& options) {
  if (!(options.tolerance > 0)) throw Error("the tolerance of a refinement must be positive");
  if (options.levels < 0 || options.levels > 30) throw Error("the levels of a refinement must be 0 … 30");
  const double least = least_tolerance(cage);
  if (options.tolerance < least)
    throw Error(
        fmt::format("the tolerance of a refinement is {:g}, but the rounding of coordinates as large as this "
                    "cage's leaves {:.3g} open however often it is refined: ask for more, or move the cage "
                    "near the origin",
                    options.tolerance, least));
}

}  // namespace

double least_tolerance(const SubdivisionCage& cage) { return rounding_of_triangles(first_level(cage)); }

SubdividedMesh refine(const SubdivisionCage& cage, const RefinementOptions& options) {
  check_refinement(cage, options);
  const AdaptiveLevels levels =
      adaptive_levels(cage, options, [&](const LevelMesh&, Index) { return options.tolerance; });
  LeafMesh leaves = leaf_mesh(levels);
  const double farthest = *std::max_element(leaves.triangle_distances.begin(), leaves.triangle_distances.end());
  return {.mesh = std::move(leaves.mesh),
          .distance_to_limit = farthest,
          .triangle_distances = std::move(leaves.triangle_distances),
          .deepest_level = levels.meshes.back().level,
          .status = levels.are_complete && farthest <= options.tolerance ? Status::exact : Status::not_converged};
}

}  // namespace toccata
