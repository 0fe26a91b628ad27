#include "toccata/narrow/quadrics.hpp"

#include <cmath>
#include <optional>

#include "core/certain_answer.hpp"
#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/time_width.hpp"
#include "narrow/quadrics/casts/quadric_advance.hpp"
#include "narrow/quadrics/casts/quadric_cast_until.hpp"
#include "narrow/quadrics/casts/quadric_ray.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "narrow/quadrics/quadric_order.hpp"
#include "narrow/seen_from_target.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr int most_quadric_cast_steps = 64;
/// A time after the end of the way.
constexpr double after_the_way = 2;

/// A box in the pair's frame, that tells what certainly lies within; nothing does, of other shapes.
class BoxWithin {
 public:
  BoxWithin() = default;
  BoxWithin(const PosedPolytope& shape, const PairFrame& frame)
      : linear_(shape.pose().linear),
        half_(frame.factor * shape.as_box().half_extents),
        centre_(frame.plainly_placed(shape.as_box().centre)),
        off_(64 * unit_roundoff + 2 * frame.factor * shape.as_box().slack + 24 * shape.as_box().skew) {}

  // Coordinates in the pair's frame are at most 4 here, so the difference of the point and the centre is off by 14 u,
  // and its product with a side by 21 u more, and 2 u of what is left. The sides are askew: that counts 3 times for the
  // inverse, of what is no longer than 7. All corners may lie inside the box of the formula by the slack.
  [[nodiscard]] bool holds(const BoundedVector& point) const {
    const Vec3 from_centre = plain(point) - centre_;
    for (int j = 0; j < 3; ++j) {
      const bool is_known = point[static_cast<std::size_t>(j)].error < 0x1p-60 && std::fabs(from_centre[j]) <= 4;
      if (!is_known || !(half_[j] - std::fabs(dot(linear_.column(j), from_centre)) > off_)) return false;
    }
    return true;
  }

 private:
  Mat3 linear_;
  Vec3 half_;
  Vec3 centre_;
  double off_ = HUGE_VAL;
};

BoxWithin box_within(const PosedPolytope& shape, const PairFrame& frame) { return {shape, frame}; }
BoxWithin box_within(const PosedQuadric&, const PairFrame&) { return {}; }

/// A, the body of a quadric, moves; B stands. By conservative advancement (B. Mirtich, "Impulse-based dynamic
/// simulation of rigid body systems", 1996), with every separating plane proved: in doubles as far as they go.
class QuadricCast {
 public:
  QuadricCast(const QuadricBody& a, const BoundedVector& motion, const QuadricBody& b, const BoxWithin& box)
      : a_(a), motion_(motion), b_(b), box_(box) {}

  /// `point` in the pair's frame, `normal` from B to A. Nothing, where they do not meet or are free until the limit.
  /// `start` is what is nearest at the start, where not even that is known to be free.
  std::optional<Cast> answer(const QuadricAdvance& begun, const std::optional<QuadricNearest>& start, double limit) {
    if (free_until_is(begun) > limit) return {};
    if (start) {
      if (start->contact != QuadricContact::apart) {
        point_ = start->on_b;
        normal_ = {};
        return met(0, start->contact);
      }
    } else if (const auto soon = met_soon(begun)) {
      return soon;
    }
    if (advance(limit) > limit) return {};
    return narrowed();
  }

 private:
  /// Takes over what is proved, with the last plane's height in double words.
  double free_until_is(const QuadricAdvance& begun) {
    if (begun.for_ever) return after_the_way;
    if (!(begun.free_until > 0)) return 0;
    free_until_ = begun.free_until;
    normal_ = begun.direction;
    return free_until_ = std::fmax(free_until_, separated_until(fine(begun.direction)));
  }

  /// The cast that meets within the width from here; nothing when that is not certain.
  std::optional<Cast> met_soon(const QuadricAdvance& begun) {
    const double late = std::fmin(1, free_until_ + time_width);
    if (is_met_where_nearest(begun, late)) return met(late, QuadricContact::contact);
    const QuadricNearest then = at(late);
    if (then.contact != QuadricContact::contact) return {};
    point_ = then.on_b;
    return met(late, then.contact);
  }

