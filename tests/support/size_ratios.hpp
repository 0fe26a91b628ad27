#pragma once

#include <string>

#include "toccata/core/random.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata::test {

/// A mesh of a few triangles and one of many that is smaller than these by far, beside it or in it.
struct UnlikeSizes {
  Model large;
  Model small;
  PairQuery query;
  double ratio = 1;
};

/// Poses are of the family. Half of the small meshes have a vertex on a vertex, an edge or a face of the large one, as
/// far as rounding lets it; the others are near one.
UnlikeSizes random_unlike_sizes(const std::string& family, double ratio, Random& random);

/// The same for a ratio of 10⁻⁶ to 1.
UnlikeSizes random_unlike_sizes(const std::string& family, Random& random);

}  // namespace toccata::test
