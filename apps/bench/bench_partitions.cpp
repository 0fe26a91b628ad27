#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "partitions.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/random.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata::bench {
namespace {

/// Boxes twice as large as those of triangles, at some of them.
std::vector<Aabb> questions_at(std::span<const Aabb> boxes, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Aabb> questions;
  while (questions.size() < count) {
    const Aabb& box = boxes[random.below(boxes.size())];
    const Vec3 half = 0.5 * (box.upper - box.lower);
    questions.push_back({box.lower - half, box.upper + half});
  }
  return questions;
}

/// The answers of one library: the numbers of boxes in each place, or one list of all pairs with the two numbers behind
/// each other.
using Answers = std::vector<std::vector<Index>>;

struct MeasuredPartitions {
  Result result;
  Answers answers;
};

Clock clock_of(const PartitionsArguments& arguments) {
  return arguments.clock == "thread" ? Clock::thread : Clock::wall;
}

/// The fastest round of each question counts.
void ask_boxes(const PartitionLibrary& library, std::span<const Aabb> questions, const PartitionsArguments& arguments,
               MeasuredPartitions& one) {
  std::vector<double> times;
  for (const Aabb& box : questions) {
    double best = 1e30;
    std::vector<Index> found;
    for (int round = 0; round < arguments.rounds; ++round)
      best = std::min(best, 1e6 * seconds_of([&] { found = library.overlapping(box); }, clock_of(arguments)));
    std::sort(found.begin(), found.end());
    one.answers.push_back(std::move(found));
    times.push_back(best);
  }
  summarise(std::move(times), one.result);
}

void ask_pairs(const PartitionLibrary& library, const PartitionsArguments& arguments, MeasuredPartitions& one) {
  std::vector<double> times;
  std::vector<IndexPair> pairs;
  for (int round = 0; round < arguments.rounds; ++round)
    times.push_back(1e6 * seconds_of([&] { pairs = library.pairs(); }, clock_of(arguments)));
  std::sort(pairs.begin(), pairs.end());
  std::vector<Index>& numbers = one.answers.emplace_back();
  for (const IndexPair& pair : pairs) numbers.insert(numbers.end(), {pair.first, pair.second});
  summarise(std::move(times), one.result);
}

MeasuredPartitions measured(PartitionLibrary& library, std::span<const Aabb> boxes, std::span<const Aabb> questions,
                            const PartitionsArguments& arguments) {
  MeasuredPartitions one;
  double build = 1e30;
  for (int round = 0; round < arguments.rounds; ++round)
    build = std::min(build, seconds_of([&] { library.build(boxes); }, clock_of(arguments)));
  one.result.who = library.description();
  one.result.task = arguments.task;
  one.result.build_ms = 1e3 * build;
  one.result.bytes_per_triangle = static_cast<double>(library.bytes()) / static_cast<double>(boxes.size());
  if (arguments.task == "pairs")
    ask_pairs(library, arguments, one);
  else
    ask_boxes(library, questions, arguments, one);
  one.result.queries = one.answers.size();
  return one;
}

/// By testing every box.
Answers truth(std::span<const Aabb> boxes, std::span<const Aabb> questions) {
  Answers answers;
  for (const Aabb& question : questions) {
    std::vector<Index>& found = answers.emplace_back();
    for (Index number = 0; number < boxes.size(); ++number)
      if (overlap(boxes[number], question)) found.push_back(number);
  }
  return answers;
}

std::size_t differences(const Answers& a, const Answers& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

}  // namespace

int run_partitions(const PartitionsArguments& arguments) {
  const PartitionItems items(*single_mesh(arguments.mesh));
  const std::vector<Aabb> questions = questions_at(items.boxes(), arguments.queries, arguments.seed);
  PartitionLibraries libraries = toccata_partitions();
  if (!arguments.peers.empty())
    for (auto& library : boost_partitions()) libraries.push_back(std::move(library));
  std::vector<MeasuredPartitions> all;
  for (auto& library : libraries) {
    all.push_back(measured(*library, items.boxes(), questions, arguments));
    library.reset();
  }
  // For all pairs every box's own list would be the truth; there the libraries judge each other.
  const Answers right = arguments.task == "pairs" ? all.front().answers : truth(items.boxes(), questions);
  Measurements measurements;
  for (MeasuredPartitions& one : all) {
    one.result.wrong = differences(one.answers, right);
    one.result.disagreements = differences(one.answers, all.front().answers);
    all.front().result.disagreements = std::max(all.front().result.disagreements, one.result.disagreements);
  }
  for (const MeasuredPartitions& one : all) measurements.results.push_back(one.result);
  auto report = report_of("partitions", {{"mesh", arguments.mesh},
                                         {"triangles", items.size()},
                                         {"task", arguments.task},
                                         {"seed", arguments.seed},
                                         {"rounds", arguments.rounds}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
