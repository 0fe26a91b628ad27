#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "arguments.hpp"
#include "programs.hpp"
#include "report.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::bench {
namespace {

namespace fs = std::filesystem;

struct ProcessCase {
  std::string name;
  std::vector<std::string> words;
  double seconds_budget;
  double megabytes_budget;  ///< 0: none
};

struct ProcessResult {
  ProcessCase what;
  double median_seconds = 0;
  double worst_seconds = 0;
  double median_processor_seconds = 0;
  double peak_megabytes = 0;
  bool within_budget() const {
    return median_seconds < what.seconds_budget &&
           (what.megabytes_budget == 0 || peak_megabytes < what.megabytes_budget);
  }
};

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

ProcessResult measured(const ProcessCase& one, int repeat) {
  std::vector<double> seconds, processor_seconds;
  double peak = 0;
  for (int i = 0; i < repeat; ++i) {
    const ProcessRun run = run_program(one.words);
    if (run.exit_code != 0 && run.exit_code != 1)
      throw Error(fmt::format("{} did not answer; build it with `./toccata build`, or name it with --command",
                              fmt::join(one.words, " ")));
    seconds.push_back(run.seconds);
    processor_seconds.push_back(run.processor_seconds);
    peak = std::max(peak, run.peak_megabytes);
  }
  return {one, median_of(seconds), *std::max_element(seconds.begin(), seconds.end()), median_of(processor_seconds),
          peak};
}

std::string mesh_file(const ProcessArguments& arguments) {
  if (!arguments.mesh.empty()) return arguments.mesh;
  const char* data = std::getenv("TOCCATA_DATA");
  if (data == nullptr) throw Error("no mesh to check: name one with --mesh, or set TOCCATA_DATA");
  return (fs::path(data) / "meshes/stanford-bunny.obj").string();
}

std::vector<ProcessResult> measured(const ProcessArguments& arguments) {
  const std::string mesh = mesh_file(arguments);
  std::vector<std::string> shifted{arguments.command, "check", mesh, mesh, "--solid=none", "--json", "--pose-b"};
  for (const double number : Pose::translation(arguments.shift, 0, 0).numbers())
    shifted.push_back(fmt::format("{}", number));
  // The files first, so that this program is still small when its peak is handed on.
  std::vector<ProcessResult> results{measured({"load a mesh to first answer", shifted, 0.15, 200}, arguments.repeat)};
  const TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene";
  write_scene(many_parts(arguments.objects, 1), scene);
  results.push_back(measured({fmt::format("scene of {} small meshes", arguments.objects),
                              {arguments.command, "check", (scene / "scene.json").string(), "--json"},
                              5,
                              0},
                             arguments.repeat));
  return results;
}

nlohmann::ordered_json json_of(const ProcessResult& result) {
  return {{"library", "toccata"},
          {"variant", result.what.name},
          {"task", "process"},
          {"median_seconds", result.median_seconds},
          {"worst_seconds", result.worst_seconds},
          {"median_processor_seconds", result.median_processor_seconds},
          {"peak_megabytes", result.peak_megabytes},
          {"seconds_budget", result.what.seconds_budget},
          {"megabytes_budget", result.what.megabytes_budget},
          {"within_budget", result.within_budget()}};
}

void print_table(const std::vector<ProcessResult>& results) {
  fmt::print("{:<34}{:>10}{:>10}{:>13}{:>10}{:>12}  {}\n", "whole process", "median s", "worst s", "processor s",
             "budget s", "peak MB", "within budget");
  for (const ProcessResult& r : results)
    fmt::print("{:<34}{:>10.3f}{:>10.3f}{:>13.3f}{:>10}{:>12.1f}  {}\n", r.what.name, r.median_seconds, r.worst_seconds,
               r.median_processor_seconds, r.what.seconds_budget, r.peak_megabytes, r.within_budget() ? "yes" : "no");
}

}  // namespace

int run_process(const ProcessArguments& arguments) {
  const std::vector<ProcessResult> results = measured(arguments);
  if (!arguments.json) {
    print_table(results);
    return 0;
  }
  auto report = report_of("process", {{"mesh", mesh_file(arguments)}, {"repeat", arguments.repeat}});
  report["results"] = nlohmann::ordered_json::array();
  for (const ProcessResult& result : results) report["results"].push_back(json_of(result));
  report["ratios"] = nlohmann::ordered_json::array();
  fmt::print("{}\n", report.dump(2));
  return 0;
}

}  // namespace toccata::bench
