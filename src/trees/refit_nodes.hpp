#pragma once

#include <cstddef>
#include <span>

#include "toccata/core/index.hpp"
#include "toccata/trees/bvh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Puts volumes around items that have moved: leaves by `volume_of(their items)`, inner nodes merged from their
/// children, from the last node to the first. `built_size` is known.
template <class Volume, int Arity, class VolumeOf>
Refit refit_nodes(Bvh<Volume, Arity>& tree, const VolumeOf& volume_of) {
  double size = 0;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    BvhNode<Volume>& node = tree.nodes[i];
    if (node.is_leaf()) {
      node.volume = volume_of(std::span<const Index>(tree.items).subspan(node.first, node.count));
    } else {
      Volume merged = tree.nodes[node.first].volume;
      for (Index k = 1; k < node.child_count; ++k) merged = merge(merged, tree.nodes[node.first + k].volume);
      node.volume = merged;
    }
    size += half_area(node.volume);
  }
  return {tree.nodes.size(), size == tree.built_size ? 1 : size / tree.built_size};
}

}  // namespace toccata
