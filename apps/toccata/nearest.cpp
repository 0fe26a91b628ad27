#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/nearest_report.hpp"
#include "toccata/io/points_file.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/signed_distance.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::vector<ReportedPoint> points_asked(const NearestArguments& arguments) {
  std::vector<ReportedPoint> asked;
  if (!(arguments.within >= 0))
    throw Error(fmt::format("--within is {}: give a distance of 0 or more", arguments.within));
  if (arguments.points.empty() && !arguments.point)
    throw Error("no point is given: name one with --point X Y Z, or a file with --points");
  if (arguments.points.empty()) return {{*arguments.point, {}}};
  for (const Vec3& point : read_points(arguments.points)) asked.push_back({point, {}});
  return asked;
}

std::vector<std::vector<SurfacePoint>> nearest_of(const Posed& surface, const std::vector<Vec3>& points,
                                                  const NearestArguments& arguments) {
  const NearestQuery query{.pose = surface.pose, .max_distance = arguments.within};
  BatchOptions options;
  options.threads = arguments.threads;
  try {
    return nearest_points_each(points, arguments.k, surface.model, query, options);
  } catch (const Error& error) {
    throw Error(fmt::format("'{}': {}", surface.name, error.what()));
  }
}

bool comes_before(const ReportedSurfacePoint& a, const ReportedSurfacePoint& b) {
  return std::tie(a.nearest.upper, a.object, a.nearest.element) <
         std::tie(b.nearest.upper, b.object, b.nearest.element);
}

/// Of all objects the k nearest, by (upper, place in the scene, element).
void find_nearest(const CheckInput& input, const NearestArguments& arguments, std::vector<ReportedPoint>& asked) {
  std::vector<Vec3> points;
  for (const ReportedPoint& one : asked) points.push_back(one.point);
  for (std::size_t object = 0; object < input.models.size(); ++object) {
    const auto found = nearest_of(input.models[object], points, arguments);
    for (std::size_t i = 0; i < asked.size(); ++i)
      for (const SurfacePoint& one : found[i]) asked[i].nearest.push_back({one, static_cast<Index>(object)});
  }
  for (ReportedPoint& one : asked) {
    std::sort(one.nearest.begin(), one.nearest.end(), comes_before);
    if (one.nearest.size() > arguments.k) one.nearest.resize(arguments.k);
  }
}

/// On which side of each object found every point is.
void find_sides(const CheckInput& input, std::vector<ReportedPoint>& asked) {
  Workspace workspace;
  for (ReportedPoint& one : asked)
    for (ReportedSurfacePoint& found : one.nearest) {
      const Posed& surface = input.models[found.object];
      try {
        found.signed_distance = signed_distance(one.point, surface.model, surface.pose, SignBy::automatic, workspace);
      } catch (const Error& error) {
        throw Error(fmt::format("'{}': {}", surface.name, error.what()));
      }
    }
}

/// Nothing unless it was asked for.
std::string side_text(const std::optional<SignedDistance>& from) {
  if (!from) return "";
  const std::string by = from->sign_by == SignBy::winding_number ? "" : ", by the generalised winding number";
  if (from->side == Side::boundary) return "on it";
  if (from->status == Status::undecided) return "side undecided" + by;
  return (from->side == Side::inside ? "inside" : "outside") + by;
}

std::vector<std::string> row_of(const CheckInput& input, const ReportedSurfacePoint& one, const std::string& point) {
  const Posed& surface = input.models[one.object];
  return {point,
          printable(surface.name),
          surface.model.has_mesh() ? fmt::format("face {}", one.nearest.face) : "",
          fmt::format("{:.12g} away", one.nearest.upper),
          "at " + point_text(one.nearest.point),
          side_text(one.signed_distance)};
}

std::string nearest_table(const CheckInput& input, const std::vector<ReportedPoint>& points) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string point = fmt::format("point {}", i);
    for (const ReportedSurfacePoint& one : points[i].nearest) rows.push_back(row_of(input, one, point));
    if (points[i].nearest.empty()) rows.push_back({point, "nothing within the greatest distance", "", "", "", ""});
  }
  return columns(rows, 2);
}

std::string text_of(const CheckInput& input, const std::vector<ReportedPoint>& points, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return nearest_report_json(loaded.scene, input.models, points, loaded.warnings);
  return format == Format::csv ? nearest_report_csv(loaded.scene, points) : nearest_table(input, points);
}

}  // namespace

int run_nearest(const NearestArguments& arguments) {
  std::vector<ReportedPoint> points = points_asked(arguments);
  const CheckInput input = read_check_input(arguments);
  find_nearest(input, arguments, points);
  if (arguments.sides) find_sides(input, points);
  const std::string text = text_of(input, points, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return 0;
}

}  // namespace toccata::command
