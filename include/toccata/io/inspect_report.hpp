#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/cost.hpp"
#include "toccata/shapes/mesh_faults.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// An object and how it is, for `inspect`.
struct InspectedObject {
  SceneObject object;
  std::optional<MeshHealth> health;  ///< of meshes and height fields
  bool solid = false;                ///< what a check takes it for
  /// Contains the object in the world; exact but for shapes with a radius and compounds. None for a half-space, which
  /// has no end, and where the pose is refused.
  std::optional<Aabb> world_box;
  std::string refusal;  ///< why no question can be asked about it where it is; else empty
  /// What `measure_volumes` tells of its mesh, where that is asked for; `inspect` leaves it empty.
  std::vector<VolumeCost> volumes{};
  std::vector<PartitionCost> partitions{};  ///< what `measure_partitions` tells of its triangles, the same way
  std::vector<MeshFault> faults{};          ///< what `mesh_faults` tells of its mesh, the same way
};

/// Everything that `inspect` tells about the object.
[[nodiscard]] InspectedObject inspect(const SceneObject& object);

/// "boundary_edges", "non_manifold_edges", "flipped_edges", "degenerate_triangles", "duplicate_triangles",
/// "unused_vertices".
[[nodiscard]] std::string name_of(MeshFaultKind kind);

/// JSON by the schema docs/reference/inspect-report.md.
[[nodiscard]] std::string inspect_report_json(std::span<const InspectedObject> objects, const std::string& unit,
                                              std::span<const std::string> warnings);

}  // namespace toccata
