#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "toccata/bounds/volume.hpp"
#include "toccata/core/index.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/model.hpp"

namespace toccata::io {

/// One level of a hierarchy: the nodes of that depth, and the leaves above them, which together hold all triangles.
struct DrawnLevel {
  std::size_t first_node = 0;
  std::size_t nodes = 0;
  std::size_t first_face = 0;
  std::size_t faces = 0;
  double fill = 0;                    ///< the part of the volumes that the hulls of what they hold take up
  std::size_t overlapping_pairs = 0;  ///< of its nodes' volumes
};

/// A hierarchy over the triangles of a mesh, its volumes as polyhedra in the mesh's own frame: boxes, k-DOPs and
/// hulls with all their corners, round ones by points of their surface, and as what they are.
struct DrawnHierarchy {
  std::vector<Index> order;                ///< triangles; those of a node are a run of them
  std::vector<std::array<Index, 2>> runs;  ///< of each node of each level: the first and how many
  std::vector<std::array<Vec3, 3>> faces;
  std::vector<Index> node_of_face;          ///< counted within its level
  std::vector<std::uint8_t> edges_of_face;  ///< bit k: from its corner k to the next runs an edge of the volume
  std::vector<RoundVolume> rounds;          ///< of each node of each level, where the volumes are round; else none
  std::vector<DrawnLevel> levels;           ///< from the root down, as long as there are at most 1,024 nodes
};

/// The hierarchy of a model that has a mesh: a binary one built by the surface-area heuristic, with at most two
/// triangles a leaf; for `wide`, boxes fitted around the nodes of the model's own tree.
[[nodiscard]] DrawnHierarchy drawn_hierarchy(const Model& model, CostVolume volume);

/// That of each mesh of these models. Throws Error when there are more than 32, too many to be looked at.
[[nodiscard]] std::map<const TriangleMesh*, DrawnHierarchy> drawn_hierarchies(std::span<const SceneInstance> models,
                                                                              CostVolume volume);

}  // namespace toccata::io
