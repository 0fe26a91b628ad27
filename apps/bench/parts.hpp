#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::bench {

/// A way to find which of many posed meshes, taken as surfaces, meet: one of Toccata's, or a peer's.
class PartsLibrary {
 public:
  virtual ~PartsLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured: the trees over the meshes.
  virtual void build(std::span<const SceneInstance> parts) = 0;
  /// Measured: from the poses to all pairs that meet, in any order.
  [[nodiscard]] virtual std::vector<IndexPair> pairs() = 0;
};

using PartsLibraries = std::vector<std::unique_ptr<PartsLibrary>>;

/// `check_all`, and one pair after the other.
PartsLibraries toccata_parts(int threads);
PartsLibraries fcl_parts();

}  // namespace toccata::bench
