#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "library.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {

/// A library that finds which boxes of a moving crowd overlap: Toccata, or a peer.
class BroadLibrary {
 public:
  virtual ~BroadLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured.
  virtual void add(std::span<const Aabb> boxes) = 0;
  /// Measured: takes over the boxes of these numbers, out of all, and finds all pairs.
  virtual void step(std::span<const Index> moved, std::span<const Aabb> boxes) = 0;
  /// Not measured: what the last step found, in any order; boxes that only nearly overlap may be among them.
  [[nodiscard]] virtual std::vector<IndexPair> pairs() const = 0;
  /// Why it chose its method, where it did.
  [[nodiscard]] virtual std::string reason() const { return {}; }
  /// Memory a box, where the library tells: without the pairs.
  [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

using BroadLibraries = std::vector<std::unique_ptr<BroadLibrary>>;

BroadLibraries toccata_broad_libraries(const std::vector<std::string>& methods, int threads);
BroadLibraries bullet_broad_libraries(std::span<const Aabb> first);
BroadLibraries fcl_broad_libraries();
BroadLibraries cgal_broad_libraries();
BroadLibraries ode_broad_libraries();

}  // namespace toccata::bench
