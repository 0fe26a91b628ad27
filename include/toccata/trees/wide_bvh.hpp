#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// The boxes of up to eight children of a node, side by side, so that one box is compared with all of them at once
/// (I. Wald, C. Benthin, S. Boulos, "Getting rid of packets", 2008; H. Dammertz, J. Hanika, A. Keller, "Shallow
/// bounding volume hierarchies", 2008). Centre and half size, in the tree's units from its origin: child i lies within
/// centre[axis][i] ± extent[axis][i], these taken as real numbers.
struct alignas(64) WideBlock {
  static constexpr std::size_t width = 8;

  std::array<std::array<float, width>, 3> centre;
  std::array<std::array<float, width>, 3> extent;
  /// A block of the tree where ≥ 0, else the single item at place ~child of the tree's item order.
  std::array<std::int32_t, width> child;
  std::uint32_t
      count;  ///< children; they have the first lanes. The boxes of other lanes are at 0 and their children 0.

  [[nodiscard]] bool is_item(std::size_t lane) const { return child[lane] < 0; }
  /// Where in the tree's item order the item of that lane is.
  [[nodiscard]] std::uint32_t item_place(std::size_t lane) const { return static_cast<std::uint32_t>(~child[lane]); }
};

/// A hierarchy of boxes with eight children a node, and single items as leaves. Coordinates are x = origin + unit · q
/// with floats q between −1 and 1 (−2 and 2 when the whole is more than 2¹⁰²⁴ long, since 2¹⁰²⁴ is no double), so that
/// meshes that are tiny, huge or far from the origin keep their detail. Block 0 is the root's, children come after
/// their parent; no blocks for no items. Every box contains its items; nothing is promised of how tight it is, though
/// rounding outwards is all that was added.
struct WideBvh {
  Vec3 origin;
  double unit = 1;  ///< a power of two
  Aabb box;         ///< around all items, exact
  std::vector<WideBlock> blocks;
  std::vector<Index> items;  ///< item numbers in the order of the leaves
  double built_size = -1;  ///< half_area of boxes around several, in the mean of logarithms, as built; −1: not known
};

struct WideBuildOptions {
  int threads = own_thread;
  /// More items than this are refused. Places and blocks are told apart by a sign and eight lanes, hence the greatest.
  std::size_t most_items = greatest_item_count;

  static constexpr std::size_t greatest_item_count = std::size_t{1} << 28;
};

/// A tree over items that are given by their boxes (item i has boxes[i]; none empty, all finite). From the top down by
/// the surface-area heuristic (I. Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007). The
/// same boxes give the same tree. Throws Error for more than `most_items`.
[[nodiscard]] WideBvh build_wide_bvh(std::span<const Aabb> boxes, const WideBuildOptions& options = {});

/// What refitting did. Once the nodes have grown to twice what they were when the tree was built, walks visit about
/// twice as many, and building anew pays.
struct Refit {
  std::size_t volumes_updated = 0;
  double growth = 1;  ///< half_area, as in `built_size`, relative to that of the tree as built; +∞ where it was 0
  [[nodiscard]] bool should_rebuild() const { return !(growth <= 2); }
};

/// Puts the boxes of a tree over the mesh's triangles around them after its vertices have moved; which triangles lie
/// below which box stays. The same tree on any number of threads.
/// Throws Error when the tree was built over another number of triangles. To do it for a model: Model::deform.
Refit refit(WideBvh& tree, const TriangleMesh& mesh, int threads = own_thread);

}  // namespace toccata
