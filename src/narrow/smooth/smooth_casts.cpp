#include "toccata/narrow/smooth_casts.hpp"

#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/smooth/smooth_nearest.hpp"
#include "narrow/smooth/smooth_order.hpp"
#include "narrow/smooth/smooth_ray.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double time_width = 0x1p-42;
constexpr int most_steps = 64;

/// A, the body of a smooth shape, moves; B stands. By conservative advancement (B. Mirtich, "Impulse-based dynamic
/// simulation of rigid body systems", 1996), with every separating plane proved.
class SmoothCast {
 public:
  SmoothCast(const SmoothBody& a, const BoundedVector& motion, const SmoothBody& b) : a_(a), motion_(motion), b_(b) {}

  /// `point` in the pair's frame, `normal` from B to A.
  Cast answer() {
    const SmoothNearest start = at(0);
    if (start.contact != SmoothContact::apart) {
      point_ = start.on_b;
      normal_ = {};
      return met(0, start.contact);
    }
    for (int step = 0; step < most_steps; ++step) {
      const SmoothNearest now = at(free_until_);
      if (now.contact != SmoothContact::apart) break;
      normal_ = {now.direction[0].high, now.direction[1].high, now.direction[2].high};
      point_ = now.on_b;
      const double time = separated_until(now.direction);
      if (time > 1) return {};
      if (!(time > free_until_)) break;
      const bool arrived = time - free_until_ < time_width / 4;
      free_until_ = time;
      if (arrived) break;
    }
    return narrowed();
  }

 private:
  [[nodiscard]] SmoothNearest at(double time) const {
    return nearest_of(a_.moved(exactly(time) * motion_), b_, SmoothQuestion::distance);
  }

  /// How long the plane across the direction keeps them apart; more than 1 when for the whole way.
  [[nodiscard]] double separated_until(const FineDirection& direction) const {
    const FineDirection back{-direction[0], -direction[1], -direction[2]};
    const BoundedNumber gap = -(height_of<BoundedNumber>(a_, back) + height_of<BoundedNumber>(b_, direction));
    BoundedVector d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = {direction[i], 0};
    const BoundedNumber approach = -dot(motion_, d);
    // It comes nearer by no more than this in the whole time.
    const double fastest = ceiling_of(approach);
    if (gap.is_positive() && floor_of(gap) > fastest) return 2;
    // What has passed goes away from the plane for the rest of the way.
    const bool is_leaving = fastest <= 0 && (gap - exactly(free_until_) * approach).is_positive();
    if (is_leaving) return 2;
    const double time = floor_of(gap / exactly(fastest));
    return time == time ? time : 0;
  }

  /// From the time until which they are free to one at which they have met.
  Cast narrowed() {
    double late = 1;
    SmoothContact meets = SmoothContact::undecided;
    for (double width = time_width; meets != SmoothContact::contact; width *= 16) {
      late = std::fmin(1, free_until_ + width);
      const SmoothNearest then = at(late);
      meets = then.contact;
      if (meets != SmoothContact::apart) point_ = then.on_b;
      if (late == 1) break;
    }
    return meets == SmoothContact::apart ? grazed() : met(late, meets);
  }

  /// Neither met at the end nor kept apart by the planes on the way.
  Cast grazed() { return met(1, SmoothContact::undecided); }

  [[nodiscard]] Cast met(double late, SmoothContact how) const {
    Cast cast;
    cast.hit = true;
    cast.lower = free_until_;
    cast.upper = late;
    cast.point = point_;
    cast.normal = unit_or_zero(normal_);
    const bool is_narrow = late - free_until_ <= 4 * time_width;
    cast.status =
        how == SmoothContact::undecided ? Status::undecided : (is_narrow ? Status::exact : Status::not_converged);
    return cast;
  }

  const SmoothBody& a_;
  BoundedVector motion_;
  const SmoothBody& b_;
  double free_until_ = 0;
  Vec3 normal_;
  Vec3 point_;
};

void require_motion(const Vec3& motion) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
}

Cast in_world(Cast cast, const PairFrame& frame) {
  if (cast.hit) cast.point = frame.back(cast.point);
  return cast;
}

