#include "toccata/io/nearest_report.hpp"

#include <fmt/format.h>

#include "io/report_parts.hpp"
#include "io/utf8.hpp"

namespace toccata {
namespace {

io::Json json_of(const Scene& scene, const ReportedSurfacePoint& one) {
  return {{"object", io::as_utf8(scene.objects[one.object].name)},
          {"object_index", one.object},
          {"face", one.nearest.face},
          {"lower", one.nearest.lower},
          {"upper", one.nearest.upper},
          {"at", io::json_of(one.nearest.point)},
          {"status", name_of(one.nearest.status)}};
}

std::string line_of(const Scene& scene, const ReportedPoint& point, std::size_t i) {
  io::Json nearest = io::Json::array();
  for (const ReportedSurfacePoint& one : point.nearest) nearest.push_back(json_of(scene, one));
  return io::line_of({{"number", i}, {"point", io::json_of(point.point)}, {"nearest", std::move(nearest)}});
}

std::string csv_of(const Scene& scene, const ReportedSurfacePoint& one) {
  const SurfacePoint& p = one.nearest;
  return fmt::format("{},{},{},{},{},{},{},{}", io::csv_field(io::as_utf8(scene.objects[one.object].name)), p.face,
                     p.lower, p.upper, p.point.x, p.point.y, p.point.z, name_of(p.status));
}

}  // namespace

std::string nearest_report_json(const Scene& scene, std::span<const Posed> models,
                                std::span<const ReportedPoint> points, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/nearest/1", scene, models, warnings)), "points",
                       points.size(), [&](std::size_t i) { return line_of(scene, points[i], i); });
}

std::string nearest_report_csv(const Scene& scene, std::span<const ReportedPoint> points) {
  std::string csv = "point,rank,object,face,lower,upper,x,y,z,status\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& nearest = points[i].nearest;
    for (std::size_t rank = 0; rank < nearest.size(); ++rank)
      csv += fmt::format("{},{},{}\n", i, rank + 1, csv_of(scene, nearest[rank]));
    if (nearest.empty()) csv += fmt::format("{},0,,,,,,,,\n", i);
  }
  return csv;
}

}  // namespace toccata
