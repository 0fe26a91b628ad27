#include "convex_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "convex_questions.hpp"
#include "fine_sets.hpp"
#include "oracle/penetration.hpp"

namespace toccata::bench {
namespace {

oracle::ConvexSet set_of(const PosedPolytope& shape) {
  oracle::ConvexSet set;
  for (Index i = 0; i < shape.vertex_count(); ++i) set.vertices.push_back(oracle::exact(shape.vertex(i)));
  set.radius = oracle::exact(shape.radius());
  return set;
}

double error_of(const ConvexAnswer& answer, const ConvexAnswer& ours) {
  const double error = std::max({0.0, ours.lower - answer.upper, answer.lower - ours.upper});
  return std::isnan(answer.upper) ? INFINITY : error;
}

/// The contact of shapes with round sides is compared as a depth and a normal.
bool is_manifold_of_quadric(const ConvexWork& work) {
  return work.task == ConvexTask::manifold && has_quadric(work.pair);
}

bool has_number(const ConvexWork& work) {
  return work.task == ConvexTask::distance || work.task == ConvexTask::penetration || is_manifold_of_quadric(work);
}

bool is_along(const Vec3& x, const Vec3& y) {
  const Vec3 across = cross(x, y);
  return dot(x, y) > 0 && dot(across, across) <= convex_tolerance * convex_tolerance;
}

bool differ(const ConvexWork& work, const ConvexAnswer& x, const ConvexAnswer& ours) {
  return x.overlap != ours.overlap || (has_number(work) && error_of(x, ours) > convex_tolerance) ||
         (is_manifold_of_quadric(work) && ours.overlap && !is_along(x.direction, ours.direction));
}

/// What is allowed of Toccata's own number: nothing of an interval; the depth of a manifold is a single number.
double own_tolerance(ConvexTask task) { return task == ConvexTask::manifold ? 0x1p-20 : 0; }

/// The two shapes of a question, exactly.
class Truth {
 public:
  Truth(const ConvexWork& work, const ConvexQuestion& question)
      : task_(work.task),
        a_(set_of(posed(work.pairs[question.pair].a, question.a))),
        b_(set_of(posed(work.pairs[question.pair].b, question.b))) {}

  bool is_right(const ConvexAnswer& answer, double tolerance) const {
    if (std::isnan(answer.lower) || std::isnan(answer.upper)) return false;
    // A depth of 0 does not tell whether shapes touch, so penetration is right or not as a number.
    if (task_ != ConvexTask::penetration && answer.overlap != oracle::overlap(a_, b_)) return false;
    if (task_ != ConvexTask::distance && task_ != ConvexTask::penetration) return true;
    const double low = answer.lower - tolerance;
    if (low > 0 && compare(low) < 0) return false;
    if (compare(answer.upper + tolerance) > 0) return false;
    return task_ == ConvexTask::distance || answer.upper <= tolerance || parts(answer, tolerance);
  }

 private:
  int compare(double number) const {
    return task_ == ConvexTask::distance ? oracle::compare_distance(a_, b_, oracle::exact(number))
                                         : oracle::compare_penetration(a_, b_, oracle::exact(number));
  }

  /// B moved by the depth along the direction is behind A, but for the tolerance.
  bool parts(const ConvexAnswer& answer, double tolerance) const {
    const Vec3& n = answer.direction;
    double of_a = -INFINITY, of_b = INFINITY;
    for (const auto& v : a_.vertices) of_a = std::max(of_a, along(n, v));
    for (const auto& v : b_.vertices) of_b = std::min(of_b, along(n, v));
    const double radii = static_cast<double>(a_.radius) + static_cast<double>(b_.radius);
    return of_a - of_b + radii <= answer.upper + tolerance + 1e-13;
  }

  static double along(const Vec3& n, const oracle::RationalPoint& v) {
    return dot(n, Vec3{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)});
  }

  ConvexTask task_;
  oracle::ConvexSet a_;
  oracle::ConvexSet b_;
};

/// The two shapes of a question of which one is a quadric, with 60 digits.
class FineTruth {
 public:
  FineTruth(const ConvexWork& work, const ConvexQuestion& question)
      : task_(work.task),
        a_(fine_set_of(work.pairs[question.pair].a, question.a)),
        b_(fine_set_of(work.pairs[question.pair].b, question.b)),
        near_(fine_nearness(a_, b_, 1e-14, 400)) {
    if (is_depth_asked() && near_.meet) depth_ = FineHeights(a_, b_).least();
  }

  bool is_right(const ConvexAnswer& answer, double tolerance) const {
    if (std::isnan(answer.lower) || std::isnan(answer.upper)) return false;
    if (is_depth_asked()) return is_depth(answer, tolerance);
    if (answer.overlap ? near_.lower > tolerance : near_.meet && near_.depth > tolerance) return false;
    if (task_ == ConvexTask::overlap) return true;
    return near_.upper >= answer.lower - tolerance && near_.lower <= answer.upper + tolerance;
  }

 private:
  [[nodiscard]] bool is_depth_asked() const {
    return task_ == ConvexTask::penetration || task_ == ConvexTask::manifold;
  }

  /// Along its own direction B leaves A, and along no other sooner.
  [[nodiscard]] bool is_depth(const ConvexAnswer& answer, double tolerance) const {
    if (!near_.meet) return answer.upper <= tolerance;
    if (!(answer.upper > tolerance)) return depth_ <= answer.upper + tolerance;
    const oracle::Fine own = FineHeights(a_, b_).along(answer.direction);
    return own <= answer.upper + tolerance && std::min(own, depth_) >= answer.lower - tolerance;
  }

  ConvexTask task_;
  oracle::FineSet a_;
  oracle::FineSet b_;
  oracle::FineNearness near_;
  oracle::Fine depth_ = 0;
};

template <class AnyTruth>
void judge_one(const ConvexWork& work, std::size_t query, std::vector<ConvexResult>& results) {
  const AnyTruth truth(work, work.questions[query]);
  for (ConvexResult& result : results) {
    const double tolerance =
        result.who.library == results.front().who.library ? own_tolerance(work.task) : convex_tolerance;
    if (!truth.is_right(result.answers[query], tolerance)) ++result.wrong;
  }
}

}  // namespace

void judge(const ConvexWork& work, Judged judged, std::vector<ConvexResult>& results) {
  for (std::size_t query = 0; query < work.questions.size(); ++query) {
    const ConvexAnswer& ours = results.front().answers[query];
    bool any = false;
    for (ConvexResult& result : results) {
      if (has_number(work)) result.worst_error = std::max(result.worst_error, error_of(result.answers[query], ours));
      if (!differ(work, result.answers[query], ours)) continue;
      any = true;
      ++result.disagreements;
    }
    if (any) ++results.front().disagreements;
    if (any || judged == Judged::all)
      has_quadric(work.pair) ? judge_one<FineTruth>(work, query, results) : judge_one<Truth>(work, query, results);
  }
}

}  // namespace toccata::bench
