#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata::bench {

/// Something that holds boxes and finds those in a place: Toccata's partitions of space, or a peer.
class PartitionLibrary {
 public:
  virtual ~PartitionLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  virtual void build(std::span<const Aabb> boxes) = 0;
  /// 0 where it does not tell.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  /// The boxes that overlap, in any order; touching counts.
  [[nodiscard]] virtual std::vector<Index> overlapping(const Aabb& box) const = 0;
  /// All pairs that overlap, the lesser first, in any order.
  [[nodiscard]] virtual std::vector<IndexPair> pairs() const = 0;
};

using PartitionLibraries = std::vector<std::unique_ptr<PartitionLibrary>>;

/// The packed R-tree first.
[[nodiscard]] PartitionLibraries toccata_partitions();
/// Boost.Geometry's R-tree: packed, and filled box by box.
[[nodiscard]] PartitionLibraries boost_partitions();

}  // namespace toccata::bench
