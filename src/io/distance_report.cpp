#include "toccata/io/distance_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/report_parts.hpp"
#include "io/utf8.hpp"

namespace toccata {
namespace {

constexpr const char* csv_names = "lower,upper,on_a_x,on_a_y,on_a_z,on_b_x,on_b_y,on_b_z,face_a,face_b,status\n";

void add(io::Json& line, const Distance& d) {
  line["lower"] = d.lower;
  line["upper"] = d.upper;
  line["on_a"] = io::json_of(d.on_a);
  line["on_b"] = io::json_of(d.on_b);
  line["face_a"] = d.face_a;
  line["face_b"] = d.face_b;
  line["status"] = name_of(d.status);
}

std::string csv_of(const Distance& d) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", d.lower, d.upper, d.on_a.x, d.on_a.y, d.on_a.z, d.on_b.x,
                     d.on_b.y, d.on_b.z, d.face_a, d.face_b, name_of(d.status));
}

std::string line_of(const ReportedDistance& pair, const Scene& scene) {
  io::Json line = {{"a", io::as_utf8(scene.objects[pair.a].name)},
                   {"b", io::as_utf8(scene.objects[pair.b].name)},
                   {"a_index", pair.a},
                   {"b_index", pair.b}};
  add(line, pair.distance);
  return io::line_of(line);
}

std::string line_of(const DistancePosesReport& report, std::size_t i) {
  io::Json line = {{"query", i}};
  add(line, report.distances[i]);
  line["pose_a"] = report.queries[i].pose_a.numbers();
  line["pose_b"] = report.queries[i].pose_b.numbers();
  return io::line_of(line);
}

}  // namespace

std::string distance_report_json(const Scene& scene, std::span<const Posed> models,
                                 std::span<const ReportedDistance> distances, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/distance/1", scene, models, warnings)), "pairs",
                       distances.size(), [&](std::size_t i) { return line_of(distances[i], scene); });
}

std::string distance_report_csv(const Scene& scene, std::span<const ReportedDistance> distances) {
  std::string csv = std::string("a,b,") + csv_names;
  for (const ReportedDistance& pair : distances)
    csv += io::csv_field(io::as_utf8(scene.objects[pair.a].name)) + "," +
           io::csv_field(io::as_utf8(scene.objects[pair.b].name)) + "," + csv_of(pair.distance);
  return csv;
}

std::size_t meeting_count(const DistancePosesReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.distances.begin(), report.distances.end(), [](const Distance& d) { return d.upper == 0; }));
}

std::string distance_poses_report_json(const Scene& scene, std::span<const Posed> models,
                                       const DistancePosesReport& report, std::span<const std::string> warnings) {
  io::Json head = io::report_head("toccata/distance-poses/1", scene, models, warnings);
  head["meeting"] = meeting_count(report);
  return io::with_list(io::document(head), "queries", report.queries.size(),
                       [&](std::size_t i) { return line_of(report, i); });
}

std::string distance_poses_report_csv(const DistancePosesReport& report) {
  std::string csv = std::string("query,") + csv_names;
  for (std::size_t i = 0; i < report.distances.size(); ++i) csv += fmt::format("{},", i) + csv_of(report.distances[i]);
  return csv;
}

}  // namespace toccata
