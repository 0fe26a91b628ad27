#include "toccata/partitions/octree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "partitions/region_tree.hpp"

namespace toccata {
namespace {

/// Around the middle, as wide as the longest side; it ends where doubles do.
Aabb cube_around(const Aabb& box) {
  constexpr double greatest = std::numeric_limits<double>::max();
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper, half = 0.5 * box.upper - 0.5 * box.lower;
  const double longest = std::max({half.x, half.y, half.z});
  Aabb cube = box;
  for (int axis = 0; axis < 3; ++axis) {
    cube.lower[axis] = std::min(box.lower[axis], std::max(middle[axis] - longest, -greatest));
    cube.upper[axis] = std::max(box.upper[axis], std::min(middle[axis] + longest, greatest));
  }
  return cube;
}

std::vector<Aabb> octants(const Aabb& box) {
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper;
  std::vector<Aabb> parts;
  for (unsigned part = 0; part < 8; ++part) {
    Aabb octant = box;
    for (int axis = 0; axis < 3; ++axis) ((part >> axis & 1U) == 0 ? octant.upper : octant.lower)[axis] = middle[axis];
    if (octant == box) return {};  // no doubles between its sides
    parts.push_back(octant);
  }
  return parts;
}

}  // namespace

class Octree::State {
 public:
  State(PartitionItems held, const OctreeOptions& options)
      : items(std::move(held)),
        tree(build_regions(items, cube_around(items.bounds()),
                           {options.leaf_items, options.most_depth, options.most_copies, RegionCuts::must_part},
                           [](const Aabb& box, std::span<const Index>) { return octants(box); })) {}
  PartitionItems items;
  RegionTree tree;
};

Octree::Octree(const PartitionItems& items, const OctreeOptions& options)
    : state_(std::make_unique<State>(items, options)) {}
Octree::Octree(Octree&&) noexcept = default;
Octree& Octree::operator=(Octree&&) noexcept = default;
Octree::~Octree() = default;

std::vector<Index> Octree::candidates(const Aabb& box) const { return state_->tree.candidates(state_->items, box); }
std::vector<IndexPair> Octree::candidate_pairs() const { return state_->tree.candidate_pairs(state_->items); }
std::vector<PartitionCell> Octree::cells() const { return state_->tree.cells(); }
std::vector<PartitionCell> Octree::cells_at(Index depth) const { return state_->tree.cells_at(depth); }
Index Octree::greatest_depth() const { return state_->tree.greatest_depth(); }
std::size_t Octree::bytes() const { return state_->tree.bytes(); }

}  // namespace toccata
