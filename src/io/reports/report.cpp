#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

using io::csv_field;
using io::document;
using io::Json;
using io::json_of;
using io::json_of_length;

constexpr std::array<std::string_view, 11> distance_fields = {
    "lower", "upper", "on_a_x", "on_a_y", "on_a_z", "on_b_x", "on_b_y", "on_b_z", "face_a", "face_b", "status"};

Json json_of(const PairClearance& pair, const Scene& scene) {
  const auto [first, second] = std::minmax(pair.a, pair.b);
  return {{"a", io::as_utf8(scene.objects[first].name)},
          {"b", io::as_utf8(scene.objects[second].name)},
          {"a_index", first},
          {"b_index", second},
          {"clearance", json_of_length(pair.clearance)}};
}

/// What was asked about distances, where something was.
void add_clearances(Json& json, const Scene& scene, const CheckReport& report) {
  if (!report.clearance) return;
  json["clearance"] = json_of_length(*report.clearance);
  if (report.pair_clearances.empty()) return;
  Json& pairs = json["pair_clearances"] = Json::array();
  for (const PairClearance& pair : report.pair_clearances) pairs.push_back(json_of(pair, scene));
}

/// A line, and where the report has faces one more for each pair of them.
std::string text_of(const ReportedPair& pair, const Scene& scene, const CheckReport& report) {
  const std::string first = io::as_utf8(scene.objects[pair.a].name), second = io::as_utf8(scene.objects[pair.b].name);
  Json line = {{"a", first},
               {"b", second},
               {"a_index", pair.a},
               {"b_index", pair.b},
               {"relation", name_of(pair.relation.kind)},
               {"containment", name_of(pair.relation.containment)},
               {"side_unresolved", pair.relation.side_unresolved},
               {"status", name_of(pair.relation.status)}};
  if (report.has_penetration) {
    line["penetration"] = pair.penetration ? json_of(*pair.penetration) : Json();
    line["manifold"] = pair.manifold ? json_of(*pair.manifold) : Json();
    if (!pair.manifolds.empty()) line["manifolds"] = io::json_of(pair.manifolds);
    line["regions"] = io::json_of(pair.regions);
  }
  if (report.clearance && pair.distance) io::add(line["distance"] = Json::object(), *pair.distance);
  std::string text = io::line_of(line);
  if (!report.has_faces) return text;
  text.back() = ',';
  text += "\"faces\":[";
  for (std::size_t i = 0; i < pair.face_pairs.size(); ++i)
    text += (i == 0 ? "\n      " : ",\n      ") + io::line_of(json_of(pair.face_pairs[i]));
  return text + "]}";
}

std::string csv_names(const Scene& scene, const ReportedPair& pair) {
  return csv_field(io::as_utf8(scene.objects[pair.a].name)) + "," + csv_field(io::as_utf8(scene.objects[pair.b].name));
}

/// The end of a line: what is told of pairs besides, where it is.
std::string csv_end_names(const CheckReport& report) {
  std::string names = io::csv_penetration_head(report.has_penetration);
  if (!report.clearance) return names;
  names.pop_back();
  for (const std::string_view name : distance_fields) names += fmt::format(",distance_{}", name);
  return names + "\n";
}

/// Empty fields where there is none.
std::string csv_of_distance(const ReportedPair& pair) {
  return pair.distance ? io::csv_of(*pair.distance) : std::string(distance_fields.size(), ',');
}

std::string csv_end(const CheckReport& report, const ReportedPair& pair) {
  return (report.has_penetration ? io::csv_of(pair.penetration) : "") +
         (report.clearance ? csv_of_distance(pair) : "") + "\n";
}

std::string csv_of_pairs(const Scene& scene, const CheckReport& report) {
  std::string csv = "a,b,relation,containment,side_unresolved,status" + csv_end_names(report);
  for (const ReportedPair& pair : report.pairs)
    csv +=
        fmt::format("{},{},{},{},{}", csv_names(scene, pair), name_of(pair.relation.kind),
                    name_of(pair.relation.containment), pair.relation.side_unresolved, name_of(pair.relation.status)) +
        csv_end(report, pair);
  return csv;
}

