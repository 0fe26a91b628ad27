#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "io/formats/utf8.hpp"
#include "query/scenes/check_wanted.hpp"
#include "reports/baseline.hpp"
#include "reports/by_winding.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/name_rules.hpp"
#include "reports/pair_order.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

using io::csv_field;
using io::document;
using io::json_of;
using io::json_of_length;

constexpr std::array<std::string_view, 11> distance_fields = {
    "lower", "upper", "on_a_x", "on_a_y", "on_a_z", "on_b_x", "on_b_y", "on_b_z", "face_a", "face_b", "status"};

io::Json json_of(const PairClearance& pair, const Scene& scene) {
  const auto [first, second] = std::minmax(pair.a, pair.b);
  return {{"a", io::as_utf8(scene.objects[first].name)},
          {"b", io::as_utf8(scene.objects[second].name)},
          {"a_index", first},
          {"b_index", second},
          {"clearance", json_of_length(pair.clearance)}};
}

/// What was asked about distances, where something was.
void add_clearances(io::Json& json, const Scene& scene, const CheckReport& report) {
  if (!report.clearance) return;
  json["clearance"] = json_of_length(*report.clearance);
  if (report.pair_clearances.empty()) return;
  io::Json& pairs = json["pair_clearances"] = io::Json::array();
  for (const PairClearance& pair : report.pair_clearances) pairs.push_back(json_of(pair, scene));
}

/// What has become of the baseline, where there is one.
void add_baseline(io::Json& json, const CheckReport& report) {
  if (!report.baseline) return;
  io::Json& baseline = json["baseline"] = {{"file", io::as_utf8(*report.baseline)}};
  for (const Since since : {Since::added, Since::known, Since::graver})
    baseline[name_of(since)] = std::count_if(report.pairs.begin(), report.pairs.end(),
                                             [&](const ReportedPair& pair) { return since_baseline(pair) == since; });
  io::Json& gone = baseline["gone"] = io::Json::array();
  for (const GonePair& pair : report.gone) {
    gone.push_back(io::json_of(pair.was));
    gone.back()["reason"] = name_of(pair.reason);
  }
}

/// How a pair stands against the baseline; with what it was, where that was something else.
void add_since(io::Json& line, const ReportedPair& pair) {
  line["baseline"] = name_of(since_baseline(pair));
  if (pair.was && (pair.was->kind != pair.relation.kind || pair.was->containment != pair.relation.containment))
    line["was"] = {{"relation", name_of(pair.was->kind)}, {"containment", name_of(pair.was->containment)}};
}

/// A line, and where the report has faces one more for each pair of them.
std::string text_of(const ReportedPair& pair, const Scene& scene, const CheckReport& report) {
  const std::string first = io::as_utf8(scene.objects[pair.a].name), second = io::as_utf8(scene.objects[pair.b].name);
  io::Json line = {{"a", first},
                   {"b", second},
                   {"a_index", pair.a},
                   {"b_index", pair.b},
                   {"relation", name_of(pair.relation.kind)},
                   {"containment", name_of(pair.relation.containment)},
                   {"side_unresolved", pair.relation.side_unresolved},
                   {"status", name_of(pair.relation.status)}};
  if (report.baseline) add_since(line, pair);
  if (report.has_penetration) {
    line["penetration"] = pair.penetration ? json_of(*pair.penetration, pair.depth_end) : io::Json();
    line["manifold"] = pair.manifold ? json_of(*pair.manifold) : io::Json();
    if (!pair.manifolds.empty()) line["manifolds"] = io::json_of(pair.manifolds);
    line["regions"] = io::json_of(pair.regions);
  }
  if (report.clearance && pair.distance) io::add(line["distance"] = io::Json::object(), *pair.distance);
  if (pair.winding)
    line["winding"] = {{"value", pair.winding->value}, {"lower", pair.winding->lower}, {"upper", pair.winding->upper}};
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
  names.pop_back();
  if (report.clearance)
    for (const std::string_view name : distance_fields) names += fmt::format(",distance_{}", name);
  if (report.baseline) names += ",baseline,was_relation,was_containment";
  return names + "\n";
}

/// Empty fields where there is none.
std::string csv_of_distance(const ReportedPair& pair) {
  return pair.distance ? io::csv_of(*pair.distance) : std::string(distance_fields.size(), ',');
}

std::string csv_of_baseline(const ReportedPair& pair) {
  const std::string was = pair.was ? name_of(pair.was->kind) + "," + name_of(pair.was->containment) : ",";
  return "," + name_of(since_baseline(pair)) + "," + was;
}

