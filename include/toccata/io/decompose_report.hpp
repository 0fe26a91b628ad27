#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "toccata/query/check_all.hpp"
#include "toccata/query/convex_parts.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// Into which convex parts the closed mesh of a scene is cut: `decompose`. Of the mesh as it is posed, in the
/// world.
struct DecomposeQuestion {
  std::size_t max_parts = 32;  ///< as DecompositionOptions says
  double concavity = 0;
  friend bool operator==(const DecomposeQuestion&, const DecomposeQuestion&) = default;
};

struct DecomposeReport {
  std::string name;  ///< of the object
  Pose pose;         ///< of its parts: none where they are in the world, as `ask` makes them
  ConvexParts parts;
};

/// The parts as objects, "gear-01" of a gear, of one group: they are not checked against each other.
[[nodiscard]] Scene parts_scene(const DecomposeReport& report, const std::string& unit);

/// JSON by the schema docs/reference/decompose-report.md.
[[nodiscard]] std::string decompose_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                                const DecomposeReport& report, std::span<const std::string> warnings);

}  // namespace toccata
