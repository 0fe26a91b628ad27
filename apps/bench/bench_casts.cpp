#include "arguments.hpp"
#include "cast_judge.hpp"
#include "cast_questions.hpp"
#include "report.hpp"

namespace toccata::bench {
namespace {

AnsweredCasts measured(CastLibrary& library, const CastWork& work, int rounds) {
  library.prepare(work);
  const std::size_t count = work.questions.size();
  AnsweredCasts one;
  one.answers.resize(count);
  const auto ask = [&](std::size_t first, auto answers) { library.answer(first, answers); };
  summarise(fastest_of_blocks(std::span(one.answers), cast_block, rounds, Clock::thread, ask), one.result);
  one.result.who = library.description();
  one.result.task = "casts";
  one.result.queries = count;
  return one;
}

}  // namespace

int run_casts(const CastsArguments& arguments) {
  const CastWork work = cast_work(arguments);
  const CastOffer offer = cast_libraries(arguments.peers, work);
  std::vector<AnsweredCasts> all;
  for (const auto& library : offer.libraries) all.push_back(measured(*library, work, arguments.rounds));
  judge(work, arguments.verify ? Judged::all : Judged::differing, all);
  Measurements measurements;
  for (const AnsweredCasts& one : all) measurements.results.push_back(one.result);
  for (const Unasked& one : offer.unasked) measurements.not_measured.push_back({one.who, "casts", 1, one.reason});
  const std::vector<CastAnswer>& ours = all.front().answers;
  auto report = report_of("casts", {{"pair", arguments.pair},
                                    {"regime", arguments.regime},
                                    {"seed", arguments.seed},
                                    {"block", cast_block},
                                    {"rounds", arguments.rounds},
                                    {"hits", std::ranges::count(ours, true, &CastAnswer::hit)},
                                    {"uncertain", std::ranges::count(ours, false, &CastAnswer::certain)}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
