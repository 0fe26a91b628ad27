#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/formats/number_rows.hpp"
#include "io/formats/utf8.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

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

/// A distance beyond the doubles is not told by one.
void check_finite(std::span<const SceneInstance> models, const std::vector<ReportedPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const ReportedSurfacePoint& one : points[i].nearest)
      if (!std::isfinite(one.nearest.upper))
        throw Error(fmt::format("'{}': point {}: it is farther away than a double can tell (1.8e308)",
                                models[one.object].name, i));
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
std::vector<std::size_t> points_near(Index object, const std::vector<ReportedPoint>& points) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::any_of(points[i].nearest.begin(), points[i].nearest.end(),
                    [&](const ReportedSurfacePoint& one) { return one.object == object; }))
      near.push_back(i);
  return near;
}

/// On which side of each object found every point is, once for each.
void find_sides(std::span<const SceneInstance> models, const BatchOptions& batch, std::vector<ReportedPoint>& points) {
  for (std::size_t place = 0; place < models.size(); ++place) {
    const auto object = static_cast<Index>(place);
    const std::vector<std::size_t> near = points_near(object, points);
    if (near.empty()) continue;
    std::vector<Vec3> asked;
    for (const std::size_t i : near) asked.push_back(points[i].point);
    const SceneInstance& surface = models[place];
    const auto sides = io::asked_of(surface.name, [&] {
      return signed_distance_each(asked, surface.model, surface.pose, SignBy::automatic, batch);
    });
    for (std::size_t n = 0; n < near.size(); ++n)
      for (ReportedSurfacePoint& one : points[near[n]].nearest)
        if (one.object == object) one.signed_distance = with_side(one.nearest, sides[n]);
  }
}

struct NearestKind {
  using Question = NearestQuestion;
  using Report = NearestReport;
  static constexpr const char* name = "nearest";

  static io::Json write(const NearestQuestion& q) {
    std::vector<double> numbers;
    for (const Vec3& point : q.points) io::append(numbers, point);
    return {{"points", io::json_of_rows(numbers, 3)},
            {"k", q.k},
            {"within", io::json_of_length(q.within)},
            {"signed", q.sides}};
  }

  static NearestQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "points", "k", "within", "signed"});
    const std::vector<double> numbers = io::rows_of_numbers(value.at("points"), 3, "point");
    NearestQuestion q;
    for (std::size_t i = 0; i < numbers.size(); i += 3) q.points.push_back(io::vector_at(numbers, i));
    q.k = value.whole_or("k", 1'000'000, 1);
    if (q.k == 0) value.at("k").fail("none is asked for", "write 1 or more");
    if (value.has("within")) q.within = io::length_of(value.at("within"));
    q.sides = value.flag_or("signed", false);
    return q;
  }

  static NearestReport ask(const NearestQuestion& question, const io::Asking& asking) {
    const auto found = nearest_points_each(question.points, question.k, asking.models, question.within, asking.batch());
    std::vector<ReportedPoint> points;
    for (std::size_t i = 0; i < found.size(); ++i) {
      points.push_back({question.points[i], {}});
      for (const ScenePoint& one : found[i]) points.back().nearest.push_back({one.nearest, one.object});
    }
    check_finite(asking.models, points);
    if (!question.sides) return {std::move(points), false};
    find_sides(asking.models, asking.batch(), points);
    const auto of_scene = signed_distance_each(question.points, asking.models, SignBy::automatic, asking.batch());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].in_scene = of_scene[i];
    return {std::move(points), true};
  }

  static std::string json(const NearestReport& report, const io::Reporting& reporting) {
    return io::with_list(io::document(reporting.head("toccata/nearest/1")), "points", report.points.size(),
                         [&](std::size_t i) { return line_of(reporting.scene, report.points[i], i); });
  }

  static std::string csv(const NearestReport& report, const Scene& scene) {
    std::string csv = "point,rank,object,face,triangle,lower,upper,x,y,z,status";
    csv += report.sides ? ",side,side_by,signed_lower,signed_upper,inside_of\n" : "\n";
    for (std::size_t i = 0; i < report.points.size(); ++i) {
      const auto& nearest = report.points[i].nearest;
      const std::string end = report.sides ? "," + io::csv_field(name_of_holder(scene, report.points[i])) + "\n" : "\n";
      for (std::size_t rank = 0; rank < nearest.size(); ++rank)
        csv += fmt::format("{},{},{}{}", i, rank + 1, csv_of(scene, nearest[rank], report.sides), end);
      if (nearest.empty()) csv += fmt::format("{},0,,,,,,,,,{}{}", i, report.sides ? ",,,," : "", end);
    }
    return csv;
  }

  static void mark(const NearestReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.points.size(); ++i) {
      layers.begin(i);
      layers.add_points("asked", std::array{report.points[i].point});
      for (const ReportedSurfacePoint& one : report.points[i].nearest)
        layers.add_length("distance", report.points[i].point, one.nearest.point, one.nearest.upper);
    }
  }

  static void show(const NearestReport& report, io::GlbFindings& nodes) {
    for (std::size_t i = 0; i < report.points.size(); ++i)
      for (const ReportedSurfacePoint& one : report.points[i].nearest)
        nodes.add_node(
            fmt::format("point {} to {}", i, nodes.glb().name_of(one.object)),
            std::vector<io::Shown>{{{report.points[i].point, one.nearest.point}, io::GlbMode::lines, io::lengths}},
            {{"distance", one.nearest.upper}});
    nodes.glb().add_group("points", nodes.nodes());
  }
};

}  // namespace

constinit const io::QuestionKind NearestQuestion::kind = io::question_kind<NearestKind>();

}  // namespace toccata
