// toccata-sweeps: runs the long comparisons in shards and adds them up in evidence files. It may be stopped at any
// moment; the next run goes on where this one was.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <map>
#include <mutex>
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
    "usage: toccata-sweeps --evidence DIR [--name SWEEP]… [--minutes M] [--scale F | --cases N] [--threads N] "
    "[--commit ID] [--anew]\n"
    "Runs shards of the families that are farthest from their goals, until all have reached them.\n"
    "  --evidence DIR  folder of the evidence files, one per sweep\n"
    "  --name SWEEP    only this sweep; may be given several times\n"
    "  --minutes M     start no shard after M minutes (default: run until every goal is reached)\n"
    "  --scale F       multiply every goal by F\n"
    "  --cases N       every family's goal is N cases, instead of that of its sweep\n"
    "  --threads N     families at a time (default: one per core)\n"
    "  --commit ID     the commit this program was built from, kept in the evidence\n"
    "  --anew          what other commits have compared does not count towards the goals: for code that changed\n";

struct Options {
  std::filesystem::path evidence;
  std::vector<std::string> names;  ///< empty: all
  double minutes = 1e9;
  double scale = 1;
  std::optional<double> cases{};  ///< of every family, instead of its goal
  std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::string commit = "unknown";
  bool anew = false;
};

Options parse(int argument_count, char** arguments) {
  Options options;
  for (int i = 1; i < argument_count; ++i) {
    const std::string option = arguments[i];
    if (option == "--anew") {
      options.anew = true;
      continue;
    }
    if (++i == argument_count) throw std::runtime_error(option + " needs a value");
    const std::string value = arguments[i];
    if (option == "--evidence")
      options.evidence = value;
    else if (option == "--name")
      options.names.push_back(value);
    else if (option == "--minutes")
      options.minutes = std::stod(value);
    else if (option == "--scale")
      options.scale = std::stod(value);
    else if (option == "--cases")
      options.cases = std::stod(value);
    else if (option == "--threads")
      options.threads = std::max(1UL, std::stoul(value));
    else if (option == "--commit")
      options.commit = value;
    else
      throw std::runtime_error("unknown option " + option);
  }
  if (options.evidence.empty()) throw std::runtime_error("--evidence is missing");
  if (!(options.scale > 0)) throw std::runtime_error("--scale: a number above 0");
  if (!(options.cases.value_or(1) > 0)) throw std::runtime_error("--cases: a number above 0");
  return options;
}

/// A family on the way to its goal.
struct Lane {
  const Sweep* sweep;
  std::string family;
  bool busy = false;
};

/// Runs shards of chosen sweeps on some threads; the evidence files are complete after every shard.
class Run {
 public:
  Run(const std::vector<const Sweep*>& chosen, const Options& options, Clock::time_point deadline)
      : options_(options), deadline_(deadline) {
    for (const Sweep* sweep : chosen) {
      evidence_.emplace(sweep, Evidence::read(file_of(*sweep), sweep->name));
      for (const std::string& family : sweep->families) lanes_.push_back({sweep, family});
    }
  }

  void run() {
    std::vector<std::future<void>> workers;
    for (std::size_t i = 0; i < options_.threads; ++i)
      workers.push_back(std::async(std::launch::async, [this] { work(); }));
    for (std::future<void>& worker : workers) worker.get();
  }

 private:
  std::filesystem::path file_of(const Sweep& sweep) const { return options_.evidence / (sweep.name + ".json"); }

  /// The part of its goal that a family has reached.
  double progress(const Lane& lane) const {
    const FamilyEvidence& family = evidence_.at(lane.sweep).family(lane.family);
    const std::uint64_t done = options_.anew ? family.cases_of(options_.commit) : family.cases();
    const double goal = options_.cases ? *options_.cases : static_cast<double>(lane.sweep->goal) * options_.scale;
    return static_cast<double>(done) / goal;
  }

  /// The family that is farthest from its goal; nothing when all have reached it, or there is no time left.
  Lane* next() {
    if (Clock::now() >= deadline_) return nullptr;
    Lane* least = nullptr;
    for (Lane& lane : lanes_)
      if (!lane.busy && progress(lane) < 1 && (least == nullptr || progress(lane) < progress(*least))) least = &lane;
    return least;
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (Lane* lane = next()) {
      lane->busy = true;
      const Sweep& sweep = *lane->sweep;
      const std::uint64_t seed = evidence_.at(&sweep).family(lane->family).next_shard();
      lock.unlock();
      const Clock::time_point start = Clock::now();
      const SweepResult result = sweep.run(lane->family, seed, std::min(sweep.goal, sweep.shard));
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      lock.lock();
      if (result.cases == 0) throw std::runtime_error(sweep.name + "/" + lane->family + " ran no case");
      evidence_.at(&sweep).add(lane->family, seed, result, seconds, version, options_.commit);
      evidence_.at(&sweep).write(file_of(sweep));
      lane->busy = false;
    }
  }

  const Options& options_;
  Clock::time_point deadline_;
  std::mutex mutex_;  ///< of what follows
  std::map<const Sweep*, Evidence> evidence_;
  std::vector<Lane> lanes_;
};

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

std::vector<const Sweep*> chosen_sweeps(const std::vector<std::string>& names) {
  std::vector<const Sweep*> chosen;
  for (const Sweep& sweep : sweeps())
    if (names.empty() || std::ranges::count(names, sweep.name) > 0) chosen.push_back(&sweep);
  for (const std::string& name : names)
    if (std::ranges::none_of(chosen, [&](const Sweep* sweep) { return sweep->name == name; }))
      throw std::runtime_error("no sweep is named " + name);
  return chosen;
}

int run_all(const Options& options) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(60 * std::min(options.minutes, 1e6)));
  std::filesystem::create_directories(options.evidence);
  const std::vector<const Sweep*> chosen = chosen_sweeps(options.names);
  Run(chosen, options, deadline).run();
  bool right = true;
  for (const Sweep* sweep : chosen) right = report(*sweep, options) && right;
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
