#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "library.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata::bench {

/// Two convex hulls, whose sum is made once or many times, and points that may lie in it.
struct SumPair {
  ConvexHull a;
  ConvexHull b;
};

/// A library, or a way, that makes Minkowski sums.
class SumLibrary {
 public:
  virtual ~SumLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes the hulls over in the library's own types; not measured.
  virtual void prepare(std::span<const SumPair> pairs) = 0;
  /// Makes the sum of a pair; the number of its vertices.
  virtual Index make(std::size_t pair) = 0;
  /// The sum of the first pair, ready for points; the time is told as that of the build.
  virtual void make_ready() = 0;
  [[nodiscard]] virtual bool contains(const Vec3& point) = 0;
};

using SumLibraries = std::vector<std::unique_ptr<SumLibrary>>;

/// The overlay of Gauss maps first.
SumLibraries toccata_sum_libraries();
SumLibraries cgal_sum_libraries();

/// With the named peers. Throws Error when one is not built in.
SumLibraries sum_libraries(const std::vector<std::string>& peers);
std::vector<std::string> sum_peers();

}  // namespace toccata::bench
