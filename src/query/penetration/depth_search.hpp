#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "math/vec3_measures.hpp"
#include "query/penetration/separating_seeds.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/penetration.hpp"

// What the searches for the depth of solids share.
namespace toccata {

/// A way that is made longer to part two solids grows by at least that, however small they are.
inline constexpr double least_step = 0x1p-1020;

/// The greatest share of the coordinates and the way that rounding can move a vertex by.
inline constexpr double separation_slack = 0x1p-48;

/// Squares of greater and lesser extents leave the doubles.
inline constexpr double least_extent = 0x1p-450, greatest_extent = 0x1p450;

/// What is asked of two solids whose convex bodies are searched.
struct SeparatingQuestions {
  /// A lower bound of the distance of A from B, moved; 0 when they meet.
  std::function<double(const Vec3& move)> distance;
  /// Some of the points at which their surfaces meet.
  std::function<std::vector<SurfaceIntersection>(const Vec3& move)> intersections;
};

/// When a search ends: as soon as the bracket is narrow, its time is over, or somebody wants an end (SearchScratch).
class DepthLimit {
 public:
  explicit DepthLimit(const DepthOptions& options, const SearchScratch* scratch = nullptr)
      : ratio_(1 + options.precision), seconds_(options.time_limit), scratch_(scratch), start_(Clock::now()) {}

  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] bool is_narrow(const Penetration& bracket) const { return bracket.upper <= ratio_ * bracket.lower; }
  [[nodiscard]] bool is_over() const {
    if (scratch_ != nullptr && scratch_->is_stopped()) return true;
    return seconds_ < std::numeric_limits<double>::infinity() &&
           std::chrono::duration<double>(Clock::now() - start_).count() >= seconds_;
  }
  /// How a search ended that found this bracket.
  [[nodiscard]] DepthEnd end_of(const Penetration& bracket) const {
    return is_narrow(bracket) ? DepthEnd::precise : is_over() ? DepthEnd::out_of_time : DepthEnd::exhausted;
  }

 private:
  using Clock = std::chrono::steady_clock;

  double ratio_;
  double seconds_;
  const SearchScratch* scratch_;
  Clock::time_point start_;
};

/// The bracket of a depth so far, and the ways out that are tried to make its upper end less.
class TriedWays {
 public:
  /// `extent`: the greatest coordinates of both, added up.
  TriedWays(const SeparatingQuestions& questions, const DepthLimit& limit, double extent)
      : questions_(questions), limit_(limit), extent_(extent) {}

  /// What rounding may make of the distance after a way of that length.
  [[nodiscard]] double slack(double length) const { return separation_slack * (extent_ + length); }
  [[nodiscard]] bool parted(const Vec3& move) const { return questions_.distance(move) > slack(plain_length(move)); }

  /// Whether it is shorter than the best so far, and parts them.
  bool attempt(const Vec3& direction, double length) {
    if (!(length < best.upper) || direction == Vec3{} || !parted(length * direction)) return false;
    best.upper = length;
    best.direction = direction;
    return true;
  }

  /// Along the best way: each step halves what is between it and the depth from below.
  void shorten(int steps) {
    double meeting = best.lower;
    for (int i = 0; i < steps && best.upper < std::numeric_limits<double>::infinity() && !limit_.is_over(); ++i) {
      const double middle = meeting + (best.upper - meeting) / 2;
      if (!attempt(best.direction, middle)) meeting = middle;
    }
  }

  Penetration best{.upper = std::numeric_limits<double>::infinity()};

 private:
  const SeparatingQuestions& questions_;
  const DepthLimit& limit_;
  double extent_;
};

}  // namespace toccata
