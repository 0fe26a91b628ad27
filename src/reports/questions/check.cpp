#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "io/formats/utf8.hpp"
#include "query/scenes/check_wanted.hpp"
#include "reports/baseline.hpp"
#include "reports/by_winding.hpp"
#include "reports/clash_groups.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/name_rules.hpp"
#include "reports/pair_motion.hpp"
#include "reports/pair_order.hpp"
#include "reports/questions/found_report.hpp"
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

constexpr std::string_view volume_fields = ",kind,volume_lower,volume_upper,point_x,point_y,point_z,piercing";
constexpr std::string_view tolerance_fields = ",tolerance,tolerance_by,local_depth_lower,local_depth_upper";

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
  for (const Since since : {Since::added, Since::known, Since::moved, Since::graver})
    baseline[name_of(since)] = std::count_if(report.pairs.begin(), report.pairs.end(),
                                             [&](const ReportedPair& pair) { return since_baseline(pair) == since; });
  io::Json& gone = baseline["gone"] = io::Json::array();
  for (const GonePair& pair : report.gone) {
    gone.push_back(io::json_of(pair.was));
    gone.back()["reason"] = name_of(pair.reason);
  }
}

void add_boxes(io::Json& json, std::vector<io::Json> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].is_null()) json["objects"][i]["box"] = std::move(boxes[i]);
}

/// What was asked about tolerances, where something was, and which clashes belong together.
void add_tolerance_and_groups(io::Json& json, const Scene& scene, const CheckReport& report) {
  if (report.tolerance) {
    json["tolerance"] = *report.tolerance;
    json["within_tolerance"] = std::count_if(report.pairs.begin(), report.pairs.end(), [](const ReportedPair& pair) {
      return pair.tolerance == ToleranceVerdict::within;
    });
  }
  if (report.grouping == ClashGrouping::none) return;
  json["group_by"] = name_of(report.grouping);
  io::Json& groups = json["groups"] = io::Json::array();
  for (const ClashGroup& group : report.groups) {
    io::Json entry = {
        {"lower", io::json_of(group.place.lower)}, {"upper", io::json_of(group.place.upper)}, {"pairs", group.pairs}};
    if (group.part) {
      entry["part"] = io::as_utf8(scene.objects[*group.part].name);
      entry["part_index"] = *group.part;
    }
    groups.push_back(std::move(entry));
  }
}

/// What is told of the volume that they have in common, and with it.
void add_common_volume(io::Json& line, const ReportedPair& pair) {
  line["kind"] = name_of(pair.kind);
  line["volume"] = pair.volume ? io::Json{{"lower", pair.volume->lower},
                                          {"upper", pair.volume->upper},
                                          {"status", name_of(pair.volume->status)}}
                               : io::Json();
  line["point"] = pair.common_point ? io::json_of(*pair.common_point) : io::Json();
  if (pair.piercing != ClashPiercing::none) line["piercing"] = name_of(pair.piercing);
}

/// How an overlap stands to its tolerance, and by which depth.
void add_verdict(io::Json& line, const ReportedPair& pair) {
  line["tolerance"] = name_of(pair.tolerance);
  if (const std::string by = tolerance_decided_by(pair); !by.empty()) line["tolerance_by"] = by;
  if (pair.local_depth) line["local_depth"] = {{"lower", pair.local_depth->lower}, {"upper", pair.local_depth->upper}};
}

