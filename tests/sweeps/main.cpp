// toccata-sweeps: runs the long comparisons in shards and adds them up in evidence files. It may be stopped at any
// moment; the next run goes on where this one was.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/evidence.hpp"
#include "support/sweep.hpp"
#include "toccata/core/version.hpp"

namespace toccata::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* usage =
    "usage: toccata-sweeps --evidence DIR [--name SWEEP] [--minutes M] [--scale F] [--threads N] [--commit ID]\n"
    "  --evidence DIR  folder of the evidence files, one per sweep\n"
    "  --name SWEEP    only this sweep\n"
    "  --minutes M     start no shard after M minutes (default: run until every goal is reached)\n"
    "  --scale F       multiply every goal by F\n"
    "  --threads N     shards at a time (default: one per core)\n"
    "  --commit ID     the commit this program was built from, kept in the evidence\n";

struct Options {
  std::filesystem::path evidence;
  std::optional<std::string> name;
  double minutes = 1e9;
  double scale = 1;
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::string commit = "unknown";
};

struct Shard {
  std::string family;
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;
};

struct ShardAnswer {
  SweepResult result;
  double seconds = 0;
};

Options parse(int argument_count, char** arguments) {
  Options options;
  for (int i = 1; i < argument_count; i += 2) {
    const std::string option = arguments[i];
    if (i + 1 == argument_count) throw std::runtime_error(option + " needs a value");
    const std::string value = arguments[i + 1];
    if (option == "--evidence")
      options.evidence = value;
    else if (option == "--name")
      options.name = value;
    else if (option == "--minutes")
      options.minutes = std::stod(value);
    else if (option == "--scale")
      options.scale = std::stod(value);
    else if (option == "--threads")
      options.threads = std::max(1UL, std::stoul(value));
    else if (option == "--commit")
      options.commit = value;
    else
      throw std::runtime_error("unknown option " + option);
  }
  if (options.evidence.empty()) throw std::runtime_error("--evidence is missing");
  return options;
}

/// The next shard of every family that has not reached the goal.
std::vector<Shard> next_round(const Sweep& sweep, const Evidence& evidence, std::uint64_t goal) {
  std::vector<Shard> round;
  for (const std::string& family : sweep.families) {
    const FamilyEvidence& done = evidence.family(family);
    if (done.cases() < goal) round.push_back({family, done.next_shard(), std::min(goal, sweep.shard)});
  }
  return round;
}

ShardAnswer run_shard(const Sweep& sweep, const Shard& shard) {
  const Clock::time_point start = Clock::now();
  const SweepResult result = sweep.run(shard.family, shard.seed, shard.cases);
  if (result.cases == 0) throw std::runtime_error(sweep.name + "/" + shard.family + " ran no case");
  return {result, std::chrono::duration<double>(Clock::now() - start).count()};
}

/// Runs shards of one sweep, as many at a time as there are threads, until the goal or the deadline.
void run_sweep(const Sweep& sweep, const Options& options, Clock::time_point deadline) {
  const std::filesystem::path file = options.evidence / (sweep.name + ".json");
  Evidence evidence = Evidence::read(file, sweep.name);
  const auto goal = static_cast<std::uint64_t>(static_cast<double>(sweep.goal) * options.scale);
  for (auto round = next_round(sweep, evidence, goal); !round.empty(); round = next_round(sweep, evidence, goal)) {
    for (std::size_t first = 0; first < round.size(); first += options.threads) {
      if (Clock::now() >= deadline) return;
      const std::size_t end = std::min(first + options.threads, round.size());
      std::vector<std::future<ShardAnswer>> answers;
      for (std::size_t i = first; i < end; ++i) {
        answers.push_back(std::async(std::launch::async, run_shard, std::cref(sweep), std::cref(round[i])));
      }
      for (std::size_t i = first; i < end; ++i) {
        const ShardAnswer answer = answers[i - first].get();
        evidence.add(round[i].family, round[i].seed, answer.result, answer.seconds, version, options.commit);
      }
      evidence.write(file);
    }
  }
}

/// One line per family, and whether no case was wrong.
bool report(const Sweep& sweep, const Options& options) {
  const Evidence evidence = Evidence::read(options.evidence / (sweep.name + ".json"), sweep.name);
  bool right = true;
  for (const std::string& family : sweep.families) {
    const FamilyEvidence& done = evidence.family(family);
    std::printf("%-50s %12llu cases %6llu wrong %8.0f s\n", (sweep.name + "/" + family).c_str(),
                static_cast<unsigned long long>(done.cases()), static_cast<unsigned long long>(done.wrong()),
                done.seconds());
    for (const EvidenceRun& run : done.runs) {
      if (run.wrong > 0) std::printf("    at %s: %s\n", run.commit.c_str(), run.first_failure.c_str());
    }
    right = right && done.wrong() == 0;
  }
  std::fflush(stdout);
  return right;
}

int run_all(const Options& options) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(60 * std::min(options.minutes, 1e6)));
  std::filesystem::create_directories(options.evidence);
  bool right = true;
  bool found = false;
  for (const Sweep& sweep : sweeps()) {
    if (options.name && *options.name != sweep.name) continue;
    found = true;
    run_sweep(sweep, options, deadline);
    right = report(sweep, options) && right;
  }
  if (options.name && !found) throw std::runtime_error("no sweep is named " + *options.name);
  return right ? 0 : 1;
}

}  // namespace
}  // namespace toccata::test

int main(int argument_count, char** arguments) {
  try {
    return toccata::test::run_all(toccata::test::parse(argument_count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "toccata-sweeps: %s\n%s", error.what(), toccata::test::usage);
    return 2;
  }
}
