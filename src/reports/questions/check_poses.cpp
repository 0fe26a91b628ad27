#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/glb/glb_findings.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
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
  if (!report.penetrations.empty()) json["penetration"] = io::json_of(report.penetrations[i], report.depth_ends[i]);
  if (!report.regions.empty()) json["regions"] = io::json_of(report.regions[i]);
  json["pose_a"] = report.queries[i].pose_a.numbers();
  json["pose_b"] = report.queries[i].pose_b.numbers();
  return json;
}

/// What was found at a pose, as that of a pair.
ReportedPair pair_at_pose(const PosesReport& report, std::size_t i) {
  ReportedPair pair;
  pair.a = 0;
  pair.b = 1;
  pair.relation = report.relations[i];
  pair.face_pairs = report.face_pairs[i];
  return pair;
}

struct CheckPosesKind {
  using Question = CheckPosesQuestion;
  using Report = PosesReport;
  static constexpr const char* name = "check-poses";

  static io::Json write(const CheckPosesQuestion& q) {
    io::Json json = {{"touching", io::touching_word(q.touching)}, {"faces", q.faces}, {"penetration", q.penetration}};
    if (q.penetration) io::add_depth_options(json, q.depth);
    io::add_queries(json, q.queries);
    return json;
  }

  static CheckPosesQuestion read(const io::JsonValue& value) {
    value.expect_keys(
        {"question", "touching", "faces", "penetration", "precision", "time_per_depth", "poses", "solid"});
    CheckPosesQuestion q{io::queries_read_from(value), io::touching_of(value), value.flag_or("faces", false),
                         value.flag_or("penetration", false)};
    const DepthOptions depth = io::depth_options_of(value);
    if (q.penetration) q.depth = depth;
    return q;
  }

  static PosesReport ask(const CheckPosesQuestion& question, const io::Asking& asking) {
    asking.require_two();
    const Model &a = asking.models[0].model, &b = asking.models[1].model;
    PosesReport report;
    report.queries = question.queries;
    report.touching = question.touching;
    const Batch<PairQuery> poses(a, b, report.queries);
    report.relations = relation_each(poses, asking.batch());
    if (question.faces) report.counts = count_contacts_each(poses, asking.batch());
    if (!question.penetration) return report;
    for (const DepthBracket& depth : depth_bracket_each(poses, question.depth, asking.batch())) {
      report.penetrations.push_back(depth.penetration);
      report.depth_ends.push_back(depth.end);
    }
    if (a.has_mesh() && b.has_mesh()) report.regions = contact_regions_each(poses, asking.batch());
    return report;
  }

  static std::string json(const PosesReport& report, const io::Reporting& reporting) {
    io::Json head = reporting.head("toccata/check-poses/2");
    head["in_contact"] = contact_count(report);
    return io::with_list(io::document(head), "queries", report.queries.size(),
                         [&](std::size_t i) { return io::line_of(json_of_query(report, i)); });
  }

  static std::string csv(const PosesReport& report, const Scene&) {
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
      csv += has_penetration ? io::csv_of(report.penetrations[i], report.depth_ends[i]) + "\n" : "\n";
    }
    return csv;
  }

  static void mark(const PosesReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.queries.size(); ++i) {
      layers.begin(i);
      if (i < report.face_pairs.size()) io::add_intersecting_faces(layers, 0, 1, report.face_pairs[i]);
      if (!report.penetrations.empty()) io::add_depth(layers, report.penetrations[i]);
      if (!report.regions.empty()) io::add_normals(layers, report.regions[i], std::nullopt);
    }
  }

  static io::Json words(const PosesReport& report, io::PairMethods& methods) {
    io::Json by = {{"relation", methods.number_of(ShapeQuestion::relation, 0, 1)}};
    if (!report.penetrations.empty()) by["penetration"] = methods.number_of(ShapeQuestion::penetration, 0, 1);
    io::Json words = io::Json::array();
    for (std::size_t i = 0; i < report.relations.size(); ++i) {
      io::Json& entry = words.emplace_back(io::words_of(report.relations[i], "is apart from"));
      if (i < report.face_pairs.size())
        entry["face_pairs"] = report.face_pairs[i].size();
      else if (!report.face_pairs.empty())
        entry["face_pairs"] = nullptr;
      entry["methods"] = by;
    }
    return words;
  }

  static void show(const PosesReport& report, io::GlbFindings& nodes) {
    std::vector<std::size_t> at_poses;
    for (std::size_t i = 0; i < std::min(report.face_pairs.size(), report.relations.size()); ++i) {
      if (report.relations[i].kind == RelationKind::apart) continue;
      nodes.add_contacts(pair_at_pose(report, i));
      at_poses.push_back(nodes.at_pose(i, report.queries.size()));
    }
    nodes.glb().add_group("poses", at_poses);
  }
};

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

constinit const io::QuestionKind CheckPosesQuestion::kind = io::question_kind<CheckPosesKind>();

}  // namespace toccata
