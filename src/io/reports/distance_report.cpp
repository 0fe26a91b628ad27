#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

namespace {

std::string line_of(const ReportedDistance& pair, const Scene& scene) {
  io::Json line = {{"a", io::as_utf8(scene.objects[pair.a].name)},
                   {"b", io::as_utf8(scene.objects[pair.b].name)},
                   {"a_index", pair.a},
                   {"b_index", pair.b}};
  io::add(line, pair.distance);
  return io::line_of(line);
}

std::string line_of(const DistancePosesReport& report, std::size_t i) {
  io::Json line = {{"query", i}};
  io::add(line, report.distances[i]);
  line["pose_a"] = report.queries[i].pose_a.numbers();
  line["pose_b"] = report.queries[i].pose_b.numbers();
  return io::line_of(line);
}

}  // namespace

std::string distance_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                 std::span<const ReportedDistance> distances, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/distance/1", scene, models, warnings)), "pairs",
                       distances.size(), [&](std::size_t i) { return line_of(distances[i], scene); });
}

std::string distance_report_csv(const Scene& scene, std::span<const ReportedDistance> distances) {
  std::string csv = std::string("a,b") + io::csv_distance_names + "\n";
  for (const ReportedDistance& pair : distances)
    csv += io::csv_field(io::as_utf8(scene.objects[pair.a].name)) + "," +
           io::csv_field(io::as_utf8(scene.objects[pair.b].name)) + io::csv_of(pair.distance) + "\n";
  return csv;
}

std::size_t intersecting_count(const DistancePosesReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.distances.begin(), report.distances.end(), [](const Distance& d) { return d.upper == 0; }));
}

std::string distance_poses_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                       const DistancePosesReport& report, std::span<const std::string> warnings) {
  io::Json head = io::report_head("toccata/distance-poses/2", scene, models, warnings);
  head["intersecting"] = intersecting_count(report);
  return io::with_list(io::document(head), "queries", report.queries.size(),
                       [&](std::size_t i) { return line_of(report, i); });
}

std::string distance_poses_report_csv(const DistancePosesReport& report) {
  std::string csv = std::string("query") + io::csv_distance_names + "\n";
  for (std::size_t i = 0; i < report.distances.size(); ++i)
    csv += fmt::format("{}", i) + io::csv_of(report.distances[i]) + "\n";
  return csv;
}

}  // namespace toccata
