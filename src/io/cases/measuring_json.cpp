#include "io/cases/measuring_json.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "math/constants.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

template <class T>
Json names_of(const std::vector<T>& values) {
  Json names = Json::array();
  for (const T value : values) names.push_back(name_of(value));
  return names;
}

/// The one of `all` that is named so.
template <class T>
T named(const JsonValue& value, std::span<const T> all) {
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
  for (const JsonValue& value : question.elements(key)) values.push_back(named<T>(value, all));
}

/// A text, as JSON's numbers tell only 2⁵³ of them apart.
std::uint64_t seed_of(const JsonValue& value) {
  const std::string text = value.text();
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size())
    value.fail(fmt::format("{} is no seed", text), "write a whole number below 2^64 as a text, \"1\"");
  return seed;
}

/// How many fly, for how long, from which seed.
template <class Question>
void take_flight(Question& question, const JsonValue& value) {
  question.count = value.whole_or("count", 100'000'000, question.count);
  question.frames = value.whole_or("frames", 100'000'000, question.frames);
  if (value.has("seed")) question.seed = seed_of(value.at("seed"));
  question.threads = static_cast<int>(value.whole_or("threads", 1024, 1));
}

constexpr std::array all_tasks{CostTask::overlap, CostTask::contacts, CostTask::distance};
constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Json json_of_measuring(const CostQuestion& question) {
  const CostOptions& options = question.options;
  return {{"task", name_of(options.task)},
          {"workloads", names_of(options.workloads)},
          {"volumes", names_of(options.volumes)},
          {"arities", options.arities},
          {"builders", names_of(options.methods)},
          {"leaf_size", options.leaf_size},
          {"most_rigid", options.most_rigid},
          {"most_updating", options.most_updating},
          {"most_work", std::isinf(options.most_work) ? Json("all") : Json(options.most_work)}};
}

CostQuestion cost_question_of(const JsonValue& value) {
  value.expect_keys({"question", "task", "workloads", "volumes", "arities", "builders", "leaf_size", "most_rigid",
                     "most_updating", "most_work", "poses", "solid"});
  CostQuestion question;
  CostOptions& options = question.options;
  if (value.has("task")) options.task = named<CostTask>(value.at("task"), all_tasks);
  take_list<CostWorkload>(options.workloads, value, "workloads", all_cost_workloads);
  take_list<CostVolume>(options.volumes, value, "volumes", all_cost_volumes);
  take_list<BvhMethod>(options.methods, value, "builders", all_bvh_methods);
  if (value.has("arities")) {
    options.arities.clear();
    for (const JsonValue& arity : value.elements("arities"))
      options.arities.push_back(static_cast<int>(arity.whole(8)));
  }
  options.leaf_size = static_cast<Index>(value.whole_or("leaf_size", 64, options.leaf_size));
  if (options.leaf_size == 0) value.at("leaf_size").fail("a leaf holds nothing", "write 1 or more");
  options.most_rigid = value.whole_or("most_rigid", most, options.most_rigid);
  options.most_updating = value.whole_or("most_updating", most, options.most_updating);
  if (!value.has("most_work")) return question;
  const JsonValue work = value.at("most_work");
  const bool is_all = work.is_string() && work.text() == "all";
  options.most_work = is_all ? infinity : work.number();
  return question;
}

Json json_of_measuring(const CrowdQuestion& question) {
  return {{"scene", question.scene},
          {"count", question.count},
          {"frames", question.frames},
          {"methods", names_of(question.methods)},
          {"seed", std::to_string(question.seed)},
          {"threads", question.threads},
          {"bounds", name_of(question.bounds)}};
}

Json json_of_measuring(const CrowdWorldQuestion& question) {
  return {{"count", question.count},
          {"frames", question.frames},
          {"method", name_of(question.method)},
          {"seed", std::to_string(question.seed)},
          {"threads", question.threads}};
}

SceneQuestion crowd_question_of(const JsonValue& value) {
  value.expect_keys({"question", "scene", "count", "frames", "methods", "seed", "threads", "bounds"});
  CrowdQuestion question;
  question.scene = value.text_or("scene", question.scene);
  take_flight(question, value);
  take_list<BroadPhaseMethod>(question.methods, value, "methods", broad_phase_methods());
  if (value.has("bounds")) question.bounds = named<CrowdBounds>(value.at("bounds"), all_crowd_bounds);
  return question;
}

SceneQuestion crowd_world_question_of(const JsonValue& value) {
  value.expect_keys({"question", "count", "frames", "method", "seed", "threads"});
  CrowdWorldQuestion question;
  take_flight(question, value);
  if (value.has("method")) question.method = named<BroadPhaseMethod>(value.at("method"), broad_phase_methods());
  return question;
}

}  // namespace toccata::io
