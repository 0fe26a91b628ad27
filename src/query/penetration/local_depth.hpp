#pragma once

#include <vector>

#include "query/ask.hpp"
#include "query/penetration/depth_search.hpp"

namespace toccata {

/// The depth of two overlapping solids as the place says where they are deepest in each other: balls within both and
/// convex bodies around their middle bound it from below, and the way out there is tried. Mostly a narrow bracket where
/// they meet in one place, and far quicker than a search of all ways. `lower` is proved in any case, if only as 0;
/// where no way out was found, `upper` is infinite. `meeting` are some points at which the surfaces meet. Without the
/// points.
[[nodiscard]] Penetration local_depth(const Model& a, const Model& b, const PairQuery& query,
                                      const PosedModelPair& models, const SeparatingQuestions& questions,
                                      const std::vector<SurfaceIntersection>& meeting, const DepthLimit& limit,
                                      SearchScratch& scratch);

}  // namespace toccata
