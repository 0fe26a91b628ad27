#include <algorithm>
#include <limits>

#include "arguments.hpp"
#include "judge.hpp"
#include "narrow/triangle_pairs.hpp"
#include "report.hpp"

namespace toccata::bench {
namespace {

/// One pair takes less time than a look at the clock, so times are of a batch, divided.
constexpr std::size_t batch = 500;

/// Questions of one of the families in which the tests compare triangle pairs. Triangles without area are left out:
/// peers do not take them.
std::vector<TriangleQuestion> questions_of(const TriangleArguments& arguments) {
  Random random(arguments.seed);
  std::vector<TriangleQuestion> questions;
  const auto has_area = [](const Triangle& t) { return !(cross(t[1] - t[0], t[2] - t[0]) == Vec3{}); };
  while (questions.size() < arguments.count) {
    const test::TrianglePair pair = test::triangle_pair(arguments.family, random);
    if (has_area(pair.a) && has_area(pair.b)) questions.push_back({pair.a, pair.b});
  }
  return questions;
}

struct TriangleRun {
  Result result;
  std::vector<char> answers;
};

TriangleRun measured(const TriangleLibrary& library, std::size_t count, int rounds) {
  TriangleRun run{{}, std::vector<char>(count)};
  std::vector<double> times((count + batch - 1) / batch, std::numeric_limits<double>::infinity());
  // A batch again at once would be measured with branches that the processor has learnt.
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::span<char> answers = std::span(run.answers).subspan(i * batch, std::min(batch, count - i * batch));
      const double seconds = seconds_of([&] { library.answer(i * batch, answers); });
      times[i] = std::min(times[i], 1e6 * seconds / static_cast<double>(answers.size()));
    }
  summarise(std::move(times), run.result);
  run.result.queries = count;
  run.result.who = library.description();
  run.result.task = "triangle";
  return run;
}

}  // namespace

int run_triangle(const TriangleArguments& arguments) {
  const std::vector<TriangleQuestion> questions = questions_of(arguments);
  std::vector<Result> results;
  std::vector<std::vector<char>> answers;
  for (const auto& library : triangle_libraries(arguments.peers)) {
    library->prepare(questions);
    TriangleRun run = measured(*library, questions.size(), arguments.rounds);
    results.push_back(run.result);
    answers.push_back(std::move(run.answers));
  }
  judge(questions, answers, arguments.verify ? Judged::all : Judged::differing, results);
  const auto touching = std::count(answers[0].begin(), answers[0].end(), 1);
  return print_results(report_of("triangle", {{"family", arguments.family},
                                              {"seed", arguments.seed},
                                              {"batch", batch},
                                              {"rounds", arguments.rounds},
                                              {"touching", touching}}),
                       {results, {}}, arguments.json);
}

}  // namespace toccata::bench
