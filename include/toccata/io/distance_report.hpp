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

/// JSON by the schema toccata/distance/1 of docs/reference/distance-report.md. Doubles round-trip.
[[nodiscard]] std::string distance_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                               std::span<const ReportedDistance> distances,
                                               std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per pair.
[[nodiscard]] std::string distance_report_csv(const Scene& scene, std::span<const ReportedDistance> distances);

/// What `distance --poses` found: an entry per query in each list.
struct DistancePosesReport {
  std::vector<PairQuery> queries;  ///< as asked: with the objects' own poses
  std::vector<Distance> distances;
};

/// How many of the queries found the two meeting.
[[nodiscard]] std::size_t intersecting_count(const DistancePosesReport& report);

/// JSON by the schema toccata/distance-poses/2 of docs/reference/distance-report.md; `scene` holds A and then B.
[[nodiscard]] std::string distance_poses_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                                     const DistancePosesReport& report,
                                                     std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per query.
[[nodiscard]] std::string distance_poses_report_csv(const DistancePosesReport& report);

}  // namespace toccata
