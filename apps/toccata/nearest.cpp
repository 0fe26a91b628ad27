#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "arguments.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/nearest_report.hpp"
#include "toccata/io/points_file.hpp"
#include "toccata/query/scene_nearest.hpp"
#include "toccata/query/signed_distance.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::vector<ReportedPoint> points_asked(const NearestArguments& arguments) {
  std::vector<ReportedPoint> asked;
  if (arguments.points.empty() && !arguments.point)
    throw Error("no point is given: name one with --point X Y Z, or a file with --points");
  if (arguments.points.empty()) return {{*arguments.point, {}}};
  for (const Vec3& point : read_points(arguments.points)) asked.push_back({point, {}});
  return asked;
}

BatchOptions on_threads(const NearestArguments& arguments) {
  BatchOptions options;
  options.threads = arguments.threads;
  return options;
}

std::vector<Vec3> positions(const std::vector<ReportedPoint>& asked) {
  std::vector<Vec3> points;
  for (const ReportedPoint& one : asked) points.push_back(one.point);
  return points;
}

/// Of all objects the k nearest, by (upper, place in the scene, element).
void find_nearest(const CheckInput& input, const NearestArguments& arguments, std::vector<ReportedPoint>& asked) {
  const std::vector<Vec3> points = positions(asked);
  const double within = arguments.within.empty() ? std::numeric_limits<double>::infinity()
                                                 : read_length("--within", arguments.within, input.loaded.scene);
  const auto found = nearest_points_each(points, arguments.k, input.models, within, on_threads(arguments));
  for (std::size_t i = 0; i < asked.size(); ++i)
    for (const ScenePoint& one : found[i]) asked[i].nearest.push_back({one.nearest, one.object});
}

/// A distance beyond the doubles is not told by one.
void check_finite(const CheckInput& input, const std::vector<ReportedPoint>& asked) {
  for (std::size_t i = 0; i < asked.size(); ++i)
    for (const ReportedSurfacePoint& one : asked[i].nearest)
      if (!std::isfinite(one.nearest.upper))
        throw Error(fmt::format("'{}': point {}: it is farther away than a double can tell (1.8e308)",
                                input.models[one.object].name, i));
}

/// The distance to an element, with the sign of the side on which the point is of the whole object.
SignedDistance with_side(const SurfacePoint& nearest, SignedDistance from) {
  const bool inside = from.side == Side::inside;
  from.lower = inside ? -nearest.upper : nearest.lower;
  from.upper = !inside || from.status == Status::undecided ? nearest.upper : -nearest.lower;
  from.nearest = nearest.point;
  from.element = nearest.element;
  from.face = nearest.face;
  return from;
}

/// Which points have something of the object among what is nearest to them.
std::vector<std::size_t> points_near(Index object, const std::vector<ReportedPoint>& asked) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (std::any_of(asked[i].nearest.begin(), asked[i].nearest.end(),
                    [&](const ReportedSurfacePoint& one) { return one.object == object; }))
      near.push_back(i);
  return near;
}

/// On which side of all objects together every point is.
void find_side_of_scene(const CheckInput& input, const NearestArguments& arguments, std::vector<ReportedPoint>& asked) {
  const auto found = signed_distance_each(positions(asked), input.models, SignBy::automatic, on_threads(arguments));
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i].in_scene = found[i];
}

/// On which side of each object found every point is, once for each.
void find_sides(const CheckInput& input, const NearestArguments& arguments, std::vector<ReportedPoint>& asked) {
  for (std::size_t place = 0; place < input.models.size(); ++place) {
    const auto object = static_cast<Index>(place);
    const std::vector<std::size_t> near = points_near(object, asked);
    if (near.empty()) continue;
    std::vector<Vec3> points;
    for (const std::size_t i : near) points.push_back(asked[i].point);
    const Posed& surface = input.models[place];
    const auto sides = asked_of(surface.name, [&] {
      return signed_distance_each(points, surface.model, surface.pose, SignBy::automatic, on_threads(arguments));
    });
    for (std::size_t n = 0; n < near.size(); ++n)
      for (ReportedSurfacePoint& one : asked[near[n]].nearest)
        if (one.object == object) one.signed_distance = with_side(one.nearest, sides[n]);
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
          surface.model.face_count() > 1 || surface.model.has_mesh() ? fmt::format("face {}", one.nearest.face) : "",
          fmt::format("{:.12g} away", one.nearest.upper),
          "at " + point_text(one.nearest.point),
          side_text(one.signed_distance)};
}

/// Where there are several objects: that which holds the point may be another than the nearest.
std::string holder_text(const CheckInput& input, const ReportedPoint& point) {
  if (input.models.size() < 2 || !point.in_scene || !point.in_scene->inside_of) return "";
  const char* how = point.in_scene->distance.status == Status::undecided ? "may be inside " : "is inside ";
  return how + printable(input.models[*point.in_scene->inside_of].name);
}

std::string nearest_table(const CheckInput& input, const std::vector<ReportedPoint>& points) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string point = fmt::format("point {}", i);
    for (const ReportedSurfacePoint& one : points[i].nearest) rows.push_back(row_of(input, one, point));
    if (points[i].nearest.empty()) rows.push_back({point, "nothing within the greatest distance", "", "", "", ""});
    if (const std::string holder = holder_text(input, points[i]); !holder.empty())
      rows.push_back({point, holder, "", "", "", ""});
  }
  return columns(rows, 2);
}

std::string text_of(const CheckInput& input, const std::vector<ReportedPoint>& points, Format format, bool sides) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return nearest_report_json(loaded.scene, input.models, points, loaded.warnings);
  return format == Format::csv ? nearest_report_csv(loaded.scene, points, sides) : nearest_table(input, points);
}

}  // namespace

int run_nearest(const NearestArguments& arguments) {
  std::vector<ReportedPoint> points = points_asked(arguments);
  const CheckInput input = read_check_input(arguments);
  find_nearest(input, arguments, points);
  check_finite(input, points);
  if (arguments.sides) {
    find_sides(input, arguments, points);
    find_side_of_scene(input, arguments, points);
  }
  const std::string text = text_of(input, points, arguments.format, arguments.sides);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return 0;
}

}  // namespace toccata::command
