#include "toccata/narrow/casts.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/gjk.hpp"
#include "narrow/swept_meeting.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The interval's width, of the whole way.
constexpr double time_width = 0x1p-41;
constexpr int most_steps = 40;

/// A plane across `direction` that keeps the shapes apart until `time`; both proved.
struct Separation {
  double time = 0;
  bool for_ever = false;  ///< and after
};

/// One cast: A is moved, B stands.
class ShapeCast {
 public:
  ShapeCast(const PosedConvex& a, const Vec3& motion, const PosedConvex& b)
      : a_(a),
        b_(b),
        motion_(motion),
        kernels_(support_kernels()),
        reach_(std::nextafter(a.radius() + b.radius(), HUGE_VAL)) {}

  /// For shapes that are apart at the start.
  Cast answer() {
    if (advance() || !reaches(1)) return {};
    narrow();
    return met();
  }

 private:
  /// Moves the time on, from separating plane to separating plane, as far as it certainly stays free. True when that is
  /// all the way: nothing is met. After the conservative advancement of B. Mirtich, "Impulse-based dynamic simulation
  /// of rigid body systems", 1996; each step ends where the plane of the last one no longer separates.
  bool advance() {
    for (int step = 0; step < most_steps; ++step) {
      const PosedConvex moved = a_.moved(free_until_ * motion_);
      const GjkEnd end = search_nearest({moved, kernels_}, {b_, kernels_}, last_, {std::nan("")});
      last_ = end.simplex.pairs;
      if (end.inside || end.nearest == Vec3{}) return false;
      const Vec3 direction = scaled_direction(-end.nearest);
      const Separation found = separation(direction);
      if (found.for_ever || found.time > 1) return true;
      if (!(found.time > free_until_)) return false;
      normal_ = -direction;
      const bool arrived = found.time - free_until_ < time_width / 8;
      free_until_ = found.time;
      if (arrived) return false;
    }
    return false;
  }

  /// The greatest coordinate becomes about 1/2, which the supports' bounds want.
  static Vec3 scaled_direction(const Vec3& d) {
    const double greatest = std::fmax(std::fmax(std::fabs(d.x), std::fabs(d.y)), std::fabs(d.z));
    const int exponent = std::ilogb(greatest) + 1;
    return {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent), std::scalbn(d.z, -exponent)};
  }

  /// Until when the cores lie more than the radii apart along the direction: gap − time · speed > reach · |direction|.
  [[nodiscard]] Separation separation(const Vec3& direction) const {
    if (!in_certain_range(direction)) return {};
    const double of_b = SupportSearch(b_, kernels_).lower_bound(direction);
    const double of_a = SupportSearch(a_, kernels_).lower_bound(-direction);
    const double grown = reach_ * std::sqrt(dot(direction, direction));
    const double x = direction.x * motion_.x, y = direction.y * motion_.y, z = direction.z * motion_.z;
    const double magnitude = (std::fabs(x) + std::fabs(y)) + std::fabs(z);
    // A handful of roundings of 2^-53 each; underflow is within the floor.
    const double gap = ((of_b + of_a) - grown) - (0x1p-50 * ((std::fabs(of_b) + std::fabs(of_a)) + grown) + 0x1p-1000);
    const double speed = ((x + y) + z) + (0x1p-50 * magnitude + 0x1p-1000);
    if (speed <= 0) return {0, gap + free_until_ * -speed * (1 - 0x1p-50) > 0x1p-1000};
    return {gap > 0 ? (1 - 0x1p-50) * (gap / speed) : 0, false};
  }

  [[nodiscard]] bool reaches(double time) const { return swept_meets(a_, motion_, time, b_); }

  /// The first meeting lies between the time that is known to be free and one that is known to be late enough.
  void narrow() {
    double free = free_until_, late = 1;
    for (double width = time_width; free + width < late; width *= 64) {
      if (reaches(free + width)) {
        late = free + width;
      } else {
        free = free + width;
      }
    }
    while (late - free > time_width) {
      const double middle = free + (late - free) / 2;
      (reaches(middle) ? late : free) = middle;
    }
    free_until_ = free;
    late_ = late;
  }

  [[nodiscard]] Cast met() const {
    Cast cast;
    cast.hit = true;
    cast.lower = free_until_;
    cast.upper = late_;
    cast.point = distance(a_.moved(free_until_ * motion_), b_).on_b;
    const Vec3 against = normal_ == Vec3{} ? scaled_direction(-motion_) : normal_;
    cast.normal = (1 / std::sqrt(dot(against, against))) * against;
    return cast;
  }

  const PosedConvex& a_;
  const PosedConvex& b_;
  Vec3 motion_;
  SupportKernels kernels_;
  double reach_;
  VertexPairs last_;
  double free_until_ = 0;
  double late_ = 1;
  Vec3 normal_{};
};

Cast met_at_start(const Vec3& point) {
  Cast cast;
  cast.hit = true;
  cast.point = point;
  return cast;
}

}  // namespace

Cast cast_shape(const PosedConvex& a, const Vec3& motion, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  if (overlap(a, b, workspace)) return met_at_start(distance(a, b, workspace).on_b);
  if (motion == Vec3{}) return {};
  return ShapeCast(a, motion, b).answer();
}

Cast cast_ray(const Vec3& origin, const Vec3& motion, const PosedConvex& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  return cast_shape(PosedConvex(Point(origin)), motion, target);
}

}  // namespace toccata
