#include "cast_judge.hpp"

#include <algorithm>
#include <cmath>

#include "cast_questions.hpp"
#include "fine_sets.hpp"

namespace toccata::bench {
namespace {

using oracle::Fine;

/// By so much of the way two answers differ that tell a hit.
double apart(const CastAnswer& x, const CastAnswer& ours) {
  const double error = std::max({0.0, ours.lower - x.upper, x.lower - ours.upper});
  return std::isnan(x.upper) ? INFINITY : error;
}

bool differ(const CastQuestion& question, const CastAnswer& x, const CastAnswer& ours) {
  return x.hit != ours.hit || (x.hit && apart(x, ours) * length(question.motion) > cast_tolerance);
}

oracle::FineSet fine_set_of_cast_body(const CastBody& body, const Pose& pose) {
  return std::visit([&]<class Shape>(const Shape& shape) { return fine_set_of(PosedAs<Shape>(shape, pose)); }, body);
}

oracle::FineSet moved(oracle::FineSet set, const Vec3& motion, const Fine& time) {
  const auto move = [&](oracle::FinePoint& p) {
    p = {p.x + time * Fine(motion.x), p.y + time * Fine(motion.y), p.z + time * Fine(motion.z)};
  };
  move(set.centre);
  for (oracle::FinePoint& vertex : set.vertices) move(vertex);
  return set;
}

/// The two shapes of a question, with 60 digits.
class CastTruth {
 public:
  CastTruth(const CastPair& pair, const CastQuestion& question)
      : pair_(pair),
        question_(question),
        moving_(fine_set_of_cast_body(pair.moving, question.start)),
        standing_(fine_set_of_cast_body(pair.standing, question.standing)) {}

  /// Whether an interval holds for what it says it is.
  [[nodiscard]] bool holds(const CastAnswer& ours) const {
    if (!ours.hit) return never_meet();
    if (!(ours.lower <= ours.upper && ours.upper <= 1)) return false;
    if (ours.lower > 0 && (at(ours.lower).meet || at(Fine(ours.lower) / 2).meet)) return false;
    return !ours.certain || at(ours.upper).lower <= Fine(1e-20);
  }

  /// Whether a peer's number is near enough, where ours holds.
  [[nodiscard]] bool is_near(const CastAnswer& peer, const CastAnswer& ours) const {
    if (std::isnan(peer.upper)) return false;
    if (!peer.hit) return !ours.hit || !deep_at(0.5 * (ours.upper + end_of_meeting(ours)));
    if (at(peer.upper).lower > cast_tolerance) return false;
    if (!ours.hit || (peer.upper - ours.upper) * length(question_.motion) <= cast_tolerance) return true;
    return !deep_at(peer.upper) && !deep_at(0.5 * (ours.upper + peer.upper));
  }

 private:
  [[nodiscard]] oracle::FineNearness at(const Fine& time) const {
    return fine_nearness(moved(moving_, question_.motion, time), standing_, 1e-9, 400);
  }

  [[nodiscard]] bool never_meet() const {
    constexpr int looks = 12;
    for (int i = 0; i <= looks; ++i)
      if (at(Fine(i) / looks).meet) return false;
    return true;
  }

  [[nodiscard]] bool deep_at(double time) const {
    const oracle::FineSet there = moved(moving_, question_.motion, time);
    return fine_nearness(there, standing_, 1e-9, 400).meet && FineHeights(there, standing_).least() > cast_tolerance;
  }

  /// On the way back they meet first where they part last.
  [[nodiscard]] double end_of_meeting(const CastAnswer& ours) const {
    CastQuestion back = question_;
    back.start.offset = question_.start.offset + question_.motion;
    back.motion = -question_.motion;
    const std::optional<Cast> cast = cast_of(pair_, back);
    return cast ? 1 - cast->lower : ours.upper;
  }

  const CastPair& pair_;
  const CastQuestion& question_;
  oracle::FineSet moving_;
  oracle::FineSet standing_;
};

void judge_one(const CastTruth& truth, std::size_t query, std::vector<AnsweredCasts>& answered) {
  const CastAnswer& ours = answered.front().answers[query];
  for (AnsweredCasts& one : answered) {
    const CastAnswer& answer = one.answers[query];
    const bool is_ours = one.result.who.library == answered.front().result.who.library;
    if (!(is_ours ? truth.holds(answer) : truth.is_near(answer, ours))) ++one.result.wrong;
  }
}

}  // namespace

void judge(const CastWork& work, Judged judged, std::vector<AnsweredCasts>& answered) {
  for (std::size_t query = 0; query < work.questions.size(); ++query) {
    const CastQuestion& question = work.questions[query];
    bool any = false;
    for (AnsweredCasts& one : answered) {
      if (!differ(question, one.answers[query], answered.front().answers[query])) continue;
      any = true;
      ++one.result.disagreements;
    }
    if (any) ++answered.front().result.disagreements;
    if (any || judged == Judged::all) judge_one({work.pairs[question.pair], question}, query, answered);
  }
}

}  // namespace toccata::bench