/// The other one moves instead: its point of contact is where the first has come to by then.
Cast seen_from_other(Cast cast, const Vec3& motion) {
  if (!cast.hit) return cast;
  cast.point = cast.point + cast.lower * motion;
  cast.normal = -cast.normal;
  return cast;
}

template <class Body>
Cast cast_bodies(const PosedSmooth& a, const Vec3& motion, const PairFrame& frame, const Body& b) {
  const SmoothBody body_a(a, frame);
  return in_world(SmoothCast(body_a, frame.scaled(motion), b).answer(), frame);
}

/// The line's entry, where that is certain.
std::optional<Cast> by_roots(const Vec3& origin, const Vec3& motion, const PosedSmooth& target) {
  const PairFrame frame = pair_frame(target, target);
  const SmoothBody body(target, frame);
  const auto within = line_within(body, frame.place(origin), frame.scaled(motion));
  if (!within) return {};
  const BoundedNumber one = exactly(1.0);
  if (within->empty || (within->enters - one).is_positive() || within->leaves.is_negative()) return Cast{};
  if (!within->leaves.is_positive() || !(one - within->enters).is_positive()) return {};
  Cast cast;
  cast.hit = true;
  cast.point = origin;
  if (within->enters.is_negative()) return cast;
  if (!within->enters.is_positive()) return {};
  cast.lower = std::fmax(0, floor_of(within->enters));
  cast.upper = std::fmin(1, ceiling_of(within->enters));
  if (cast.upper - cast.lower > 4 * time_width) return {};
  cast.point = origin + cast.lower * motion;
  cast.normal = unit_or_zero(within->normal);
  return cast;
}

}  // namespace

Cast cast_ray(const Vec3& origin, const Vec3& motion, const PosedSmooth& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  require_motion(motion);
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  if (const auto cast = by_roots(origin, motion, target)) return *cast;
  return cast_shape(PosedConvex(Point(origin)), motion, target);
}

Cast cast_shape(const PosedSmooth& a, const Vec3& motion, const PosedConvex& b) {
  require_motion(motion);
  const PairFrame frame = pair_frame(a, b);
  return cast_bodies(a, motion, frame, SmoothBody(b, frame));
}

Cast cast_shape(const PosedSmooth& a, const Vec3& motion, const PosedSmooth& b) {
  require_motion(motion);
  const PairFrame frame = pair_frame(a, b);
  return cast_bodies(a, motion, frame, SmoothBody(b, frame));
}

Cast cast_shape(const PosedConvex& a, const Vec3& motion, const PosedSmooth& b) {
  return seen_from_other(cast_shape(b, -motion, a), motion);
}

Cast cast_shape(const PosedSmooth& a, const Vec3& motion, const PosedHalfSpace& b) {
  require_motion(motion);
  const PairFrame frame = pair_frame(a, a);
  const SmoothBody body(a, frame);
  const double scale = std::scalbn(1.0, -std::ilogb(largest_magnitude(b.normal)));
  const BoundedVector n = exactly(scale * b.normal);
  const FineDirection down = fine(-(scale * b.normal));
  const BoundedNumber height = -(height_of<BoundedNumber>(body, down) + dot(n, frame.place(b.point)));
  const BoundedNumber fall = -dot(n, frame.scaled(motion));
  Cast cast;
  if (!height.is_positive()) {
    cast.hit = true;
    cast.point = distance(a, b).on_b;
    cast.status = height.is_negative() ? Status::exact : Status::undecided;
    return cast;
  }
  if (!fall.is_positive()) {
    // Certainly not falling, or so little that it stays above.
    if ((height - fall).is_positive()) return cast;
  }
  const BoundedNumber time = height / fall;
  if ((time - exactly(1.0)).is_positive()) return cast;
  cast.hit = true;
  cast.lower = std::fmax(0, floor_of(time));
  cast.upper = std::fmin(1, ceiling_of(time));
  cast.status = time.is_positive() && !(exactly(1.0) - time).is_positive() ? Status::undecided : Status::exact;
  cast.normal = unit_or_zero(b.normal);
  cast.point = frame.back(body.support(-(scale * b.normal)).point) + cast.lower * motion;
  return cast;
}

Cast cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedSmooth& b) {
  return seen_from_other(cast_shape(b, -motion, a), motion);
}

}  // namespace toccata
