#include "io/cases/question_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "io/cases/measuring_json.hpp"
#include "io/formats/number_rows.hpp"
#include "io/reports/report_parts.hpp"
#include "io/scenes/solid_words.hpp"
#include "math/constants.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

void append(std::vector<double>& numbers, const Vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

void append(std::vector<double>& numbers, const Pose& pose) {
  const std::array<double, 12> twelve = pose.numbers();
  numbers.insert(numbers.end(), twelve.begin(), twelve.end());
}

Json json_of_queries(const std::vector<PairQuery>& queries) {
  std::vector<double> numbers;
  for (const PairQuery& query : queries) {
    append(numbers, query.pose_a);
    append(numbers, query.pose_b);
  }
  return json_of_rows(numbers, 24);
}

const char* touching_word(Touching touching) { return touching == Touching::ignore ? "ignore" : "count"; }

/// What the two objects are taken for is the same in all queries.
void add_queries(Json& json, const std::vector<PairQuery>& queries) {
  json["poses"] = json_of_queries(queries);
  const auto is_plain = [](const PairQuery& q) {
    return q.solid_a == Solid::automatic && q.solid_b == Solid::automatic;
  };
  if (!queries.empty() && !is_plain(queries[0]))
    json["solid"] = Json::array({word_of(queries[0].solid_a), word_of(queries[0].solid_b)});
}

struct Writer {
  Json operator()(const CheckQuestion& q) const {
    Json json = {{"touching", touching_word(q.touching)}, {"faces", q.faces}, {"penetration", q.penetration}};
    if (q.clearance) json["clearance"] = json_of_length(*q.clearance);
    for (const PairClearance& pair : q.pair_clearances)
      json["pair_clearances"].push_back(
          {{"a_index", pair.a}, {"b_index", pair.b}, {"clearance", json_of_length(pair.clearance)}});
    return json;
  }
  Json operator()(const CheckPosesQuestion& q) const {
    Json json = {{"touching", touching_word(q.touching)}, {"faces", q.faces}, {"penetration", q.penetration}};
    add_queries(json, q.queries);
    return json;
  }
  Json operator()(const SelfQuestion& q) const { return {{"faces", q.faces}}; }
  Json operator()(const DistanceQuestion& q) const { return {{"first_objects", q.first_objects}}; }
  Json operator()(const DistancePosesQuestion& q) const {
    Json json = Json::object();
    add_queries(json, q.queries);
    return json;
  }
  Json operator()(const RayQuestion& q) const {
    std::vector<double> numbers;
    for (const RayQuery& ray : q.rays) {
      append(numbers, ray.origin);
      append(numbers, ray.motion);
    }
    return {{"rays", json_of_rows(numbers, 6)}};
  }
  Json operator()(const FacesQuestion& q) const {
    std::vector<double> numbers;
    if (const auto* ball = std::get_if<Ball>(&q.region)) {
      append(numbers, ball->centre);
      numbers.push_back(ball->radius);
      return {{"ball", numbers}};
    }
    append(numbers, std::get<Aabb>(q.region).lower);
    append(numbers, std::get<Aabb>(q.region).upper);
    return {{"box", numbers}};
  }
  Json operator()(const NearestQuestion& q) const {
    std::vector<double> numbers;
    for (const Vec3& point : q.points) append(numbers, point);
    return {
        {"points", json_of_rows(numbers, 3)}, {"k", q.k}, {"within", json_of_length(q.within)}, {"signed", q.sides}};
  }
  Json operator()(const HierarchyQuestion&) const { return Json::object(); }
  Json operator()(const CostQuestion& q) const {
    Json json = json_of_measuring(q);
    add_queries(json, q.queries);
    return json;
  }
  Json operator()(const CrowdQuestion& q) const { return json_of_measuring(q); }
  Json operator()(const CrowdWorldQuestion& q) const { return json_of_measuring(q); }
  Json operator()(const DecomposeQuestion& q) const {
    return {{"parts", q.max_parts}, {"concavity", json_of_length(q.concavity)}};
  }
  Json operator()(const MinkowskiQuestion& q) const {
    Json json = {{"difference", q.difference}, {"hulls", q.hulls}};
    if (q.point) json["point"] = {q.point->x, q.point->y, q.point->z};
    return json;
  }
  Json operator()(const InspectQuestion& q) const {
    return {{"volumes", q.volumes}, {"partitions", q.partitions}, {"faults", q.faults}};
  }
};

template <class Word>
Word one_of(const JsonValue& value, const std::map<std::string, Word>& words) {
  const auto found = words.find(value.text());
  if (found != words.end()) return found->second;
  std::string known;
  for (const auto& [name, word] : words) known += (known.empty() ? "\"" : " or \"") + name + "\"";
  value.fail(fmt::format("{} is not known here", value.text()), "write " + known);
}

double length_of(const JsonValue& value) {
  if (value.is_string() && value.text() == "all") return infinity;
  const double length = value.number();
  if (!(length >= 0)) value.fail("a length is negative", "write 0 or more, or \"all\"");
  return length;
}

Touching touching_of(const JsonValue& value) {
  if (!value.has("touching")) return Touching::count;
  return one_of<Touching>(value.at("touching"), {{"count", Touching::count}, {"ignore", Touching::ignore}});
}

Vec3 vector_at(const std::vector<double>& numbers, std::size_t i) {
  return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

Pose pose_at(const std::vector<double>& numbers, std::size_t first) {
  std::array<double, 12> twelve{};
  std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), 12, twelve.begin());
  return Pose::from_numbers(twelve);
}

