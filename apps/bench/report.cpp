#include "report.hpp"

#include <fmt/format.h>

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

Json json_of(const Result& r) {
  return {{"library", r.who.library},
          {"variant", r.who.variant},
          {"version", r.who.version},
          {"flags", r.who.flags},
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

void print_table(const std::vector<Result>& results) {
  fmt::print("{:<9}{:<36}{:>12}{:>12}{:>12}{:>8}{:>8}{:>11}{:>8}{:>8}{:>7}\n", "library", "variant", "median us",
             "mean us", "p99 us", "ratio", "(mean)", "build ms", "B/tri", "differ", "wrong");
  const Result& ours = results.front();
  for (const Result& r : results)
    fmt::print("{:<9}{:<36}{:>12.3f}{:>12.3f}{:>12.3f}{:>8.2f}{:>8.2f}{:>11.2f}{:>8.0f}{:>8}{:>7}\n", r.who.library,
               r.who.variant, r.median_us, r.mean_us, r.p99_us, r.median_us / ours.median_us, r.mean_us / ours.mean_us,
               r.build_ms, r.bytes_per_triangle, r.disagreements, r.wrong);
  fmt::print("{} queries of {}; ratio: how many times as long as {}\n", ours.queries, ours.task, ours.who.library);
  for (const Result& r : results)
    fmt::print("  {} {} ({}): {}\n", r.who.library, r.who.version, r.who.variant, r.who.flags);
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

Json ratios_of(const std::vector<Result>& results) {
  Json ratios = Json::array();
  for (std::size_t i = 1; i < results.size(); ++i)
    ratios.push_back({{"library", results[i].who.library},
                      {"variant", results[i].who.variant},
                      {"task", results[i].task},
                      {"median", results[i].median_us / results.front().median_us},
                      {"mean", results[i].mean_us / results.front().mean_us},
                      {"p99", results[i].p99_us / results.front().p99_us}});
  return ratios;
}

int print_results(Json report, const std::vector<Result>& results, bool json) {
  std::size_t our_wrong = 0;
  for (const Result& result : results)
    if (result.who.library == "toccata") our_wrong += result.wrong;
  if (json) {
    report["results"] = Json::array();
    for (const Result& result : results) report["results"].push_back(json_of(result));
    report["ratios"] = ratios_of(results);
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(results);
  }
  if (our_wrong > 0) fmt::print(stderr, "toccata-bench: {} answers of Toccata are wrong\n", our_wrong);
  return our_wrong > 0 ? 1 : 0;
}

}  // namespace toccata::bench
