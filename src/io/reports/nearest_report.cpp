#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include <string_view>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

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
                   {"triangle", one.nearest.element},
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

/// Nothing where the point is inside of none, or that was not asked.
std::string name_of_holder(const Scene& scene, const ReportedPoint& point) {
  if (!point.in_scene || !point.in_scene->inside_of) return "";
  return io::as_utf8(scene.objects[*point.in_scene->inside_of].name);
}

std::string line_of(const Scene& scene, const ReportedPoint& point, std::size_t i) {
  io::Json nearest = io::Json::array();
  for (const ReportedSurfacePoint& one : point.nearest) nearest.push_back(json_of(scene, one));
  io::Json line = {{"number", i}, {"point", io::json_of(point.point)}, {"nearest", std::move(nearest)}};
  if (const auto& found = point.in_scene) {
    line["side"] = name_of(found->distance);
    line["side_by"] = name_of(found->distance.sign_by);
    line["inside_of"] = found->inside_of ? io::Json(name_of_holder(scene, point)) : io::Json();
    line["signed_lower"] = found->distance.lower;
    line["signed_upper"] = found->distance.upper;
  }
  return io::line_of(line);
}

std::string csv_of(const Scene& scene, const ReportedSurfacePoint& one, bool sides) {
  const SurfacePoint& p = one.nearest;
  std::string csv =
      fmt::format("{},{},{},{},{},{},{},{},{}", io::csv_field(io::as_utf8(scene.objects[one.object].name)), p.face,
                  p.element, p.lower, p.upper, p.point.x, p.point.y, p.point.z, name_of(p.status));
  if (!sides) return csv;
  const auto& from = one.signed_distance;
  if (!from) return csv + ",,,,";
  return csv + fmt::format(",{},{},{},{}", name_of(*from), name_of(from->sign_by), from->lower, from->upper);
}

}  // namespace

std::string nearest_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                std::span<const ReportedPoint> points, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/nearest/1", scene, models, warnings)), "points",
                       points.size(), [&](std::size_t i) { return line_of(scene, points[i], i); });
}

std::string nearest_report_csv(const Scene& scene, std::span<const ReportedPoint> points, bool sides) {
  std::string csv = "point,rank,object,face,triangle,lower,upper,x,y,z,status";
  csv += sides ? ",side,side_by,signed_lower,signed_upper,inside_of\n" : "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& nearest = points[i].nearest;
    const std::string end = sides ? "," + io::csv_field(name_of_holder(scene, points[i])) + "\n" : "\n";
    for (std::size_t rank = 0; rank < nearest.size(); ++rank)
      csv += fmt::format("{},{},{}{}", i, rank + 1, csv_of(scene, nearest[rank], sides), end);
    if (nearest.empty()) csv += fmt::format("{},0,,,,,,,,,{}{}", i, sides ? ",,,," : "", end);
  }
  return csv;
}

}  // namespace toccata
