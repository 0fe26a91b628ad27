#pragma once

#include <cmath>
#include <optional>

#include "math/constants.hpp"
#include "toccata/narrow/quadrics.hpp"

// How near are two shapes? Whether they overlap, whether they are within a distance, a bounded distance and the
// distance itself are one question with two numbers.
namespace toccata {

/// How much of a distance is wanted. Lengths are in world units, and `enough` is not more than the limit.
struct WantedDistance {
  double limit = infinity;  ///< nothing is wanted of shapes that are farther apart
  double enough = -1;       ///< of shapes that are no farther apart only this is wanted; negative: all distances are

  /// Only whether the distance is at most this length; of 0, whether the shapes overlap.
  [[nodiscard]] static constexpr WantedDistance within(double length) { return {length, length}; }

  /// No distance is wanted, only whether it is enough.
  [[nodiscard]] constexpr bool is_yes_or_no() const { return limit == enough; }
};

/// The answer of shapes that are near. The exact distance of others is certainly more than the limit.
struct Nearby {
  Distance distance;      ///< where it was enough: from 0 to `enough`, without points
  bool is_within = true;  ///< the exact distance is at most the limit; of a quadric, it may be
};

[[nodiscard]] inline std::optional<Nearby> flipped(const std::optional<Nearby>& found) {
  return found ? std::optional(Nearby{flipped(found->distance), found->is_within}) : std::nullopt;
}

/// A distance that lies in the interval of a pair and is less than `upper`, or has an interval with a lesser upper end,
/// is not above this.
[[nodiscard]] inline double limit_from(double upper) { return std::nextafter(upper * (1 + 4e-12), infinity); }

/// What is certainly farther apart need not be looked at.
[[nodiscard]] inline double search_limit(const WantedDistance& wanted) {
  return wanted.is_yes_or_no() ? wanted.limit : limit_from(wanted.limit);
}

// The distance is that of `distance`, to the last bit, where it is at most the limit or only its interval reaches above
// it. Nothing is told where it is more by at least 4 · 10⁻¹² of it. Whether it is at most a number is exact; of a
// quadric a no is proved, and a number within the interval of the distance counts as yes. What is kept saves time
// alone.
[[nodiscard]] std::optional<Nearby> nearby(const PosedPolytope& a, const PosedPolytope& b, const WantedDistance& wanted,
                                           SimplexCache* kept = nullptr);
[[nodiscard]] std::optional<Nearby> nearby(const PosedPolytope& a, const PosedHalfSpace& b,
                                           const WantedDistance& wanted);
[[nodiscard]] std::optional<Nearby> nearby(const PosedHalfSpace& a, const PosedHalfSpace& b,
                                           const WantedDistance& wanted);
[[nodiscard]] std::optional<Nearby> nearby(const PosedQuadric& a, const PosedQuadric& b, const WantedDistance& wanted);
[[nodiscard]] std::optional<Nearby> nearby(const PosedQuadric& a, const PosedPolytope& b, const WantedDistance& wanted);
[[nodiscard]] std::optional<Nearby> nearby(const PosedQuadric& a, const PosedHalfSpace& b,
                                           const WantedDistance& wanted);

/// Proved in doubles to be farther apart than this: much quicker than a distance. False says nothing.
[[nodiscard]] bool certainly_beyond(const PosedPolytope& a, const PosedPolytope& b, double length,
                                    SimplexCache* kept = nullptr);

/// Along the direction, which need not have length 1, all of B is farther than all of A by this length.
struct DirectedGap {
  double length = 0;  ///< 0: no gap is known
  Vec3 direction{};
};

/// Proved in doubles too: a gap of `enough`, or the largest that the search came upon.
[[nodiscard]] DirectedGap certain_gap(const PosedPolytope& a, const PosedPolytope& b, double enough,
                                      SimplexCache* kept = nullptr);

/// What takes less time for a pair: to compare its distance with a length, or to find it.
enum class Quicker { comparison, distance };

/// The answer for a pair by its two ways: `is_within(length)` decides, and `distance()` finds.
template <class IsWithin, class FindDistance>
std::optional<Nearby> nearby_by(const WantedDistance& wanted, Quicker quicker, const IsWithin& is_within,
                                const FindDistance& distance) {
  if (wanted.enough >= 0 && is_within(wanted.enough)) return Nearby{{.upper = wanted.enough}};
  if (wanted.is_yes_or_no()) return {};
  const double limit = limit_from(wanted.limit);
  if (quicker == Quicker::comparison && limit < infinity && !is_within(limit)) return {};
  const Distance found = distance();
  if (found.lower > limit) return {};
  return Nearby{found, found.upper <= wanted.limit || (found.lower <= wanted.limit && is_within(wanted.limit))};
}

}  // namespace toccata