std::string csv_end(const CheckReport& report, const ReportedPair& pair) {
  return (report.has_penetration ? io::csv_of(pair.penetration, pair.depth_end) : "") +
         (report.clearance ? csv_of_distance(pair) : "") + (report.baseline ? csv_of_baseline(pair) : "") + "\n";
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

io::Json json_of(const std::vector<std::string>& patterns) {
  io::Json list = io::Json::array();
  for (const std::string& pattern : patterns) list.push_back(io::as_utf8(pattern));
  return list;
}

io::Json json_of(const std::vector<NameRule>& rules) {
  io::Json list = io::Json::array();
  for (const NameRule& rule : rules) list.push_back({{"a", json_of(rule.a)}, {"b", json_of(rule.b)}});
  return list;
}

std::vector<std::string> patterns_of(const io::JsonValue& list) {
  std::vector<std::string> patterns;
  for (const io::JsonValue& pattern : list.elements()) patterns.push_back(pattern.text());
  return patterns;
}

std::vector<NameRule> rules_of(const io::JsonValue& question, const char* key) {
  std::vector<NameRule> rules;
  for (const io::JsonValue& rule : question.elements(key)) {
    rule.expect_keys({"a", "b"});
    rules.push_back({patterns_of(rule.at("a")), patterns_of(rule.at("b"))});
  }
  return rules;
}

/// What the rules leave out has no clearance, as what is of one group has none.
void require_wanted(std::span<const PairClearance> clearances, const PairFilter& wanted,
                    std::span<const SceneInstance> models) {
  for (const PairClearance& pair : clearances) {
    const auto [first, second] = std::minmax(pair.a, pair.b);
    if (!wanted || second >= models.size() || first == second || wanted({first, second})) continue;
    throw Error(
        fmt::format("a clearance is asked for \"{}\" and \"{}\", which the rules leave out: leave out the one or "
                    "the other",
                    models[first].name, models[second].name));
  }
}

/// Those who look on, by the pairs that will be reported.
CheckWatch watch_of(const CheckQuestion& question, const io::Asking& asking) {
  CheckWatch watch{asking.options.stop, {}};
  if (asking.options.found)
    watch.found = [&](const PairAnswer& pair) {
      const CheckReport one = make_check_report(asking.models, {{pair}, 1}, question);
      if (!one.pairs.empty()) asking.options.found(one);
    };
  return watch;
}

struct CheckKind {
  using Question = CheckQuestion;
  using Report = CheckReport;
  static constexpr const char* name = "check";

  static io::Json write(const CheckQuestion& q) {
    io::Json json = {{"touching", io::touching_word(q.touching)}, {"faces", q.faces}, {"penetration", q.penetration}};
    if (q.penetration) io::add_depth_options(json, q.depth);
    if (q.clearance) json["clearance"] = io::json_of_length(*q.clearance);
    for (const PairClearance& pair : q.pair_clearances)
      json["pair_clearances"].push_back(
          {{"a_index", pair.a}, {"b_index", pair.b}, {"clearance", io::json_of_length(pair.clearance)}});
    if (!q.rules.between.empty()) json["between"] = json_of(q.rules.between);
    if (!q.rules.ignored.empty()) json["ignore"] = json_of(q.rules.ignored);
    if (q.order == PairOrder::severity) json["sort"] = "severity";
    if (q.by_winding) json["by_winding"] = true;
    if (q.baseline) json["baseline"] = io::json_of(*q.baseline);
    return json;
  }

  static CheckQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "touching", "faces", "penetration", "precision", "time_limit", "clearance",
                       "pair_clearances", "between", "ignore", "sort", "baseline", "by_winding"});
    CheckQuestion q;
    q.touching = io::touching_of(value);
    q.faces = value.flag_or("faces", false);
    q.penetration = value.flag_or("penetration", false);
    const DepthOptions depth = io::depth_options_of(value);
    if (q.penetration) q.depth = depth;
    if (value.has("clearance")) q.clearance = io::length_of(value.at("clearance"));
    constexpr std::size_t most = std::numeric_limits<Index>::max();
    for (const io::JsonValue& pair : value.elements("pair_clearances")) {
      pair.expect_keys({"a_index", "b_index", "clearance"});
      q.pair_clearances.push_back({static_cast<Index>(pair.at("a_index").whole(most)),
                                   static_cast<Index>(pair.at("b_index").whole(most)),
                                   io::length_of(pair.at("clearance"))});
    }
    q.rules = {rules_of(value, "between"), rules_of(value, "ignore")};
    q.order = io::pair_order_of(value);
    q.by_winding = value.flag_or("by_winding", false);
    if (value.has("baseline")) q.baseline = io::baseline_of(value.at("baseline"));
    return q;
  }

  static CheckReport ask(const CheckQuestion& question, const io::Asking& asking) {
    CheckOptions options;
    options.contacts = question.faces;
    options.penetration = question.penetration;
    options.depth = question.depth;
    options.clearance = question.clearance;
    options.pair_clearances = question.pair_clearances;
    options.threads = asking.options.threads;
    options.progress = asking.options.progress;
    const PairFilter wanted = io::wanted_pairs(question.rules, asking.models);
    require_wanted(question.pair_clearances, wanted, asking.models);
    const WantedAnswer found = check_wanted(asking.models, options, wanted, watch_of(question, asking));
    CheckReport report = make_check_report(asking.models, found.answer, question);
    report.unfinished = found.unfinished;
    if (question.by_winding && report.unfinished == 0) io::add_contained_by_winding(asking.models, wanted, report);
    if (wanted) report.left_out = found.left_out;
    if (question.baseline) io::compare_with(*question.baseline, {asking.models, wanted, found.answer}, report);
    // What was not looked at is not known to be apart.
    if (report.unfinished > 0)
      std::erase_if(report.gone, [](const GonePair& pair) { return pair.reason == GoneReason::apart; });
    if (question.order == PairOrder::severity) io::sort_by_severity(report.pairs);
    return report;
  }

  static std::string json(const CheckReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/check/2");
    json["candidate_pairs"] = report.candidate_pairs;
    json["ignored_touching"] = report.ignored_touching;
    if (report.left_out) json["left_out"] = *report.left_out;
    if (report.unfinished > 0) json["unfinished"] = report.unfinished;
    add_clearances(json, reporting.scene, report);
    add_baseline(json, report);
    return io::with_list(document(json), "pairs", report.pairs.size(),
                         [&](std::size_t i) { return text_of(report.pairs[i], reporting.scene, report); });
  }

  static std::string csv(const CheckReport& report, const Scene& scene) {
    return report.has_faces ? csv_of_faces(scene, report) : csv_of_pairs(scene, report);
  }

  static void mark(const CheckReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.pairs.size(); ++i) {
      const ReportedPair& pair = report.pairs[i];
      layers.begin(i);
      io::add_intersecting_faces(layers, pair.a, pair.b, pair.face_pairs);
      io::add_depth(layers, pair.penetration);
      if (pair.distance) io::add_distance(layers, *pair.distance);
      io::add_normals(layers, pair.regions, pair.manifold);
      for (const ContactManifold& one : pair.manifolds) io::add_normals(layers, {}, one.manifold);
    }
  }

  static io::Json words(const CheckReport& report, io::PairMethods& methods) {
    io::Json words = io::Json::array();
    for (const ReportedPair& pair : report.pairs) {
      io::Json entry = io::words_of(pair.relation, "is closer than its clearance to");
      if (report.has_faces) entry["face_pairs"] = pair.face_pairs.size();
      io::Json& by = entry["methods"] = {{"relation", methods.number_of(ShapeQuestion::relation, pair.a, pair.b)}};
      if (pair.penetration) by["penetration"] = methods.number_of(ShapeQuestion::penetration, pair.a, pair.b);
      if (pair.distance) by["distance"] = methods.number_of(ShapeQuestion::distance, pair.a, pair.b);
      words.push_back(std::move(entry));
    }
    return words;
  }

  static void show(const CheckReport& report, io::GlbFindings& nodes) {
    for (const ReportedPair& pair : report.pairs) {
      if (pair.relation.kind != RelationKind::apart) nodes.add_contacts(pair);
      if (pair.penetration && pair.penetration->upper > 0)
        nodes.add_length("depth", {pair.a, pair.b}, pair.penetration->upper,
                         {pair.penetration->on_a, pair.penetration->on_b});
      if (pair.distance) nodes.add_distance({pair.a, pair.b}, *pair.distance);
    }
    nodes.glb().add_group("pairs", nodes.nodes());
  }

  static std::vector<io::NamedObjects> named(const CheckReport& report) {
    std::vector<io::NamedObjects> named;
    for (const ReportedPair& pair : report.pairs) named.push_back({pair.a, pair.b});
    return named;
  }

  static void leave_out_drawn(CheckReport& report) { report.has_faces = false; }
};

}  // namespace

std::string pair_line_json(const Scene& scene, const CheckReport& report, std::size_t pair) {
  std::string text = text_of(report.pairs[pair], scene, report);
  // Faces are a line each in a report; texts have no line breaks in JSON.
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end))
    text.erase(end, std::min(text.find_first_not_of(" \n", end), text.size()) - end);
  return text;
}

constinit const io::QuestionKind CheckQuestion::kind = io::question_kind<CheckKind>();

}  // namespace toccata