  /// One of the two points that came next to each other is in both.
  bool is_met_where_nearest(const QuadricAdvance& begun, double late) {
    if (begun.on_b.size == 0) return false;
    const QuadricBody a = a_.moved(exactly(late) * motion_);
    const BoundedVector of_b = point_of<BoundedNumber>(b_, begun.on_b);
    point_ = plain(of_b);
    if (is_within(a, of_b)) return true;
    const BoundedVector of_a = point_of<BoundedNumber>(a, begun.on_a);
    return b_.quadric_kind() ? is_within(b_, of_a) : box_.holds(of_a);
  }

  /// Goes from plane to plane, until they are no longer known to be apart. Returns until when they are free.
  double advance(double limit) {
    for (int step = 0; step < most_quadric_cast_steps; ++step) {
      const QuadricNearest now = at(free_until_);
      if (now.contact != QuadricContact::apart) break;
      normal_ = {now.direction[0].high, now.direction[1].high, now.direction[2].high};
      point_ = now.on_b;
      const double time = separated_until(now.direction);
      if (time > 1) return after_the_way;
      if (!(time > free_until_)) break;
      const bool arrived = time - free_until_ < time_width / 4;
      free_until_ = time;
      if (arrived || time > limit) break;
    }
    return free_until_;
  }

  [[nodiscard]] QuadricNearest at(double time) const {
    return nearest_of(a_.moved(exactly(time) * motion_), b_, QuadricQuestion::distance);
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
    if (gap.is_positive() && floor_of(gap) > fastest) return after_the_way;
    // What has passed goes away from the plane for the rest of the way.
    const bool is_leaving = fastest <= 0 && (gap - exactly(free_until_) * approach).is_positive();
    if (is_leaving) return after_the_way;
    const double time = floor_of(gap / exactly(fastest));
    return time == time ? time : 0;
  }

  /// The cast narrowed from the time until which they are free to one at which they have met.
  Cast narrowed() {
    double late = 1;
    QuadricContact meets = QuadricContact::undecided;
    for (double width = time_width; meets != QuadricContact::contact; width *= 16) {
      late = std::fmin(1, free_until_ + width);
      const QuadricNearest then = at(late);
      meets = then.contact;
      if (meets != QuadricContact::apart) point_ = then.on_b;
      if (late == 1) break;
    }
    return meets == QuadricContact::apart ? grazed() : met(late, meets);
  }

  /// Neither met at the end nor kept apart by the planes on the way.
  Cast grazed() { return met(1, QuadricContact::undecided); }

  [[nodiscard]] Cast met(double late, QuadricContact how) const {
    Cast cast;
    cast.lower = free_until_;
    cast.upper = late;
    cast.point = point_;
    cast.normal = unit_or_zero(normal_);
    const bool is_narrow = late - free_until_ <= 4 * time_width;
    cast.status =
        how == QuadricContact::undecided ? Status::undecided : (is_narrow ? Status::exact : Status::not_converged);
    return cast;
  }

  const QuadricBody& a_;
  BoundedVector motion_;
  const QuadricBody& b_;
  const BoxWithin& box_;
  double free_until_ = 0;
  Vec3 normal_;
  Vec3 point_;
};

void require_motion(const Vec3& motion) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
}

/// As far as doubles go.
template <class B>
QuadricAdvance begun(const PosedQuadric& a, const Vec3& motion, const B& b, const PairFrame& frame, double limit) {
  if (!is_fast(a, b, frame)) return {};
  return advance_in_doubles(PlainBody(a, frame), frame.factor * motion, PlainBody(b, frame), limit);
}

template <class B>
std::optional<Cast> cast_until(const PosedQuadric& a, const Vec3& motion, const B& b, double limit) {
  require_motion(motion);
  const PairFrame frame = pair_frame(a, b);
  const QuadricAdvance start = begun(a, motion, b, frame, limit);
  if (start.for_ever || start.free_until > limit) return {};
  const QuadricBody body_a(a, frame), body_b(b, frame);
  std::optional<QuadricNearest> nearest;
  if (!(start.free_until > 0)) nearest = nearest_of(a, body_a, b, body_b, QuadricQuestion::distance);
  const BoxWithin box = box_within(b, frame);
  auto cast = QuadricCast(body_a, frame.scaled(motion), body_b, box).answer(start, nearest, limit);
  if (cast) cast->point = frame.back(cast->point);
  return cast;
}

