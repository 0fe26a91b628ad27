#pragma once

#include <optional>

#include "oracle/rigid_motion.hpp"

namespace toccata::oracle {

/// Two bodies in numbers of the processor. It says only what more than their rounding speaks for; the rest is for 60
/// digits.
class QuickLook {
 public:
  QuickLook(const FineBody& a, const FineBody& b);

  enum class Sight { apart, meet, unclear };
  /// How they are at a time.
  [[nodiscard]] Sight at(double time);

  /// Whether they are seen to be apart at all times that differ from `middle` by at most `half`.
  [[nodiscard]] bool apart_around(double middle, double half);

  /// How fast the distance changes at most.
  [[nodiscard]] long double speed() const { return speed_; }

 private:
  using Number = long double;
  using Point = PointOf<Number>;
  using Set = SetOf<Number>;

  /// A body seen from its centre, which moves straight on. For a half-space the set is its point.
  struct Body {
    Body(const FineBody& body, const Vec3& origin);
    void place(Number time, const Point& from);

    Set start;
    std::optional<Point> normal;
    Point centre;  ///< from the common origin
    Point way;
    Point axis{0, 0, 1};
    Number rate = 0;   ///< angle in a unit of time
    Number reach = 0;  ///< no point, less the radius, is farther from the centre
    // At the time that was looked at last:
    Set now;
    Point centre_now;
    Point up;
  };

  /// They are apart by `gap` along the direction, which has the length 1 and leads from B to A.
  struct Separation {
    Number gap = 0;
    Point direction{};
    bool meet = false;
    SimplexOf<Number> around;
  };

  [[nodiscard]] Separation separation_at(Number time);
  [[nodiscard]] bool stays_apart(const Separation& separation, const Point& turning, Number half) const;
  [[nodiscard]] Number least_at(const Separation& separation, const Point& turning, Number later) const;

  Body a_, b_;
  Number far_ = 0;  ///< no point of one is ever farther from a point of the other; of a half-space, from its point
  Number speed_ = 0;
  Number bend_ = 0;  ///< how fast the ways of two points bend against each other
  Number slack_ = 0;
  Number last_time_ = -1;
  Point last_direction_{1, 0, 0};
};

}  // namespace toccata::oracle
