#pragma once

#include <span>
#include <string>

#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// A ray at a scene: what it meets first, of the object at that place in the scene.
struct ReportedRay {
  RayQuery query;
  RayHit hit;
  Index object = 0;
};

/// JSON by the schema toccata/ray/1 of docs/reference/ray-report.md. Doubles round-trip.
[[nodiscard]] std::string ray_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                          std::span<const ReportedRay> rays, std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per ray.
[[nodiscard]] std::string ray_report_csv(const Scene& scene, std::span<const ReportedRay> rays);

}  // namespace toccata
