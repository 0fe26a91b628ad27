#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// What of a scene lies within a region: of the object at that place in the scene.
struct ReportedFaces {
  Index object = 0;
  std::vector<FoundElement> found;
};

/// JSON by the schema toccata/faces/1 of docs/reference/faces-report.md. Doubles round-trip.
[[nodiscard]] std::string faces_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                            const Region& region, std::span<const ReportedFaces> found,
                                            std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per face, with the number of its triangles that were found.
[[nodiscard]] std::string faces_report_csv(const Scene& scene, std::span<const ReportedFaces> found);

}  // namespace toccata
