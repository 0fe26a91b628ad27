#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "truth.hpp"

namespace toccata::bench {
namespace {

/// What doubles may round of a distance of ordinary meshes.
constexpr double distance_tolerance = 1e-9;

bool are_near(double x, double y) { return std::abs(x - y) <= distance_tolerance * std::max(x, y); }

bool differ(Task task, const Answer& x, const Answer& y) {
  if (asks_distance(task)) return !are_near(x.distance, y.distance);
  return task == Task::overlap ? x.overlap != y.overlap : x.pairs != y.pairs;
}

/// The pairs that some library lists and another does not.
std::set<std::pair<Index, Index>> disputed_pairs(const std::vector<Answered>& answered, std::size_t query) {
  std::set<std::pair<Index, Index>> disputed;
  const TrianglePairs& ours = answered.front().answers[query].pairs;
  for (const Answered& other : answered) {
    const TrianglePairs& theirs = other.answers[query].pairs;
    std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                  std::inserter(disputed, disputed.end()));
  }
  return disputed;
}

void judge_contacts(const Questions& questions, std::size_t query, std::vector<Answered>& answered) {
  const TrueMeshes meshes(questions.a, questions.b, questions.poses[query]);
  std::set<std::pair<Index, Index>> pairs = disputed_pairs(answered, query);
  if (questions.judged == Judged::all)
    for (const auto& pair : meshes.candidates()) pairs.insert(pair);
  std::vector<char> wrong(answered.size(), 0);
  for (const auto& pair : pairs) {
    const bool meet = meshes.meet(pair);
    for (std::size_t i = 0; i < answered.size(); ++i) {
      const TrianglePairs& listed = answered[i].answers[query].pairs;
      if (std::binary_search(listed.begin(), listed.end(), pair) != meet) wrong[i] = 1;
    }
  }
  for (std::size_t i = 0; i < answered.size(); ++i) answered[i].result.wrong += wrong[i] != 0 ? 1 : 0;
}

void judge_overlap(const Questions& questions, std::size_t query, std::vector<Answered>& answered) {
  const bool meet = TrueMeshes(questions.a, questions.b, questions.poses[query]).meet();
  for (Answered& one : answered)
    if (one.answers[query].overlap != meet) ++one.result.wrong;
}

/// No distance is less than that of the nearest of the pairs that are named; whoever told another is wrong.
void judge_distance(const Questions& questions, std::size_t query, std::vector<Answered>& answered) {
  const TrueMeshes meshes(questions.a, questions.b, questions.poses[query]);
  double least = INFINITY;
  for (const Answered& one : answered)
    least = std::min(least, std::sqrt(meshes.squared_distance(one.answers[query].pairs.front())));
  for (Answered& one : answered)
    if (!are_near(one.answers[query].distance, least)) ++one.result.wrong;
}

void judge_one(const Questions& questions, std::size_t query, std::vector<Answered>& answered) {
  if (asks_distance(questions.task)) return judge_distance(questions, query, answered);
  return questions.task == Task::overlap ? judge_overlap(questions, query, answered)
                                         : judge_contacts(questions, query, answered);
}

/// Toccata says the same in every way that it can be asked, to the bit.
void judge_ways(std::vector<Answered>& answered) {
  const Answered& first = answered.front();
  for (Answered& one : answered) {
    if (one.result.who.library != first.result.who.library) continue;
    for (std::size_t query = 0; query < one.answers.size(); ++query)
      if (one.answers[query].distance != first.answers[query].distance ||
          one.answers[query].pairs != first.answers[query].pairs)
        ++one.result.wrong;
  }
}

}  // namespace

void judge(const Questions& questions, std::vector<Answered>& answered) {
  for (Answered& one : answered)
    for (Answer& answer : one.answers) std::sort(answer.pairs.begin(), answer.pairs.end());
  for (std::size_t query = 0; query < questions.poses.size(); ++query) {
    bool any = false;
    for (Answered& one : answered)
      if (differ(questions.task, one.answers[query], answered.front().answers[query])) {
        any = true;
        ++one.result.disagreements;
      }
    if (any) ++answered.front().result.disagreements;
    if (!any && questions.judged == Judged::differing) continue;
    judge_one(questions, query, answered);
  }
  if (questions.task == Task::coherent_distance) judge_ways(answered);
}

void judge(std::span<const TriangleQuestion> questions, const std::vector<std::vector<char>>& answers, Judged judged,
           std::vector<Result>& results) {
  for (std::size_t query = 0; query < questions.size(); ++query) {
    bool any = false;
    for (std::size_t i = 0; i < results.size(); ++i)
      if (answers[i][query] != answers.front()[query]) {
        any = true;
        ++results[i].disagreements;
      }
    if (any) ++results.front().disagreements;
    if (!any && judged == Judged::differing) continue;
    const char truth = truly_meet(questions[query].a, questions[query].b) ? 1 : 0;
    for (std::size_t i = 0; i < results.size(); ++i) results[i].wrong += answers[i][query] != truth ? 1 : 0;
  }
}

}  // namespace toccata::bench