/// What a ray meets.
template <class Number>
CertainAnswer<Cast> cast_of(const LineWithin<Number>& within, const Vec3& origin, const Vec3& motion) {
  const Number one = number_as<Number>(1.0);
  if (within.empty) return {true};
  Cast cast;
  cast.point = origin;
  if (within.enters.is_negative() && within.leaves.is_positive()) return {true, cast};
  if ((within.enters - one).is_positive() || within.leaves.is_negative()) return {true};
  if (!within.enters.is_positive() || !within.leaves.is_positive() || !(one - within.enters).is_positive()) return {};
  cast.lower = std::fmax(0, floor_of(within.enters));
  cast.upper = std::fmin(1, ceiling_of(within.enters));
  if (!(cast.upper - cast.lower <= 4 * time_width)) return {};
  cast.point = origin + cast.lower * motion;
  cast.normal = unit_or_zero(within.normal);
  return {true, cast};
}

CertainAnswer<Cast> by_roots_in_doubles(const Vec3& origin, const Vec3& motion, const PosedQuadric& target) {
  const Mat3& linear = target.pose().linear;
  const Vec3& half = target.half();
  const std::array<Vec3, 3> axis{half.x * linear.column(0), half.y * linear.column(1), half.z * linear.column(2)};
  const auto within = fast_line_within(target.kind(), axis, origin - target.pose().offset, motion);
  return within ? cast_of(*within, origin, motion) : CertainAnswer<Cast>{};
}

CertainAnswer<Cast> by_roots(const Vec3& origin, const Vec3& motion, const PosedQuadric& target) {
  if (const auto quickly = by_roots_in_doubles(origin, motion, target); quickly.is_certain) return quickly;
  const PairFrame frame = pair_frame(target, target);
  const QuadricBody body(target, frame);
  const auto within = line_within(RoundAndLine<BoundedNumber>{
      target.kind(), body.axes(), frame.place(origin) - body.middle_point(), frame.scaled(motion)});
  return within ? cast_of(*within, origin, motion) : CertainAnswer<Cast>{};
}

}  // namespace

std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedQuadric& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  require_motion(motion);
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  if (const auto told = by_roots(origin, motion, target); told.is_certain) return told.answer;
  return cast_shape(PosedPolytope(Point(origin)), motion, target);
}

std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b) {
  return cast_until(a, motion, b, 1);
}

std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedQuadric& b) {
  return cast_until(a, motion, b, 1);
}

std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b) {
  return seen_from_target(cast_shape(b, -motion, a), motion);
}

std::optional<Cast> cast_shape_until(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b, double limit) {
  return cast_until(a, motion, b, limit);
}

std::optional<Cast> cast_shape_until(const PosedQuadric& a, const Vec3& motion, const PosedQuadric& b, double limit) {
  return cast_until(a, motion, b, limit);
}

std::optional<Cast> cast_shape_until(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b, double limit) {
  return seen_from_target(cast_until(b, -motion, a, limit), motion);
}

double free_until(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b, double limit) {
  const QuadricAdvance found = begun(a, motion, b, pair_frame(a, b), limit);
  return found.for_ever ? after_the_way : found.free_until;
}

double free_until(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b, double limit) {
  return free_until(b, -motion, a, limit);
}

std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedHalfSpace& b) {
  require_motion(motion);
  const PairFrame frame = pair_frame(a, b);
  const QuadricBody body(a, frame);
  const Vec3 normal = scaled_normal(b);
  const BoundedVector n = exactly(normal);
  const FineDirection down = fine(-normal);
  const BoundedNumber height = -(height_of<BoundedNumber>(body, down) + dot(n, frame.place(b.point)));
  const BoundedNumber fall = -dot(n, frame.scaled(motion));
  Cast cast;
  if (overlap(a, b)) {
    cast.point = distance(a, b).on_b;
    return cast;
  }
  if (!fall.is_positive()) {
    // Certainly not falling, or so little that it stays above.
    if ((height - fall).is_positive()) return {};
  }
  const BoundedNumber time = height / fall;
  if ((time - exactly(1.0)).is_positive()) return {};
  cast.lower = std::fmax(0, floor_of(time));
  cast.upper = std::fmin(1, ceiling_of(time));
  cast.status = (exactly(1.0) - time).is_positive() ? Status::exact : Status::undecided;
  cast.normal = unit_or_zero(normal);
  cast.point = frame.back(body.support(-normal).point) + cast.lower * motion;
  return cast;
}

std::optional<Cast> cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedQuadric& b) {
  return seen_from_target(cast_shape(b, -motion, a), motion);
}

}  // namespace toccata