/// How a pair stands against the baseline; with what it was, where that was something else, and how far it has moved.
void add_since(io::Json& line, const ReportedPair& pair) {
  line["baseline"] = name_of(since_baseline(pair));
  if (pair.was && (pair.growth != ClashGrowth::none || pair.was->kind != pair.relation.kind ||
                   pair.was->containment != pair.relation.containment)) {
    line["was"] = {{"relation", name_of(pair.was->kind)}, {"containment", name_of(pair.was->containment)}};
    line["was"].update(io::json_of_extent(*pair.was));
  }
  if (pair.moved_by) line["moved_by"] = *pair.moved_by;
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
  } else if (pair.tolerance != ToleranceVerdict::none) {
    line["penetration"] = pair.penetration ? json_of(*pair.penetration, pair.depth_end) : io::Json();
  }
  if (pair.tolerance != ToleranceVerdict::none) add_verdict(line, pair);
  if (report.has_volume) add_common_volume(line, pair);
  if (report.clearance && pair.distance) {
    io::add(line["distance"] = io::Json::object(), *pair.distance);
    line["clearance"] = json_of_length(pair.clearance);
  }
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
  std::string names = io::csv_penetration_head(report.has_penetration || report.tolerance);
  names.pop_back();
  if (report.tolerance) names += tolerance_fields;
  if (report.has_volume) names += volume_fields;
  if (report.clearance) {
    for (const std::string_view name : distance_fields) names += fmt::format(",distance_{}", name);
    names += ",clearance";
  }
  if (report.baseline) names += ",baseline,was_relation,was_containment,moved_by";
  if (report.grouping != ClashGrouping::none) names += ",group";
  return names + "\n";
}

/// Empty fields where there is none.
std::string csv_of_distance(const ReportedPair& pair) {
  if (!pair.distance) return std::string(distance_fields.size() + 1, ',');
  return io::csv_of(*pair.distance) + "," + (std::isinf(pair.clearance) ? "all" : fmt::format("{}", pair.clearance));
}

std::string csv_of_baseline(const ReportedPair& pair) {
  const std::string was = pair.was ? name_of(pair.was->kind) + "," + name_of(pair.was->containment) : ",";
  return fmt::format(",{},{},{}", name_of(since_baseline(pair)), was,
                     pair.moved_by ? fmt::format("{}", *pair.moved_by) : "");
}

std::string csv_of_volume(const ReportedPair& pair) {
  const std::string volume =
      pair.volume ? fmt::format("{},{}", pair.volume->lower, pair.volume->upper) : std::string(",");
  const std::string point =
      pair.common_point ? fmt::format("{},{},{}", pair.common_point->x, pair.common_point->y, pair.common_point->z)
                        : std::string(",,");
  return "," + name_of(pair.kind) + "," + volume + "," + point + "," +
         (pair.piercing == ClashPiercing::none ? "" : name_of(pair.piercing));
}

std::string csv_of_tolerance(const ReportedPair& pair) {
  const auto end = [](double depth) { return std::isfinite(depth) ? fmt::format("{}", depth) : ""; };
  return "," + (pair.tolerance == ToleranceVerdict::none ? "" : name_of(pair.tolerance)) + "," +
         tolerance_decided_by(pair) + "," +
         (pair.local_depth ? end(pair.local_depth->lower) + "," + end(pair.local_depth->upper) : ",");
}

/// The number of the group of each pair, from 1.
std::vector<std::size_t> group_numbers_of(const CheckReport& report) {
  std::vector<std::size_t> numbers(report.pairs.size());
  for (std::size_t group = 0; group < report.groups.size(); ++group)
    for (const std::size_t pair : report.groups[group].pairs) numbers[pair] = group + 1;
  return numbers;
}

/// `group` is the number of its group, where there are groups.
std::string csv_end(const CheckReport& report, const ReportedPair& pair, std::size_t group) {
  return (report.has_penetration || report.tolerance ? io::csv_of(pair.penetration, pair.depth_end) : "") +
         (report.tolerance ? csv_of_tolerance(pair) : "") + (report.has_volume ? csv_of_volume(pair) : "") +
         (report.clearance ? csv_of_distance(pair) : "") + (report.baseline ? csv_of_baseline(pair) : "") +
         (report.grouping != ClashGrouping::none ? fmt::format(",{}", group) : "") + "\n";
}

/// A line for each pair of the baseline that is gone: in place of the relation why. `fields_of_pair` are those before
/// what `csv_end` tells.
std::string csv_of_gone(const CheckReport& report, std::size_t fields_of_pair) {
  std::string csv;
  const auto count_of = [](std::string_view fields) {
    return static_cast<std::size_t>(std::count(fields.begin(), fields.end(), ','));
  };
  const std::size_t between =
      (report.has_penetration || report.tolerance ? 6 : 0) + (report.tolerance ? count_of(tolerance_fields) : 0) +
      (report.has_volume ? count_of(volume_fields) : 0) + (report.clearance ? distance_fields.size() + 1 : 0);
  for (const GonePair& pair : report.gone)
    csv += fmt::format("{},{},{}{},gone,{},{},{}\n", csv_field(io::as_utf8(pair.was.a)),
                       csv_field(io::as_utf8(pair.was.b)), name_of(pair.reason),
                       std::string(fields_of_pair - 3 + between, ','), name_of(pair.was.kind),
                       name_of(pair.was.containment), report.grouping != ClashGrouping::none ? "," : "");
  return csv;
}

