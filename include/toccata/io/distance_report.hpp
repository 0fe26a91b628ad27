#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

struct ReportedDistance {
  Index a = 0;  ///< the object's place in the scene
  Index b = 0;
  Distance distance;
};

/// JSON by the schema docs/reference/distance-report.md. Doubles round-trip.
[[nodiscard]] std::string distance_report_json(const Scene& scene, std::span<const Posed> models,
                                               std::span<const ReportedDistance> distances,
                                               std::span<const std::string> warnings);

}  // namespace toccata
