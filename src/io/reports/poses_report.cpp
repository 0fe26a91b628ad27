#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

namespace {

io::Json json_of_query(const PosesReport& report, std::size_t i) {
  const Relation& relation = report.relations[i];
  io::Json json = {{"query", i},
                   {"relation", name_of(relation.kind)},
                   {"containment", name_of(relation.containment)},
                   {"side_unresolved", relation.side_unresolved},
                   {"status", name_of(relation.status)},
                   {"contact", counts_as_contact(relation, report.touching)}};
  if (!report.counts.empty()) json["face_pairs"] = report.counts[i].face_pairs;
  if (!report.penetrations.empty()) json["penetration"] = io::json_of(report.penetrations[i]);
  if (!report.regions.empty()) json["regions"] = io::json_of(report.regions[i]);
  json["pose_a"] = report.queries[i].pose_a.numbers();
  json["pose_b"] = report.queries[i].pose_b.numbers();
  return json;
}

}  // namespace

std::size_t contact_count(const PosesReport& report) {
  return static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(),
                    [&](const Relation& relation) { return counts_as_contact(relation, report.touching); }));
}

PosesReport with_face_pairs(PosesReport report, std::span<const SceneInstance> models, std::size_t most) {
  SceneInstance a = models[0], b = models[1];
  report.face_pairs.clear();
  std::size_t total = 0;
  for (std::size_t i = 0; i < report.queries.size(); ++i) {
    std::vector<ReportedFacePair> found;
    if (report.relations[i].kind != RelationKind::apart) {
      a.pose = report.queries[i].pose_a;
      b.pose = report.queries[i].pose_b;
      found = io::reported_face_pairs(a, b, contacts(a.model, b.model, report.queries[i]));
    }
    total += found.size();
    if (total > most) break;
    report.face_pairs.push_back(std::move(found));
  }
  return report;
}

std::string poses_report_json(const Scene& scene, std::span<const SceneInstance> models, const PosesReport& report,
                              std::span<const std::string> warnings) {
  io::Json head = io::report_head("toccata/check-poses/2", scene, models, warnings);
  head["in_contact"] = contact_count(report);
  return io::with_list(io::document(head), "queries", report.queries.size(),
                       [&](std::size_t i) { return io::line_of(json_of_query(report, i)); });
}

std::string poses_report_csv(const PosesReport& report) {
  const bool has_faces = !report.counts.empty(), has_penetration = !report.penetrations.empty();
  std::string csv = "query,relation,containment,side_unresolved,status,contact";
  csv += has_faces ? ",face_pairs" : "";
  csv += io::csv_penetration_head(has_penetration);
  for (std::size_t i = 0; i < report.queries.size(); ++i) {
    const Relation& relation = report.relations[i];
    csv +=
        fmt::format("{},{},{},{},{},{}", i, name_of(relation.kind), name_of(relation.containment),
                    relation.side_unresolved, name_of(relation.status), counts_as_contact(relation, report.touching));
    csv += has_faces ? fmt::format(",{}", report.counts[i].face_pairs) : "";
    csv += has_penetration ? io::csv_of(report.penetrations[i]) + "\n" : "\n";
  }
  return csv;
}

}  // namespace toccata