/// A last line of as many fields, where the check was stopped: the others are not all there is.
std::string csv_of_unfinished(const CheckReport& report, const std::string& csv) {
  if (report.unfinished == 0) return {};
  const auto commas = std::count(csv.begin(), std::find(csv.begin(), csv.end(), '\n'), ',');
  return fmt::format("{} {} not looked at,,unfinished{}\n", report.unfinished,
                     report.unfinished == 1 ? "pair" : "pairs", std::string(static_cast<std::size_t>(commas) - 2, ','));
}

std::string csv_of_pairs(const Scene& scene, const CheckReport& report) {
  std::string csv = "a,b,relation,containment,side_unresolved,status" + csv_end_names(report);
  const std::vector<std::size_t> groups = group_numbers_of(report);
  for (std::size_t i = 0; i < report.pairs.size(); ++i) {
    const ReportedPair& pair = report.pairs[i];
    csv +=
        fmt::format("{},{},{},{},{}", csv_names(scene, pair), name_of(pair.relation.kind),
                    name_of(pair.relation.containment), pair.relation.side_unresolved, name_of(pair.relation.status)) +
        csv_end(report, pair, groups[i]);
  }
  return csv + csv_of_gone(report, 6);
}

/// A pair without meeting faces (one solid inside the other) still has its line, with empty face fields.
std::string csv_of_faces(const Scene& scene, const CheckReport& report) {
  std::string csv = "a,b,relation,containment,face_a,face_b,crossing" + csv_end_names(report);
  const std::vector<std::size_t> groups = group_numbers_of(report);
  for (std::size_t i = 0; i < report.pairs.size(); ++i) {
    const ReportedPair& pair = report.pairs[i];
    const std::string start = fmt::format("{},{},{}", csv_names(scene, pair), name_of(pair.relation.kind),
                                          name_of(pair.relation.containment));
    const std::string end = csv_end(report, pair, groups[i]);
    if (pair.face_pairs.empty()) csv += fmt::format("{},,,{}", start, end);
    for (const ReportedFacePair& faces : pair.face_pairs)
      csv += fmt::format("{},{},{},{}", start, faces.face_a, faces.face_b, faces.crossing) + end;
  }
  return csv + csv_of_gone(report, 7);
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

double finite_length_of(const io::JsonValue& value) {
  const double length = value.number();
  if (!(length >= 0)) value.fail("a length is negative", "write 0 or more");
  return length;
}

/// The list of rules that each say a length under that name.
std::vector<LengthRule> length_rules_of(const io::JsonValue& question, const char* list, const char* length) {
  std::vector<LengthRule> rules;
  for (const io::JsonValue& rule : question.elements(list)) {
    rule.expect_keys({"a", "b", length});
    rules.push_back({{patterns_of(rule.at("a")), patterns_of(rule.at("b"))}, finite_length_of(rule.at(length))});
  }
  return rules;
}

void add_length_rules(io::Json& json, const std::vector<LengthRule>& rules, const char* list, const char* length) {
  for (const LengthRule& rule : rules)
    json[list].push_back({{"a", json_of(rule.pairs.a)}, {"b", json_of(rule.pairs.b)}, {length, rule.length}});
}

bool has_bounds(const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis])) return false;
  return true;
}

constexpr std::array clash_groupings = {ClashGrouping::none, ClashGrouping::part, ClashGrouping::region};

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

}  // namespace

