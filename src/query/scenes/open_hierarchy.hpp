#pragma once

#include <optional>
#include <vector>

#include "toccata/query/scene_hierarchy.hpp"

namespace toccata {

/// A node of a hierarchy that is still being arranged.
struct OpenNode {
  Aabb box;
  std::optional<Index> scene_node;
  std::optional<Index> object;    ///< of a leaf
  std::vector<Index> children{};  ///< numbers of open nodes
};

/// The nodes below `root` as a hierarchy, children side by side in their order. Without any where the root's box is
/// empty.
[[nodiscard]] SceneHierarchy closed_hierarchy(const std::vector<OpenNode>& nodes, Index root);

/// The nodes of a hierarchy, with the same numbers: the root is 0.
[[nodiscard]] std::vector<OpenNode> open_hierarchy(const SceneHierarchy& hierarchy);

/// Groups nodes by the surface-area heuristic, two by two, below nodes that are appended for it. Returns the one or two
/// (or none, of none) that all others are below.
[[nodiscard]] std::vector<Index> grouped(std::vector<OpenNode>& nodes, const std::vector<Index>& members);

}  // namespace toccata
