#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "toccata/io/scene_question.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/cost.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// Which axis of the world points up on the screen.
enum class UpAxis { y, z };

struct ViewOptions {
  std::string title = "Toccata";
  UpAxis up = UpAxis::z;
  /// Of every mesh the levels of a binary hierarchy of these volumes, down to 1,024 of them; for `wide`, of the tree
  /// that queries use.
  std::optional<CostVolume> hierarchy{};
  /// Of every mesh the cells of a partition of this kind over its triangles, with the counts of each depth: down to
  /// 4,096 of them, and all as they are.
  std::optional<PartitionKind> partition{};
  /// Of every object, which have to be convex polytopes, the Voronoi regions of its faces, edges and vertices.
  bool voronoi = false;
  /// Of every pair of objects, which have to be convex polytopes, the features that `distance_by_voronoi_walk` visits
  /// from a vertex of each on, one after the other. At most 32 pairs.
  bool voronoi_walk = false;
};

/// One HTML page that shows a scene and what was found in it, whatever was asked: self-contained, so that it opens from
/// disk without a network or a server, in any browser with WebGL 2. It computes no collision; it draws what the answer
/// says: where a report of `check` has faces, these and the curves in which they meet, where it has penetrations and
/// distances, their segments and numbers; ways of rays and what they meet, nearest points, faces in a region; of many
/// poses the objects at the one that is chosen. `models` are the scene's, in its order. Meshes are rounded for display
/// to 1/65535 of their boxes; poses, depths and distances stay exact (docs/reference/view-page.md). Names may hold
/// anything. Throws Error when an object reaches beyond the doubles, and when hierarchies or partitions of more than 32
/// meshes are asked for.
[[nodiscard]] std::string view_page(const Scene& scene, std::span<const SceneInstance> models,
                                    const SceneAnswer& answer, const ViewOptions& options = {},
                                    std::span<const std::string> warnings = {});

/// Writes a page: the file is complete or not there. Throws Error naming the file when it exists and was not written by
/// Toccata, or cannot be written (write_output).
void write_view_page(const std::string& page, const std::filesystem::path& path);

}  // namespace toccata
