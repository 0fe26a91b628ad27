#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "toccata/core/version.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

/// How many times as long as Toccata. Compared with Toccata's first row on as many threads; its own rows with its very
/// first, so that they tell what threads gain.
struct Ratio {
  const Result& result;
  double median;
  double mean;
  double p99;
  bool best;  ///< of the variants of its library on as many threads: the least mean
};

const Result& compared_with(const Result& result, const std::vector<Result>& results) {
  const Result& first = results.front();
  if (result.who.library == first.who.library) return first;
  return *std::find_if(results.begin(), results.end(), [&](const Result& other) {
    return other.who.library == first.who.library && other.threads == result.threads;
  });
}

bool is_best(const Result& result, const std::vector<Result>& results) {
  return std::none_of(results.begin(), results.end(), [&](const Result& other) {
    return other.who.library == result.who.library && other.threads == result.threads && other.mean_us < result.mean_us;
  });
}

Ratio ratio_of(const Result& result, const std::vector<Result>& results) {
  const Result& ours = compared_with(result, results);
  return {result, result.median_us / ours.median_us, result.mean_us / ours.mean_us, result.p99_us / ours.p99_us,
          is_best(result, results)};
}

Json json_of(const Result& r) {
  return {{"library", r.who.library},
          {"variant", r.who.variant},
          {"task", r.task},
          {"threads", r.threads},
          {"queries", r.queries},
          {"median_us", r.median_us},
          {"mean_us", r.mean_us},
          {"p99_us", r.p99_us},
          {"build_ms", r.build_ms},
          {"bytes_per_triangle", r.bytes_per_triangle},
          {"disagreements", r.disagreements},
          {"wrong", r.wrong}};
}

Json json_of(const Ratio& ratio) {
  return {{"library", ratio.result.who.library},
          {"variant", ratio.result.who.variant},
          {"task", ratio.result.task},
          {"threads", ratio.result.threads},
          {"median", ratio.median},
          {"mean", ratio.mean},
          {"p99", ratio.p99},
          {"best", ratio.best}};
}

Json json_of(const Description& who) {
  return {{"library", who.library}, {"variant", who.variant}, {"version", who.version}, {"flags", who.flags}};
}

Json json_of(const NotMeasured& missing) {
  return {{"library", missing.who.library},
          {"variant", missing.who.variant},
          {"task", missing.task},
          {"threads", missing.threads},
          {"reason", missing.reason}};
}

/// Each library and variant once, measured or not.
std::vector<Description> descriptions_of(const Measurements& measurements) {
  std::vector<Description> all;
  const auto add = [&](const Description& who) {
    if (std::find(all.begin(), all.end(), who) == all.end()) all.push_back(who);
  };
  for (const Result& result : measurements.results) add(result.who);
  for (const NotMeasured& missing : measurements.not_measured) add(missing.who);
  return all;
}

Json with_measurements(Json report, const Measurements& measurements) {
  for (const char* list : {"libraries", "results", "ratios", "not_measured"}) report[list] = Json::array();
  for (const Description& who : descriptions_of(measurements)) report["libraries"].push_back(json_of(who));
  const std::vector<Result>& results = measurements.results;
  for (const Result& result : results) report["results"].push_back(json_of(result));
  for (std::size_t i = 1; i < results.size(); ++i) report["ratios"].push_back(json_of(ratio_of(results[i], results)));
  for (const NotMeasured& missing : measurements.not_measured) report["not_measured"].push_back(json_of(missing));
  return report;
}

void print_table(const Measurements& measurements) {
  fmt::print("{:<9}{:<45}{:>8}{:>12}{:>12}{:>12}{:>9}{:>9}{:>11}{:>8}{:>8}{:>7}\n", "library", "variant", "threads",
             "median us", "mean us", "p99 us", "ratio", "(mean)", "build ms", "B/tri", "differ", "wrong");
  for (const Result& r : measurements.results) {
    const Ratio ratio = ratio_of(r, measurements.results);
    fmt::print("{:<9}{:<45}{:>8}{:>12.3f}{:>12.3f}{:>12.3f}{:>9.2f}{:>9.2f}{:>11.2f}{:>8.0f}{:>8}{:>7}{}\n",
               r.who.library, r.who.variant, r.threads, r.median_us, r.mean_us, r.p99_us, ratio.median, ratio.mean,
               r.build_ms, r.bytes_per_triangle, r.disagreements, r.wrong, ratio.best ? " *" : "");
  }
  for (const NotMeasured& missing : measurements.not_measured)
    fmt::print("{:<9}{:<45}{:>8} not measured: {}\n", missing.who.library, missing.who.variant, missing.threads,
               missing.reason);
  const Result& ours = measurements.results.front();
  fmt::print("{} queries of {}; ratio: how many times as long as {}; *: the library's best\n", ours.queries, ours.task,
             ours.who.library);
  for (const Description& who : descriptions_of(measurements))
    fmt::print("  {} {} ({}): {}\n", who.library, who.version, who.variant, who.flags);
}

}  // namespace

Json report_of(const std::string& benchmark, Json question) {
  return {{"format", "toccata-bench-1"},
          {"benchmark", benchmark},
          {"version", version},
          {"machine",
           {{"processor", processor()},
            {"cores", std::thread::hardware_concurrency()},
            {"compiler", TOCCATA_BENCH_COMPILER}}},
          {"question", std::move(question)}};
}

int print_results(Json report, const Measurements& measurements, bool json) {
  std::size_t our_wrong = 0;
  for (const Result& result : measurements.results)
    if (result.who.library == "toccata") our_wrong += result.wrong;
  if (json)
    fmt::print("{}\n", with_measurements(std::move(report), measurements).dump(2));
  else
    print_table(measurements);
  if (our_wrong > 0) fmt::print(stderr, "toccata-bench: {} answers of Toccata are wrong\n", our_wrong);
  return our_wrong > 0 ? 1 : 0;
}

}  // namespace toccata::bench
