#pragma once

#include <string>

#include "toccata/core/random.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata::bench {

/// The corners of the k-DOP of 40 random points, for the kinds "6-dop", "14-dop", "18-dop" and "26-dop": of about size
/// 1, around the origin.
[[nodiscard]] ConvexHull random_dop(const std::string& kind, Random& random);

/// Calls `function` with the k of such a kind as template argument.
template <class Function>
auto with_planes(const std::string& kind, Function function) {
  if (kind == "6-dop") return function.template operator()<6>();
  if (kind == "14-dop") return function.template operator()<14>();
  if (kind == "18-dop") return function.template operator()<18>();
  return function.template operator()<26>();
}

}  // namespace toccata::bench
