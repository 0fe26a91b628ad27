#include <optional>

#include "partitions.hpp"
#include "toccata/core/version.hpp"
#include "toccata/partitions/kd_tree.hpp"
#include "toccata/partitions/octree.hpp"
#include "toccata/partitions/r_tree.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata::bench {
namespace {

template <SpacePartition P>
class Own final : public PartitionLibrary {
 public:
  using Make = P (*)(std::span<const Aabb>);
  Own(const char* variant, Make make) : variant_(variant), make_(make) {}

  [[nodiscard]] Description description() const override { return {"toccata", variant_, version, TOCCATA_BENCH_FLAGS}; }
  void build(std::span<const Aabb> boxes) override { partition_.emplace(make_(boxes)); }
  [[nodiscard]] std::size_t bytes() const override { return partition_->bytes(); }
  [[nodiscard]] std::vector<Index> overlapping(const Aabb& box) const override { return partition_->candidates(box); }
  [[nodiscard]] std::vector<IndexPair> pairs() const override { return partition_->candidate_pairs(); }

 private:
  const char* variant_;
  Make make_;
  std::optional<P> partition_;
};

template <class P>
P made_of(std::span<const Aabb> boxes) {
  return P(PartitionItems(std::vector<Aabb>(boxes.begin(), boxes.end())));
}

RTree inserted(std::span<const Aabb> boxes) {
  RTree tree;
  for (Index number = 0; number < boxes.size(); ++number) tree.insert(number, boxes[number]);
  return tree;
}

}  // namespace

PartitionLibraries toccata_partitions() {
  PartitionLibraries all;
  all.push_back(std::make_unique<Own<RTree>>("R-tree, packed", [](std::span<const Aabb> b) { return RTree(b); }));
  all.push_back(std::make_unique<Own<RTree>>("R-tree, box by box", inserted));
  all.push_back(std::make_unique<Own<UniformGrid<3>>>("grid", made_of<UniformGrid<3>>));
  all.push_back(std::make_unique<Own<Octree>>("octree", made_of<Octree>));
  all.push_back(std::make_unique<Own<KdTree>>("k-d tree", made_of<KdTree>));
  return all;
}

}  // namespace toccata::bench