std::vector<PairQuery> queries_read_from(const JsonValue& value) {
  Solid solids[] = {Solid::automatic, Solid::automatic};
  if (value.has("solid")) {
    const std::vector<JsonValue> words = value.at("solid").elements();
    if (words.size() != 2) value.at("solid").fail("these are not two words", "write one of A and one of B");
    for (std::size_t i = 0; i < 2; ++i) solids[i] = solid_of(words[i]);
  }
  const std::vector<double> numbers = rows_of_numbers(value.at("poses"), 24, "pair of poses");
  std::vector<PairQuery> queries;
  for (std::size_t i = 0; i < numbers.size(); i += 24)
    queries.push_back({pose_at(numbers, i), pose_at(numbers, i + 12), solids[0], solids[1]});
  return queries;
}

SceneQuestion check_of(const JsonValue& value) {
  value.expect_keys({"question", "touching", "faces", "penetration", "clearance", "pair_clearances"});
  CheckQuestion q;
  q.touching = touching_of(value);
  q.faces = value.flag_or("faces", false);
  q.penetration = value.flag_or("penetration", false);
  if (value.has("clearance")) q.clearance = length_of(value.at("clearance"));
  constexpr std::size_t most = std::numeric_limits<Index>::max();
  for (const JsonValue& pair : value.elements("pair_clearances")) {
    pair.expect_keys({"a_index", "b_index", "clearance"});
    q.pair_clearances.push_back({static_cast<Index>(pair.at("a_index").whole(most)),
                                 static_cast<Index>(pair.at("b_index").whole(most)), length_of(pair.at("clearance"))});
  }
  return q;
}

SceneQuestion check_poses_of(const JsonValue& value) {
  value.expect_keys({"question", "touching", "faces", "penetration", "poses", "solid"});
  return CheckPosesQuestion{queries_read_from(value), touching_of(value), value.flag_or("faces", false),
                            value.flag_or("penetration", false)};
}

SceneQuestion self_of(const JsonValue& value) {
  value.expect_keys({"question", "faces"});
  return SelfQuestion{value.flag_or("faces", false)};
}

SceneQuestion distance_of(const JsonValue& value) {
  value.expect_keys({"question", "first_objects"});
  return DistanceQuestion{value.whole_or("first_objects", std::numeric_limits<Index>::max(), 0)};
}

SceneQuestion distance_poses_of(const JsonValue& value) {
  value.expect_keys({"question", "poses", "solid"});
  return DistancePosesQuestion{queries_read_from(value)};
}

SceneQuestion ray_of(const JsonValue& value) {
  value.expect_keys({"question", "rays"});
  const std::vector<double> numbers = rows_of_numbers(value.at("rays"), 6, "ray");
  RayQuestion q;
  for (std::size_t i = 0; i < numbers.size(); i += 6)
    q.rays.push_back({.origin = vector_at(numbers, i), .motion = vector_at(numbers, i + 3)});
  return q;
}

