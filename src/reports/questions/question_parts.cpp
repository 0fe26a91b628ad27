#include "reports/questions/question_parts.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "io/formats/number_rows.hpp"
#include "io/scenes/solid_words.hpp"
#include "math/constants.hpp"

namespace toccata::io {
namespace {

Json json_of_queries(const std::vector<PairQuery>& queries) {
  std::vector<double> numbers;
  for (const PairQuery& query : queries) {
    io::append(numbers, query.pose_a);
    io::append(numbers, query.pose_b);
  }
  return json_of_rows(numbers, 24);
}

template <class Word>
Word one_of(const JsonValue& value, const std::map<std::string, Word>& words) {
  const auto found = words.find(value.text());
  if (found != words.end()) return found->second;
  std::string known;
  for (const auto& [name, word] : words) known += (known.empty() ? "\"" : " or \"") + name + "\"";
  value.fail(fmt::format("{} is not known here", value.text()), "write " + known);
}

}  // namespace

void append(std::vector<double>& numbers, const Vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

void append(std::vector<double>& numbers, const Pose& pose) {
  const std::array<double, 12> twelve = pose.numbers();
  numbers.insert(numbers.end(), twelve.begin(), twelve.end());
}

Pose pose_at(const std::vector<double>& numbers, std::size_t first) {
  std::array<double, 12> twelve{};
  std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), 12, twelve.begin());
  return Pose::from_numbers(twelve);
}

bool in_one_group(const SceneInstance& a, const SceneInstance& b) { return !a.group.empty() && a.group == b.group; }

const char* touching_word(Touching touching) { return touching == Touching::ignore ? "ignore" : "count"; }

void add_queries(Json& json, const std::vector<PairQuery>& queries) {
  json["poses"] = json_of_queries(queries);
  const auto is_plain = [](const PairQuery& q) {
    return q.solid_a == Solid::automatic && q.solid_b == Solid::automatic;
  };
  if (!queries.empty() && !is_plain(queries[0]))
    json["solid"] = Json::array({word_of(queries[0].solid_a), word_of(queries[0].solid_b)});
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

}  // namespace toccata::io
