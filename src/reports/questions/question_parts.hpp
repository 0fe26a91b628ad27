#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "reports/report_parts.hpp"
#include "toccata/reports/scene_question.hpp"

// What the JSON of several questions has in common. Reading throws Error naming the place.
namespace toccata::io {

void append(std::vector<double>& numbers, const Vec3& v);
void append(std::vector<double>& numbers, const Pose& pose);
/// The pose whose twelve numbers begin there.
[[nodiscard]] Pose pose_at(const std::vector<double>& numbers, std::size_t first);

/// They are of one group, and so no pair.
[[nodiscard]] bool in_one_group(const SceneInstance& a, const SceneInstance& b);
[[nodiscard]] Vec3 vector_at(const std::vector<double>& numbers, std::size_t i);

/// What the two objects are taken for is the same in all queries.
void add_queries(Json& json, const std::vector<PairQuery>& queries);
[[nodiscard]] std::vector<PairQuery> queries_read_from(const JsonValue& value);

[[nodiscard]] const char* touching_word(Touching touching);
[[nodiscard]] Touching touching_of(const JsonValue& value);

/// 0 or more, or "all" for infinity.
[[nodiscard]] double length_of(const JsonValue& value);

template <class T>
Json names_of(const std::vector<T>& values) {
  Json names = Json::array();
  for (const T value : values) names.push_back(name_of(value));
  return names;
}

/// The one of `all` that is named so.
template <class T>
T one_named(const JsonValue& value, std::span<const T> all) {
  const std::string name = value.text();
  std::vector<std::string> known;
  for (const T one : all) {
    if (name == name_of(one)) return one;
    known.emplace_back(name_of(one));
  }
  value.fail(fmt::format("{} is not known here", name), fmt::format("write one of {}", fmt::join(known, ", ")));
}

/// What is not there stays as it is.
template <class T>
void take_list(std::vector<T>& values, const JsonValue& question, const char* key, std::span<const T> all) {
  if (!question.has(key)) return;
  values.clear();
  for (const JsonValue& value : question.elements(key)) values.push_back(one_named<T>(value, all));
}

}  // namespace toccata::io