namespace io {

CheckPairRules rules_of(const CheckQuestion& question, std::span<const SceneInstance> models) {
  if (!question.rules.empty() && !leave_a_pair(question.rules, models))
    throw Error("nothing would be checked: the rules leave no pair of two objects");
  CheckPairRules rules = pair_rules(question.rules, models);
  require_wanted(question.pair_clearances, rules.wanted, models);
  return rules;
}

CheckReport report_on(const CheckQuestion& question, const Checked& checked, const WantedAnswer& found) {
  CheckReport report = make_check_report(checked.models, found.answer, question);
  report.unfinished = found.unfinished;
  if (question.by_winding && report.unfinished == 0)
    add_contained_by_winding(checked.models, checked.rules.wanted, report);
  if (checked.rules.wanted) report.left_out = found.left_out;
  if (question.baseline)
    compare_with(*question.baseline, checked, found.answer, question.tolerance.value_or(0), report);
  // What was not looked at is not known to be apart.
  if (report.unfinished > 0)
    std::erase_if(report.gone, [](const GonePair& pair) { return pair.reason == GoneReason::apart; });
  if (question.order == PairOrder::severity) sort_by_severity(report.pairs);
  report.grouping = question.grouping;
  report.groups = clash_groups(report.pairs, question.grouping);
  return report;
}

}  // namespace io

namespace {

bool keeps_pairs(const AskOptions& options) { return options.keeps_found || !options.found; }

/// Of the pairs that were told.
struct ToldCounts {
  std::size_t reported = 0;
  std::size_t ignored_touching = 0;
};

/// Those who look on, by the pairs that will be reported.
CheckWatch watch_of(const CheckQuestion& question, const io::Asking& asking, ToldCounts& counts) {
  CheckWatch watch{asking.options.stop, {}, keeps_pairs(asking.options)};
  if (asking.options.found)
    watch.found = [&](const PairAnswer& pair) {
      const CheckReport one = make_check_report(asking.models, {{pair}, 1}, question);
      counts.reported += one.pairs.size();
      counts.ignored_touching += one.ignored_touching;
      if (!one.pairs.empty()) asking.options.found(one);
    };
  return watch;
}

void require_kept(const CheckQuestion& question, const AskOptions& options) {
  const bool needs_all = question.baseline || question.by_winding || question.order != PairOrder::objects ||
                         question.grouping != ClashGrouping::none;
  if (needs_all && !keeps_pairs(options))
    throw Error(
        "a baseline, an order, groups and what is asked by winding need all pairs: they cannot be asked for where "
        "pairs are not kept (AskOptions::keeps_found)");
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
    if (q.volume) json["volume"] = true;
    if (q.tolerance) json["tolerance"] = *q.tolerance;
    add_length_rules(json, q.rules.tolerances, "tolerances", "tolerance");
    add_length_rules(json, q.rules.clearances, "clearances", "clearance");
    if (!q.penetration && (q.tolerance || !q.rules.tolerances.empty())) io::add_depth_options(json, q.depth);
    if (q.grouping != ClashGrouping::none) json["group"] = name_of(q.grouping);
    if (q.order == PairOrder::severity) json["sort"] = "severity";
    if (q.by_winding) json["by_winding"] = true;
    if (q.baseline) json["baseline"] = io::json_of(*q.baseline);
    return json;
  }