SceneQuestion faces_of(const JsonValue& value) {
  value.expect_keys({"question", "box", "ball"});
  if (value.has("box") == value.has("ball")) value.fail("a region is a box or a ball", "write one of the two");
  if (value.has("ball")) {
    const std::vector<double> n = value.at("ball").numbers(4);
    return FacesQuestion{Ball{vector_at(n, 0), n[3]}};
  }
  const std::vector<double> n = value.at("box").numbers(6);
  return FacesQuestion{Aabb{vector_at(n, 0), vector_at(n, 3)}};
}

SceneQuestion nearest_of(const JsonValue& value) {
  value.expect_keys({"question", "points", "k", "within", "signed"});
  const std::vector<double> numbers = rows_of_numbers(value.at("points"), 3, "point");
  NearestQuestion q;
  for (std::size_t i = 0; i < numbers.size(); i += 3) q.points.push_back(vector_at(numbers, i));
  q.k = value.whole_or("k", 1'000'000, 1);
  if (q.k == 0) value.at("k").fail("none is asked for", "write 1 or more");
  if (value.has("within")) q.within = length_of(value.at("within"));
  q.sides = value.flag_or("signed", false);
  return q;
}

SceneQuestion hierarchy_of(const JsonValue& value) {
  value.expect_keys({"question"});
  return HierarchyQuestion{};
}

SceneQuestion cost_of(const JsonValue& value) {
  CostQuestion question = cost_question_of(value);
  question.queries = queries_read_from(value);
  return question;
}

SceneQuestion inspect_of(const JsonValue& value) {
  value.expect_keys({"question", "volumes", "partitions", "faults"});
  return InspectQuestion{value.flag_or("volumes", false), value.flag_or("partitions", false),
                         value.flag_or("faults", false)};
}

SceneQuestion decompose_of(const JsonValue& value) {
  value.expect_keys({"question", "parts", "concavity"});
  DecomposeQuestion q;
  q.max_parts = value.whole_or("parts", std::numeric_limits<Index>::max(), q.max_parts);
  if (value.has("concavity")) q.concavity = length_of(value.at("concavity"));
  return q;
}

SceneQuestion minkowski_of(const JsonValue& value) {
  value.expect_keys({"question", "difference", "hulls", "point"});
  MinkowskiQuestion q{value.flag_or("difference", false), value.flag_or("hulls", false)};
  if (value.has("point")) q.point = vector_at(value.at("point").numbers(3), 0);
  return q;
}

}  // namespace

Json json_of(const SceneQuestion& question) {
  Json json = {{"question", name_of(question)}};
  json.update(std::visit(Writer{}, question));
  return json;
}

SceneQuestion question_of(const JsonValue& value) {
  using Reading = SceneQuestion (*)(const JsonValue&);
  static const std::map<std::string, Reading, std::less<>> readings = {{"check", check_of},
                                                                       {"check-poses", check_poses_of},
                                                                       {"check-self", self_of},
                                                                       {"distance", distance_of},
                                                                       {"ray", ray_of},
                                                                       {"distance-poses", distance_poses_of},
                                                                       {"faces", faces_of},
                                                                       {"nearest", nearest_of},
                                                                       {"inspect", inspect_of},
                                                                       {"hierarchy", hierarchy_of},
                                                                       {"cost", cost_of},
                                                                       {"crowd", crowd_question_of},
                                                                       {"crowd-world", crowd_world_question_of},
                                                                       {"decompose", decompose_of},
                                                                       {"minkowski", minkowski_of}};
  const std::string name = value.at("question").text();
  const auto found = readings.find(name);
  if (found != readings.end()) return found->second(value);
  std::vector<std::string> known;
  for (const auto& [known_name, reading] : readings) known.push_back(known_name);
  const std::string near = nearest_word(name, known);
  value.at("question")
      .fail(fmt::format("there is no question {}", name),
            near.empty() ? "see docs/reference/scene-file.md" : fmt::format("did you mean {}?", near));
}

}  // namespace toccata::io