/// A pair without meeting faces (one solid inside the other) still has its line, with empty face fields.
std::string csv_of_faces(const Scene& scene, const CheckReport& report) {
  std::string csv = "a,b,relation,containment,face_a,face_b,crossing" + csv_end_names(report);
  for (const ReportedPair& pair : report.pairs) {
    const std::string start = fmt::format("{},{},{}", csv_names(scene, pair), name_of(pair.relation.kind),
                                          name_of(pair.relation.containment));
    const std::string end = csv_end(report, pair);
    if (pair.face_pairs.empty()) csv += start + ",,," + end;
    for (const ReportedFacePair& faces : pair.face_pairs)
      csv += fmt::format("{},{},{},{}", start, faces.face_a, faces.face_b, faces.crossing) + end;
  }
  return csv;
}

}  // namespace

std::string name_of(RelationKind kind) {
  switch (kind) {
    case RelationKind::apart:
      return "apart";
    case RelationKind::touching:
      return "touching";
    case RelationKind::overlapping:
      return "overlapping";
    case RelationKind::crossing:
      return "crossing";
  }
  return {};
}

std::string name_of(Containment containment) {
  switch (containment) {
    case Containment::none:
      return "none";
    case Containment::a_in_b:
      return "a_in_b";
    case Containment::b_in_a:
      return "b_in_a";
    case Containment::equal:
      return "equal";
  }
  return {};
}

std::string name_of(IntersectionKind kind) {
  switch (kind) {
    case IntersectionKind::none:
      return "none";
    case IntersectionKind::point:
      return "point";
    case IntersectionKind::segment:
      return "segment";
    case IntersectionKind::polygon:
      return "polygon";
  }
  return {};
}

std::string name_of(Status status) {
  switch (status) {
    case Status::exact:
      return "exact";
    case Status::undecided:
      return "undecided";
    case Status::not_converged:
      return "not_converged";
  }
  return {};
}

bool counts_as_contact(const Relation& relation, Touching touching) {
  if (relation.kind == RelationKind::apart) return false;
  return relation.kind != RelationKind::touching || touching == Touching::count || relation.side_unresolved ||
         relation.status != Status::exact;
}

CheckReport make_check_report(std::span<const SceneInstance> models, const CheckAnswer& answer,
                              const ReportOptions& options) {
  const bool asks_clearance = options.clearance || !options.pair_clearances.empty();
  if (asks_clearance && options.touching == Touching::ignore)
    throw Error("pairs that touch are nearer than any clearance, so they cannot be ignored where one is asked for");
  CheckReport report;
  report.candidate_pairs = answer.candidate_pairs;
  report.has_faces = options.faces;
  report.has_penetration = options.penetration;
  if (asks_clearance) report.clearance = options.clearance.value_or(0);
  report.pair_clearances = options.pair_clearances;
  for (const PairAnswer& pair : answer.pairs) {
    const bool is_near = pair.relation.kind == RelationKind::apart && pair.distance;
    if (!is_near && !counts_as_contact(pair.relation, options.touching)) {
      ++report.ignored_touching;
      continue;
    }
    ReportedPair& reported = report.pairs.emplace_back();
    reported.a = pair.a;
    reported.b = pair.b;
    reported.relation = pair.relation;
    if (options.faces) reported.face_pairs = io::reported_face_pairs(models[pair.a], models[pair.b], pair.contacts);
    reported.penetration = pair.penetration;
    reported.manifold = pair.manifold;
    reported.manifolds = pair.manifolds;
    reported.regions = pair.regions;
    reported.distance = pair.distance;
  }
  return report;
}

std::string check_report_json(const Scene& scene, std::span<const SceneInstance> models, const CheckReport& report,
                              std::span<const std::string> warnings) {
  Json json = io::report_head("toccata/check/2", scene, models, warnings);
  json["candidate_pairs"] = report.candidate_pairs;
  json["ignored_touching"] = report.ignored_touching;
  add_clearances(json, scene, report);
  return io::with_list(document(json), "pairs", report.pairs.size(),
                       [&](std::size_t i) { return text_of(report.pairs[i], scene, report); });
}

std::string joined_reports_json(std::span<const NamedReport> reports) {
  std::string text = "{";
  for (std::size_t i = 0; i < reports.size(); ++i) {
    std::string_view json = reports[i].json;
    if (json.ends_with('\n')) json.remove_suffix(1);
    text += (i == 0 ? "\n" : ",\n") + io::line_of(io::as_utf8(reports[i].name)) + ": " + std::string(json);
  }
  return text + "\n}\n";
}

std::string check_report_csv(const Scene& scene, const CheckReport& report) {
  return report.has_faces ? csv_of_faces(scene, report) : csv_of_pairs(scene, report);
}

}  // namespace toccata
