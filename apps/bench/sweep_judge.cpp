#include "sweep_judge.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

/// So many times of convex bodies; of meshes fewer.
constexpr int looks_at_bodies = 400;
constexpr int looks_at_meshes = 50;

/// Bodies that are so far apart have not met: a hundredth of a body.
constexpr double early_distance = 0.01;

/// Rounded poses and rounded times move a point by less, bodies being of about size 1 and a way of at most 20.
constexpr double sweep_rounding = 1e-12;

/// Two bodies on their ways, looked at here and there.
class SweepTruth {
 public:
  SweepTruth(const SweepPair& pair, const SweepQuestion& question)
      : a_(std::visit([](const auto& shape) { return Model(shape); }, pair.a)),
        b_(std::visit([](const auto& shape) { return Model(shape); }, pair.b)),
        motion_a_(question.a.motion()),
        motion_b_(question.b.motion()),
        looks_(a_.has_mesh() ? looks_at_meshes : looks_at_bodies) {}

  /// The earliest time looked at when they overlap; 2 when they never do. Besides even times it is looked around all
  /// that somebody takes for the first, so that what one library alone has seen is no false alarm of its own.
  [[nodiscard]] double first_overlap(std::span<const SweepAnswer> told) const {
    double first = 2;
    for (int i = 0; i <= looks_ && first > 1; ++i) first = earlier(first, static_cast<double>(i) / looks_);
    for (const SweepAnswer& answer : told) {
      if (!answer.hit) continue;
      for (const double later : {0.0, 1e-9, 1e-6, 1e-4, 1e-3})
        for (const double time : {answer.lower - later, answer.upper + later})
          first = earlier(first, std::clamp(time, 0.0, 1.0));
    }
    return first;
  }

  [[nodiscard]] double distance_at(double time) const { return distance(a_, b_, poses(time)).upper; }

  [[nodiscard]] double least_distance() const {
    double least = HUGE_VAL;
    for (int i = 0; i <= looks_; ++i) least = std::min(least, distance_at(static_cast<double>(i) / looks_));
    return least;
  }

 private:
  [[nodiscard]] PairQuery poses(double time) const { return {motion_a_.at(time), motion_b_.at(time)}; }
  [[nodiscard]] double earlier(double first, double time) const {
    return time < first && overlap(a_, b_, poses(time)) ? time : first;
  }

  Model a_;
  Model b_;
  RigidMotion motion_a_;
  RigidMotion motion_b_;
  int looks_;
};

bool is_wrong(const SweepTruth& truth, const SweepAnswer& ours, double first_overlap) {
  if (!ours.hit) return first_overlap <= 1;
  // The overlap may be by rounding.
  const bool overlaps_before = first_overlap < ours.lower - sweep_rounding;
  const bool meets_then = !ours.is_decided || truth.distance_at(ours.upper) <= sweep_rounding;
  return overlaps_before || ours.lower > ours.upper || !meets_then;
}

void judge_answer(const SweepTruth& truth, const SweepAnswer& answer, double first_overlap, AnsweredSweeps& one) {
  one.undecided += !answer.is_decided;
  if (!answer.is_decided) return;
  if (!answer.hit)
    one.missed += first_overlap <= 1;
  else if (answer.upper > first_overlap + sweep_tolerance)
    ++one.late;
  else if (first_overlap > 1 && truth.least_distance() > sweep_tolerance)
    ++one.false_alarms;
  else if (truth.distance_at(answer.lower) > early_distance)
    ++one.early;
}

}  // namespace

void judge(const SweepWork& work, std::vector<AnsweredSweeps>& answered) {
  for (std::size_t i = 0; i < work.questions.size(); ++i) {
    const SweepQuestion& question = work.questions[i];
    const SweepTruth truth(work.pairs[question.pair], question);
    const SweepAnswer& ours = answered.front().answers[i];
    std::vector<SweepAnswer> told;
    for (const AnsweredSweeps& one : answered) told.push_back(one.answers[i]);
    const double first_overlap = truth.first_overlap(told);
    answered.front().result.wrong += is_wrong(truth, ours, first_overlap);
    for (AnsweredSweeps& one : answered) {
      judge_answer(truth, one.answers[i], first_overlap, one);
      one.result.disagreements += one.answers[i].hit != ours.hit;
    }
  }
}

}  // namespace toccata::bench
