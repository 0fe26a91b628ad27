#include <fmt/format.h>

#include <optional>

#include "answer.hpp"
#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::vector<Vec3> points_asked(const NearestArguments& arguments) {
  if (arguments.points.empty() && !arguments.point)
    throw Error("no point is given: name one with --point X Y Z, or a file with --points");
  if (arguments.points.empty()) return {*arguments.point};
  return read_points(arguments.points);
}

/// Nothing unless it was asked for.
std::string side_text(const std::optional<SignedDistance>& from) {
  if (!from) return "";
  const std::string by = from->sign_by == SignBy::winding_number ? "" : ", by the generalised winding number";
  if (from->side == Side::boundary) return "on it";
  if (from->status == Status::undecided) return "side undecided" + by;
  return (from->side == Side::inside ? "inside" : "outside") + by;
}

std::vector<std::string> row_of(const SceneInstance& surface, const std::string& name, const ReportedSurfacePoint& one,
                                const std::string& point) {
  return {point,
          name,
          surface.model.face_count() > 1 || surface.model.has_mesh() ? fmt::format("face {}", one.nearest.face) : "",
          fmt::format("{:.12g} away", one.nearest.upper),
          "at " + point_text(one.nearest.point),
          side_text(one.signed_distance)};
}

/// Where there are several objects: that which holds the point may be another than the nearest.
std::string holder_text(const std::vector<std::string>& names, const ReportedPoint& point) {
  if (names.size() < 2 || !point.in_scene || !point.in_scene->inside_of) return "";
  const char* how = point.in_scene->distance.status == Status::undecided ? "may be inside " : "is inside ";
  return how + names[*point.in_scene->inside_of];
}

}  // namespace

std::string table_of(const CheckInput& input, const NearestReport& report) {
  const std::vector<ReportedPoint>& points = report.points;
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string point = fmt::format("point {}", i);
    for (const ReportedSurfacePoint& one : points[i].nearest)
      rows.push_back(row_of(input.models[one.object], names[one.object], one, point));
    if (points[i].nearest.empty()) rows.push_back({point, "nothing within the greatest distance", "", "", "", ""});
    if (const std::string holder = holder_text(names, points[i]); !holder.empty())
      rows.push_back({point, holder, "", "", "", ""});
  }
  return columns(rows, 2);
}

int run_nearest(const NearestArguments& arguments) {
  const bool asks_itself = arguments.point || !arguments.points.empty() || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"nearest", asks_itself, false, true})) return *code;
  NearestQuestion question{points_asked(arguments), arguments.k};
  question.sides = arguments.sides;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  if (!arguments.within.empty()) question.within = read_length("--within", arguments.within, input.loaded.scene);
  return exit_code_of(answer_to(question, input, arguments, "looking"));
}

}  // namespace toccata::command
