#include "toccata/io/nearest_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "io/report_parts.hpp"
#include "io/utf8.hpp"

namespace toccata {
namespace {

std::string_view name_of(const SignedDistance& from) {
  if (from.status == Status::undecided) return "undecided";
  return from.side == Side::inside ? "inside" : from.side == Side::outside ? "outside" : "boundary";
}

std::string_view name_of(SignBy sign_by) {
  return sign_by == SignBy::winding_number ? "winding number" : "generalised winding number";
}

io::Json json_of(const Scene& scene, const ReportedSurfacePoint& one) {
  io::Json json = {{"object", io::as_utf8(scene.objects[one.object].name)},
                   {"object_index", one.object},
                   {"face", one.nearest.face},
                   {"lower", one.nearest.lower},
                   {"upper", one.nearest.upper},
                   {"at", io::json_of(one.nearest.point)},
                   {"status", name_of(one.nearest.status)}};
  if (one.signed_distance) {
    json["side"] = name_of(*one.signed_distance);
    json["side_by"] = name_of(one.signed_distance->sign_by);
    json["signed_lower"] = one.signed_distance->lower;
    json["signed_upper"] = one.signed_distance->upper;
  }
  return json;
}

std::string line_of(const Scene& scene, const ReportedPoint& point, std::size_t i) {
  io::Json nearest = io::Json::array();
  for (const ReportedSurfacePoint& one : point.nearest) nearest.push_back(json_of(scene, one));
  return io::line_of({{"number", i}, {"point", io::json_of(point.point)}, {"nearest", std::move(nearest)}});
}

bool tells_sides(std::span<const ReportedPoint> points) {
  return std::any_of(points.begin(), points.end(), [](const ReportedPoint& point) {
    return !point.nearest.empty() && point.nearest[0].signed_distance.has_value();
  });
}

std::string csv_of(const Scene& scene, const ReportedSurfacePoint& one) {
  const SurfacePoint& p = one.nearest;
  std::string csv = fmt::format("{},{},{},{},{},{},{},{}", io::csv_field(io::as_utf8(scene.objects[one.object].name)),
                                p.face, p.lower, p.upper, p.point.x, p.point.y, p.point.z, name_of(p.status));
  if (const auto& from = one.signed_distance)
    csv += fmt::format(",{},{},{},{}", name_of(*from), name_of(from->sign_by), from->lower, from->upper);
  return csv;
}

}  // namespace

std::string nearest_report_json(const Scene& scene, std::span<const Posed> models,
                                std::span<const ReportedPoint> points, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/nearest/1", scene, models, warnings)), "points",
                       points.size(), [&](std::size_t i) { return line_of(scene, points[i], i); });
}

std::string nearest_report_csv(const Scene& scene, std::span<const ReportedPoint> points) {
  const bool sides = tells_sides(points);
  std::string csv = "point,rank,object,face,lower,upper,x,y,z,status";
  csv += sides ? ",side,side_by,signed_lower,signed_upper\n" : "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& nearest = points[i].nearest;
    for (std::size_t rank = 0; rank < nearest.size(); ++rank)
      csv += fmt::format("{},{},{}\n", i, rank + 1, csv_of(scene, nearest[rank]));
    if (nearest.empty()) csv += fmt::format("{},0,,,,,,,,{}\n", i, sides ? ",,,," : "");
  }
  return csv;
}

}  // namespace toccata
