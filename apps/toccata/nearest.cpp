#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "load.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct NearestArguments : PosedArguments {
  std::optional<Vec3> point;
  std::string points;  ///< a file of points; empty: `point`
  std::size_t k = 1;
  std::string within;                    ///< a length; empty: any
  bool sides = false;                    ///< tells on which side of the surface each point is
  std::vector<std::string> point_words;  ///< as it is written
};

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

int run_nearest(const NearestArguments& arguments) {
  const bool asks_itself = arguments.point || !arguments.points.empty() || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"nearest", asks_itself, false, true})) return *code;
  NearestQuestion question{points_asked(arguments), arguments.k};
  question.sides = arguments.sides;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  if (!arguments.within.empty()) question.within = read_length("--within", arguments.within, {input.loaded.scene.unit});
  return exit_code_of(answer_to(question, input, arguments, "looking"));
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

Summary summary_of(const NearestReport& report) { return {counted(report.points.size(), "point")}; }

Subcommand add_nearest(CLI::App& app) {
  const auto arguments = std::make_shared<NearestArguments>();
  CLI::App* nearest = app.add_subcommand("nearest", "which point of a surface is nearest to a point, certified");
  add_input(*nearest, arguments->input, any_files);
  CLI::Option* point = add_point(*nearest, "--point", arguments->point_words, "the point, in the world");
  add_file(*nearest, "--points", arguments->points, "many points: a file with three numbers a line")->excludes(point);
  nearest->add_option("--k", arguments->k, "so many nearest triangles, nearest first")
      ->check(whole_number(1, 1'000'000))
      ->type_name("NUMBER");
  add_length(*nearest, "--within", arguments->within,
             "leave out what is farther away: a length in units of the scene or with its own (0.5, 2mm, 0.1in); "
             "all: nothing is");
  nearest->add_flag(
      "--signed", arguments->sides,
      "tell on which side of the surface the point is, and inside of which object: exactly of closed meshes "
      "and other solids, by the generalised winding number of an open mesh");
  add_writing(*nearest, *arguments, "docs/reference/nearest-report.md");
  nearest->footer(
      with_name("Of solids, too, it is a point of the surface.\n\nExit code: 0 answered, 2 trouble.\n\nExample:\n"
                "  {0} nearest part.stl --point 0 0 5\n"
                "  {0} nearest part.stl --points points.txt --k 3 --within 0.5 --csv"));
  return {nearest, [arguments] {
            if (!arguments->point_words.empty()) arguments->point = parse_point(arguments->point_words, "--point");
            return run_nearest(*arguments);
          }};
}

}  // namespace toccata::command