  static CheckQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "touching", "faces", "penetration", "precision", "time_per_depth", "clearance",
                       "pair_clearances", "between", "ignore", "sort", "baseline", "by_winding", "volume", "tolerance",
                       "tolerances", "clearances", "group"});
    CheckQuestion q;
    q.touching = io::touching_of(value);
    q.faces = value.flag_or("faces", false);
    q.penetration = value.flag_or("penetration", false);
    const bool has_tolerance = value.has("tolerance") || value.has("tolerances");
    const DepthOptions depth = io::depth_options_of(value, q.penetration || has_tolerance);
    if (q.penetration || has_tolerance) q.depth = depth;
    q.volume = value.flag_or("volume", false);
    if (value.has("tolerance")) q.tolerance = finite_length_of(value.at("tolerance"));
    if (value.has("group")) q.grouping = io::one_named<ClashGrouping>(value.at("group"), clash_groupings);
    if (value.has("clearance")) q.clearance = io::length_of(value.at("clearance"));
    constexpr std::size_t most = std::numeric_limits<Index>::max();
    for (const io::JsonValue& pair : value.elements("pair_clearances")) {
      pair.expect_keys({"a_index", "b_index", "clearance"});
      q.pair_clearances.push_back({static_cast<Index>(pair.at("a_index").whole(most)),
                                   static_cast<Index>(pair.at("b_index").whole(most)),
                                   io::length_of(pair.at("clearance"))});
    }
    q.rules = {rules_of(value, "between"), rules_of(value, "ignore"), length_rules_of(value, "tolerances", "tolerance"),
               length_rules_of(value, "clearances", "clearance")};
    q.order = io::pair_order_of(value);
    q.by_winding = value.flag_or("by_winding", false);
    if (value.has("baseline")) q.baseline = io::baseline_of(value.at("baseline"));
    return q;
  }

  static CheckReport ask(const CheckQuestion& question, const io::Asking& asking) {
    require_kept(question, asking.options);
    CheckOptions options = check_all_options(question);
    options.threads = asking.options.threads;
    options.progress = asking.options.progress;
    const CheckPairRules rules = io::rules_of(question, asking.models);
    ToldCounts counts;
    const WantedAnswer found = check_wanted(asking.models, options, rules, watch_of(question, asking, counts));
    const auto placed = [&](Index model) { return io::placed(asking.models[model]); };
    CheckReport report = io::report_on(question, {asking.models, rules, placed}, found);
    if (keeps_pairs(asking.options)) return report;
    report.not_kept = counts.reported;
    report.ignored_touching = counts.ignored_touching;
    return report;
  }

  static std::string json(const CheckReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/check/2");
    if (report.has_boxes) add_boxes(json, reporting.boxes());
    json["candidate_pairs"] = report.candidate_pairs;
    json["ignored_touching"] = report.ignored_touching;
    add_tolerance_and_groups(json, reporting.scene, report);
    if (report.left_out) json["left_out"] = *report.left_out;
    if (report.unfinished > 0) json["unfinished"] = report.unfinished;
    add_clearances(json, reporting.scene, report);
    add_baseline(json, report);
    return io::with_list(document(json), "pairs", report.pairs.size(),
                         [&](std::size_t i) { return text_of(report.pairs[i], reporting.scene, report); });
  }

  static std::string csv(const CheckReport& report, const Scene& scene) {
    const std::string csv = report.has_faces ? csv_of_faces(scene, report) : csv_of_pairs(scene, report);
    return csv + csv_of_unfinished(report, csv);
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
      io::Json entry =
          io::words_of(pair.relation, is_clash(pair) ? "is closer than its clearance to" : "is apart from");
      if (report.has_faces) entry["face_pairs"] = pair.face_pairs.size();
      if (!is_empty(pair.place) && has_bounds(pair.place))
        entry["place"] = io::Json::array({io::json_of(pair.place.lower), io::json_of(pair.place.upper)});
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
      if (pair.penetration && pair.penetration->upper > 0) nodes.add_depth({pair.a, pair.b}, *pair.penetration);
      if (pair.distance) nodes.add_distance({pair.a, pair.b}, *pair.distance);
    }
    nodes.glb().add_group("pairs", nodes.nodes());
    if (report.unfinished > 0) nodes.glb().add_stopped(report.unfinished);
  }

  static std::vector<io::NamedObjects> named(const CheckReport& report) {
    std::vector<io::NamedObjects> named;
    for (const ReportedPair& pair : report.pairs) named.push_back({pair.a, pair.b});
    return named;
  }

  static void leave_out_drawn(CheckReport& report) { report.has_faces = report.has_boxes = false; }
};

}  // namespace

std::string pair_line_json(const Scene& scene, const CheckReport& report, std::size_t pair) {
  std::string text = text_of(report.pairs[pair], scene, report);
  // Faces are a line each in a report; texts have no line breaks in JSON.
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end))
    text.erase(end, std::min(text.find_first_not_of(" \n", end), text.size()) - end);
  return text;
}

CheckOptions check_all_options(const CheckQuestion& question) {
  CheckOptions options;
  options.contacts = question.faces;
  options.penetration = question.penetration;
  options.depth = question.depth;
  options.volume = question.volume;
  options.tolerance = question.tolerance;
  options.clearance = question.clearance;
  options.pair_clearances = question.pair_clearances;
  return options;
}

constinit const io::QuestionKind CheckQuestion::kind = io::question_kind<CheckKind>();

}  // namespace toccata
