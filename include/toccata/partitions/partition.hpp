#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// Spatial decompositions (docs/methods/space-partitions.md): space-centric ones cut space, and an item is in every cell
// it reaches (object redundancy); object-centric ones group the items, and regions may overlap (space redundancy).
namespace toccata {

/// What is partitioned: boxes, or triangles with their boxes. It does not change; copies share it.
class PartitionItems {
 public:
  /// Throws Error naming a box that has a coordinate that is not finite, or lower > upper.
  explicit PartitionItems(std::vector<Aabb> boxes);
  /// Throws Error naming a triangle that has a coordinate that is not finite.
  explicit PartitionItems(std::vector<Triangle> triangles);
  /// The triangles of the mesh, item i is triangle i.
  explicit PartitionItems(const TriangleMesh& mesh);

  [[nodiscard]] std::size_t size() const { return data_->boxes.size(); }
  [[nodiscard]] std::span<const Aabb> boxes() const { return data_->boxes; }
  /// Empty where the items are boxes.
  [[nodiscard]] std::span<const Triangle> triangles() const { return data_->triangles; }
  /// The box around all of them.
  [[nodiscard]] const Aabb& bounds() const { return data_->bounds; }

  /// The item itself, not only its box, has a point in common with the closed box. Exact.
  [[nodiscard]] bool meets(Index item, const Aabb& box) const;
  /// The two items have a point in common. Exact.
  [[nodiscard]] bool meet(Index a, Index b) const;

 private:
  struct Data {
    std::vector<Aabb> boxes;
    std::vector<Triangle> triangles;
    Aabb bounds;
  };
  std::shared_ptr<const Data> data_;
};

/// A region of a partition, and the items it holds, ascending.
struct PartitionCell {
  Aabb box;
  std::vector<Index> items;
};

/// A partition of space over items. A candidate is an item whose box overlaps what is asked about and that shares a
/// region with it: none that meets it is missing. Where the items are boxes the candidates are the answer; for
/// triangles `PartitionItems::meets` and `meet` decide. Const functions may be called from many threads at once.
template <class P>
concept SpacePartition = requires(const P& partition, const Aabb& box) {
  /// The cells that hold an item.
  { partition.cells() } -> std::same_as<std::vector<PartitionCell>>;
  /// Ascending, each once. Touching counts.
  { partition.candidates(box) } -> std::same_as<std::vector<Index>>;
  /// All pairs of items that are candidates of each other, ascending, each once.
  { partition.candidate_pairs() } -> std::same_as<std::vector<IndexPair>>;
  /// Memory that it keeps, without the items.
  { partition.bytes() } -> std::same_as<std::size_t>;
};

/// The items that meet the box, ascending. Exact.
template <SpacePartition P>
[[nodiscard]] std::vector<Index> items_intersecting(const P& partition, const PartitionItems& items, const Aabb& box) {
  std::vector<Index> found = partition.candidates(box);
  if (!items.triangles().empty()) std::erase_if(found, [&](Index item) { return !items.meets(item, box); });
  return found;
}

/// The pairs of items that meet, ascending. Exact.
template <SpacePartition P>
[[nodiscard]] std::vector<IndexPair> pairs_intersecting(const P& partition, const PartitionItems& items) {
  std::vector<IndexPair> found = partition.candidate_pairs();
  if (!items.triangles().empty())
    std::erase_if(found, [&](const IndexPair& pair) { return !items.meet(pair.first, pair.second); });
  return found;
}

}  // namespace toccata
