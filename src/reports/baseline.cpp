#include "reports/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "io/formats/file_bytes.hpp"
#include "io/formats/utf8.hpp"
#include "io/scenes/scene_parts.hpp"
#include "reports/pair_motion.hpp"
#include "reports/questions/question_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {
namespace {

constexpr std::array relation_kinds = {RelationKind::apart, RelationKind::touching, RelationKind::overlapping,
                                       RelationKind::crossing};
constexpr std::array containments = {Containment::none, Containment::a_in_b, Containment::b_in_a, Containment::equal};

FormerPair flipped(FormerPair pair) {
  std::swap(pair.a, pair.b);
  if (pair.containment == Containment::a_in_b)
    pair.containment = Containment::b_in_a;
  else if (pair.containment == Containment::b_in_a)
    pair.containment = Containment::a_in_b;
  return pair;
}

/// An interval, where one is told that has both ends.
template <class Interval>
std::optional<Interval> interval_at(const io::JsonValue& pair, const char* name) {
  if (!pair.has(name) || !pair.at(name).is_object()) return std::nullopt;
  const io::JsonValue ends = pair.at(name);
  if (!ends.at("lower").is_number() || !ends.at("upper").is_number()) return std::nullopt;
  return Interval{ends.at("lower").number(), ends.at("upper").number()};
}

/// As a report tells it, and a question.
FormerPair former_pair_of(const io::JsonValue& pair) {
  return {pair.at("a").text(),
          pair.at("b").text(),
          io::one_named<RelationKind>(pair.at("relation"), relation_kinds),
          io::one_named<Containment>(pair.at("containment"), containments),
          pair.text_or("tolerance", "") == name_of(ToleranceVerdict::within),
          pair.flag_or("demanded", true),
          interval_at<ContactRegion::Depth>(pair, "penetration"),
          interval_at<ContactRegion::Depth>(pair, "local_depth"),
          interval_at<OverlapVolume>(pair, "volume")};
}

template <class Now, class Then>
bool is_larger(const std::optional<Now>& now, const std::optional<Then>& then, double tolerance) {
  constexpr double hundredth = 0.01;  // more than rounding a file's numbers, and what a search leaves open, may change
  return now && then && now->lower > then->upper + std::max(tolerance, hundredth * then->upper);
}

ClashGrowth growth_of(const ReportedPair& pair, const FormerPair& was, double tolerance) {
  if (is_larger(pair.penetration, was.penetration, tolerance)) return ClashGrowth::penetration;
  if (is_larger(pair.local_depth, was.local_depth, tolerance)) return ClashGrowth::local_depth;
  return is_larger(pair.volume, was.volume, 0) ? ClashGrowth::volume : ClashGrowth::none;
}

/// The pairs of a report. Where it told how far apart all are, those that are apart and have no clearance of their own
/// are none that were too near.
std::vector<FormerPair> former_pairs_in(const io::JsonValue& top) {
  const bool tells_all = top.has("clearance") && std::isinf(io::length_of(top.at("clearance")));
  std::set<std::pair<std::string, std::string>> own;
  for (const io::JsonValue& pair : top.elements("pair_clearances"))
    own.emplace(pair.at("a").text(), pair.at("b").text());
  std::vector<FormerPair> pairs;
  for (const io::JsonValue& told : top.elements("pairs")) {
    FormerPair pair = former_pair_of(told);
    if (tells_all && pair.kind == RelationKind::apart && !own.contains({pair.a, pair.b})) pair.demanded = false;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::optional<Aabb> box_of(const io::JsonValue& object) {
  if (!object.has("box")) return std::nullopt;
  const io::JsonValue box = object.at("box");
  return Aabb{box.at("lower").vector(), box.at("upper").vector()};
}

/// As a report tells it, and a question.
FormerObject former_object_of(const io::JsonValue& object) {
  std::array<double, 12> pose{};
  std::ranges::copy(object.at("pose").numbers(pose.size()), pose.begin());
  return {object.at("name").text(), Pose::from_numbers(pose), box_of(object)};
}

/// The pairs of a baseline, and where its objects are among those of now.
class FormerPairs {
 public:
  FormerPairs(const Baseline& baseline, std::span<const SceneInstance> models) {
    for (std::size_t i = 0; i < models.size(); ++i) places_.emplace(models[i].name, static_cast<Index>(i));
    for (const FormerPair& pair : baseline.pairs) {
      const auto place = place_of(pair);
      if (!place) continue;
      const bool is_ascending = places_.at(pair.a) < places_.at(pair.b);
      of_pair_.emplace(*place, is_ascending ? pair : flipped(pair));
    }
  }

  /// Ascending; none where one of the two is not there, or both are one.
  [[nodiscard]] std::optional<IndexPair> place_of(const FormerPair& pair) const {
    const auto a = places_.find(pair.a), b = places_.find(pair.b);
    if (a == places_.end() || b == places_.end() || a == b) return std::nullopt;
    return IndexPair{std::min(a->second, b->second), std::max(a->second, b->second)};
  }

  [[nodiscard]] std::optional<FormerPair> at(const IndexPair& place) const {
    const auto found = of_pair_.find(place);
    return found == of_pair_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::map<std::string_view, Index> places_;
  std::map<IndexPair, FormerPair> of_pair_;
};

/// How the objects of a baseline lay, and those of now lie.
class PlacesSince {
 public:
  PlacesSince(const Baseline& baseline, const io::Checked& checked) : checked_(checked) {
    for (const FormerObject& object : baseline.objects) former_.emplace(object.name, &object);
  }

  /// How far one of two objects of now has moved as seen from the other.
  [[nodiscard]] std::optional<double> moved_by(const IndexPair& pair, double tolerance) {
    const auto a = former_.find(checked_.models[pair.first].name), b = former_.find(checked_.models[pair.second].name);
    if (a == former_.end() || b == former_.end()) return std::nullopt;
    const io::PlacedPair now{of_now(pair.first), of_now(pair.second)};
    const io::PlacedPair then{with_box(*a->second, now.a), with_box(*b->second, now.b)};
    return io::moved_by(then, now, tolerance);
  }

 private:
  const FormerObject& of_now(Index object) {
    const auto found = now_.find(object);
    return found != now_.end() ? found->second : now_.emplace(object, checked_.placed(object)).first->second;
  }

  /// Reports of before told no boxes: it had the same.
  static FormerObject with_box(FormerObject then, const FormerObject& now) {
    if (!then.box) then.box = now.box;
    return then;
  }

  const io::Checked& checked_;
  std::map<std::string_view, const FormerObject*> former_;
  std::map<Index, FormerObject> now_;
};

bool is_answered(const CheckAnswer& answer, const IndexPair& place) {
  const auto found = std::lower_bound(answer.pairs.begin(), answer.pairs.end(), place,
                                      [](const PairAnswer& pair, const IndexPair& other) {
                                        return IndexPair{pair.a, pair.b} < other;
                                      });
  return found != answer.pairs.end() && IndexPair{found->a, found->b} == place;
}

/// Why a pair is not in the report.
GoneReason reason_of(const std::optional<IndexPair>& place, const io::Checked& checked, const CheckAnswer& answer) {
  if (!place) return GoneReason::no_object;
  if (io::in_one_group(checked.models[place->first], checked.models[place->second])) return GoneReason::left_out;
  if (checked.rules.wanted && !checked.rules.wanted(*place)) return GoneReason::left_out;
  return is_answered(answer, *place) ? GoneReason::touching : GoneReason::apart;
}

}  // namespace

namespace io {

Json json_of_extent(const FormerPair& pair) {
  Json json = Json::object();
  const auto tell = [&](const char* name, const auto& interval) {
    if (interval) json[name] = {{"lower", interval->lower}, {"upper", interval->upper}};
  };
  tell("penetration", pair.penetration);
  tell("local_depth", pair.local_depth);
  tell("volume", pair.volume);
  return json;
}

void compare_with(const Baseline& baseline, const Checked& checked, const CheckAnswer& answer, double tolerance,
                  CheckReport& report) {
  const FormerPairs former(baseline, checked.models);
  PlacesSince places(baseline, checked);
  report.baseline = baseline.file;
  std::set<IndexPair> reported;
  for (ReportedPair& pair : report.pairs) {
    const IndexPair place{pair.a, pair.b};
    const std::optional<double> own = checked.rules.tolerances ? checked.rules.tolerances(place) : std::nullopt;
    pair.was = former.at(place);
    if (pair.was) {
      pair.moved_by = places.moved_by(place, own.value_or(tolerance));
      pair.growth = growth_of(pair, *pair.was, own.value_or(tolerance));
    }
    reported.insert(place);
  }
  for (const FormerPair& pair : baseline.pairs) {
    const std::optional<IndexPair> place = former.place_of(pair);
    if (!place || !reported.contains(*place)) report.gone.push_back({pair, reason_of(place, checked, answer)});
  }
}

Json json_of(const FormerPair& pair) {
  Json json = {{"a", as_utf8(pair.a)},
               {"b", as_utf8(pair.b)},
               {"relation", name_of(pair.kind)},
               {"containment", name_of(pair.containment)}};
  if (pair.within_tolerance) json["tolerance"] = name_of(ToleranceVerdict::within);
  if (!pair.demanded) json["demanded"] = false;
  json.update(json_of_extent(pair));
  return json;
}

Json json_of(const FormerObject& object) {
  Json json = {{"name", as_utf8(object.name)}, {"pose", object.pose.numbers()}};
  if (object.box) json["box"] = json_of(*object.box);
  return json;
}

Json json_of(const Baseline& baseline) {
  Json pairs = Json::array();
  for (const FormerPair& pair : baseline.pairs) pairs.push_back(json_of(pair));
  Json json = {{"file", as_utf8(baseline.file)}, {"pairs", std::move(pairs)}};
  for (const FormerObject& object : baseline.objects) json["objects"].push_back(json_of(object));
  return json;
}

Baseline baseline_of(const JsonValue& value) {
  value.expect_keys({"file", "pairs", "objects"});
  Baseline baseline{value.at("file").text(), {}, {}};
  for (const JsonValue& object : value.elements("objects")) {
    object.expect_keys({"name", "pose", "box"});
    baseline.objects.push_back(former_object_of(object));
  }
  for (const JsonValue& pair : value.elements("pairs")) {
    pair.expect_keys(
        {"a", "b", "relation", "containment", "tolerance", "demanded", "penetration", "local_depth", "volume"});
    baseline.pairs.push_back(former_pair_of(pair));
  }
  return baseline;
}

}  // namespace io

namespace {

bool is_report_of_check(const io::JsonValue& top) {
  return top.is_object() && top.has("schema") && top.at("schema").is_string() &&
         top.at("schema").text() == "toccata/check/2";
}

/// Objects are known by their names alone.
void require_common_object(const io::JsonValue& top, const Scene& scene) {
  std::set<std::string_view> names;
  for (const SceneObject& object : scene.objects) names.insert(object.name);
  const std::vector<io::JsonValue> objects = top.elements("objects");
  const auto is_here = [&](const io::JsonValue& object) { return names.contains(object.at("name").text()); };
  if (std::any_of(objects.begin(), objects.end(), is_here)) return;
  top.fail(fmt::format("this report is about another model: none of its {} objects has the name of one that is here",
                       objects.size()),
           "name a report about this model");
}

/// What a length of 1 in the one unit is in the other.
std::optional<double> factor_between(const std::string& from, const std::string& to) {
  if (from == to) return 1;
  const auto metres_from = io::unit_in_metres(from), metres_to = io::unit_in_metres(to);
  return metres_from && metres_to ? std::optional(*metres_from / *metres_to) : std::nullopt;
}

template <class Interval>
void scale_ends(std::optional<Interval>& interval, std::optional<double> factor) {
  if (!factor) interval.reset();
  if (interval) *interval = {interval->lower * *factor, interval->upper * *factor};
}

/// Lengths and volumes of then in the unit of now, a length of 1 in the former being `factor` in the latter; what
/// cannot be compared is not known.
void scale_extent(FormerPair& pair, std::optional<double> factor) {
  scale_ends(pair.penetration, factor);
  scale_ends(pair.local_depth, factor);
  if (factor) factor = *factor * *factor * *factor;
  scale_ends(pair.volume, factor);
}

/// Those of the pairs. What was told in a unit that cannot be compared with that of now is not known.
std::vector<FormerObject> former_objects_in(const io::JsonValue& top, std::span<const FormerPair> pairs,
                                            std::optional<double> factor) {
  if (!factor) return {};
  std::set<std::string_view> named;
  for (const FormerPair& pair : pairs) named.insert({pair.a, pair.b});
  std::vector<FormerObject> objects;
  for (const io::JsonValue& one : top.elements("objects")) {
    if (!named.contains(one.at("name").text()) || !one.has("pose")) continue;
    FormerObject& object = objects.emplace_back(former_object_of(one));
    object.pose = {scaled(object.pose, *factor).linear, *factor * object.pose.offset};
  }
  return objects;
}

}  // namespace

Baseline read_baseline(const std::filesystem::path& path, const Scene& scene) {
  const std::string file = path.string();
  const io::FileBytes bytes = io::read_file(path);
  const nlohmann::json document = io::parse_json(bytes.span(), file, io::RepeatedKeys::refused);
  const io::JsonValue top(document, file);
  if (!is_report_of_check(top))
    top.fail("this is no report that can be a baseline",
             "name a file that `check --json` wrote, without --poses or --self");
  if (top.has("unfinished"))
    top.fail("the check that wrote this report was stopped, so that what it does not tell may have been there",
             "name the report of a check that came to its end");
  require_common_object(top, scene);
  Baseline baseline{file, {}, {}};
  baseline.pairs = former_pairs_in(top);
  const std::optional<double> factor = factor_between(top.text_or("unit", scene.unit), scene.unit);
  for (FormerPair& pair : baseline.pairs) scale_extent(pair, factor);
  baseline.objects = former_objects_in(top, baseline.pairs, factor);
  return baseline;
}

}  // namespace toccata
