#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "narrow/convex/gjk_simplex.hpp"
#include "narrow/quadrics/plain_body.hpp"
#include "narrow/quadrics/weighted_generators.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {

/// The search of GJK for the point of the difference A − B that is nearest to the origin, on points of quadric bodies,
/// in doubles: a guess that is to be proved. It goes on where it was left.
class QuadricSearch {
 public:
  QuadricSearch(const PlainBody& a, const PlainBody& b, const Vec3& first_direction);
  /// The same in the image of the pair's frame under a linear map, where slim shapes may be round: what is nearest is
  /// another point there, but whether they meet is the same.
  QuadricSearch(const PlainBody& a, const PlainBody& b, const Vec3& first_direction, const Mat3& map);

  /// Goes on until a step would bring the nearest point nearer by less than this part of its distance, the origin
  /// seems to be inside, or nothing is gained. At most 128 steps in all.
  void run(double part);
  /// Goes on until the newest direction separates, or as `run`.
  void run_until_apart();
  /// Goes on until the distance seems to be more than this, or less.
  void run_until_compared(double length);

  struct Corner {
    QuadricSupport a;
    QuadricSupport b;
    double weight = 0;  ///< of the nearest point
  };
  /// Up to four; a range that a span may be made of.
  struct Simplex {
    std::array<Corner, 4> corner;
    std::size_t count = 0;

    [[nodiscard]] std::size_t size() const { return count; }
    [[nodiscard]] const Corner* begin() const { return corner.data(); }
    [[nodiscard]] const Corner* end() const { return corner.data() + count; }
  };
  /// The points on which the nearest one lies.
  [[nodiscard]] Simplex simplex() const;

  /// What carries the nearest point on one side: the generators of the corners that have a weight, each once, with the
  /// sum of its weights, and the mean of the round parts.
  struct Carried : WeightedGenerators<double, 4> {
    double grown = 0;  ///< the weight of the generators that have a round part
    Vec3 round;
  };
  enum class SideOf : std::uint8_t { a, b };
  [[nodiscard]] static Carried carried(std::span<const Corner> corners, SideOf which, const PlainBody& body);

  [[nodiscard]] const Vec3& nearest() const { return nearest_; }
  /// A direction of the search as one of the pair's frame.
  [[nodiscard]] Vec3 in_pair(const Vec3& d) const {
    return map_ ? d.x * (*map_)[0] + d.y * (*map_)[1] + d.z * (*map_)[2] : d;
  }
  [[nodiscard]] bool inside() const { return inside_; }
  /// The direction along which all of A − B lay farthest before the origin.
  [[nodiscard]] const Vec3& best_direction() const { return best_direction_; }
  [[nodiscard]] double best_gap() const { return best_gap_; }
  [[nodiscard]] bool stalled() const { return stalled_; }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  /// Tells whether the search may go on.
  bool step(double part);

  const PlainBody& a_;
  const PlainBody& b_;
  std::optional<Mat3> map_;
  GjkSimplex simplex_;  // the pairs name slots
  std::array<QuadricSupport, 5> slot_a_;
  std::array<QuadricSupport, 5> slot_b_;
  Vec3 nearest_;
  Vec3 direction_;
  Vec3 best_direction_;
  double best_gap_ = -HUGE_VAL;
  double squared_ = 0;
  double size_ = 0;
  std::uint64_t steps_ = 0;
  bool inside_ = false;
  bool stalled_ = false;
};

}  // namespace toccata
