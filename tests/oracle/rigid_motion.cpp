#include "oracle/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <boost/math/constants/constants.hpp>

namespace toccata::oracle {
namespace {

using std::abs, std::floor, std::sqrt;

template <class N>
const N two_pi(2 * boost::math::constants::pi<N>());

template <class N>
PointOf<N> plus(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
PointOf<N> minus(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
PointOf<N> times(const N& s, const PointOf<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
N product(const PointOf<N>& a, const PointOf<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
PointOf<N> crossed(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N size(const PointOf<N>& a) {
  return sqrt(product(a, a));
}
template <class N>
PointOf<N> point_of(const Vec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}

/// Sums of Taylor, for at most half a turn.
template <class N>
struct SineAndCosine {
  N sine = 0;
  N cosine = 0;
};
template <class N>
SineAndCosine<N> sine_and_cosine(const N& angle) {
  SineAndCosine<N> result;
  N term = 1;
  for (int i = 0; i < 80; ++i) {
    N& sum = i % 2 == 0 ? result.cosine : result.sine;
    if (i % 4 < 2)
      sum += term;
    else
      sum -= term;
    term = term * angle / N(i + 1);
  }
  return result;
}

/// A turn about an axis through the origin.
template <class N>
class RigidTurn {
 public:
  RigidTurn(const RigidMove& move, const N& time) {
    N turns = N(move.turns) * time;
    turns -= floor(turns + N(0.5));
    values_ = sine_and_cosine(two_pi<N> * turns);
    if (move.turns != 0) axis_ = times(N(1) / size(point_of<N>(move.axis)), point_of<N>(move.axis));
  }

  PointOf<N> operator()(const PointOf<N>& v) const {
    const PointOf<N> along = times(product(axis_, v), axis_), across = minus(v, along);
    return plus(along, plus(times(values_.cosine, across), times(values_.sine, crossed(axis_, v))));
  }

 private:
  SineAndCosine<N> values_;
  PointOf<N> axis_{N(0), N(0), N(1)};
};

/// How fast a point of the body is at most; of a half-space, how fast its surface is near points that come within
/// `far` of its point.
template <class N>
N speed_of(const BodyOf<N>& body, const N& far) {
  N reach = 0;
  const PointOf<N> centre = point_of<N>(body.move.centre);
  const auto see = [&](const PointOf<N>& p, const N& around) {
    const N distance = size(minus(p, centre)) + around;
    if (distance > reach) reach = distance;
  };
  if (const auto* half_space = std::get_if<HalfSpaceOf<N>>(&body.set)) {
    see(half_space->point, far);
  } else {
    const SetOf<N>& set = std::get<SetOf<N>>(body.set);
    for (const PointOf<N>& v : set.vertices) see(v, set.radius);
    if (set.kind != FineKind::hull) see(set.centre, size(set.axis[0]) + size(set.axis[1]) + size(set.axis[2]));
  }
  return size(point_of<N>(body.move.translation)) + two_pi<N> * abs(N(body.move.turns)) * reach;
}

/// No point of either is ever farther from a point of the other.
template <class N>
N farthest_apart(const BodyOf<N>& a, const BodyOf<N>& b) {
  const auto far = [](const BodyOf<N>& body) {
    return size(point_of<N>(body.move.centre)) +
           speed_of({body.set, {body.move.centre, {0, 0, 1}, 1, {}}}, N(0)) / two_pi<N> +
           size(point_of<N>(body.move.translation));
  };
  return far(a) + far(b);
}

template <class N>
NearnessOf<N> height_over(const SetOf<N>& set, const HalfSpaceOf<N>& half_space) {
  const PointOf<N> up = times(N(1) / size(half_space.normal), half_space.normal);
  const PointOf<N> low = farthest(set, times(N(-1), up));
  const N height = product(minus(low, half_space.point), up);
  NearnessOf<N> found;
  found.meet = height <= 0;
  found.depth = found.meet ? N(-height) : N(0);
  found.lower = found.upper = found.meet ? N(0) : height;
  return found;
}

template <class N>
BodyOf<N> placed_at(const BodyOf<N>& body, const N& time) {
  const RigidTurn turn(body.move, time);
  const PointOf<N> centre = point_of<N>(body.move.centre), shift = times(time, point_of<N>(body.move.translation));
  const auto place = [&](const PointOf<N>& p) { return plus(plus(centre, turn(minus(p, centre))), shift); };
  if (const auto* half_space = std::get_if<HalfSpaceOf<N>>(&body.set))
    return {HalfSpaceOf<N>{place(half_space->point), turn(half_space->normal)}, body.move};
  SetOf<N> set = std::get<SetOf<N>>(body.set);
  for (PointOf<N>& v : set.vertices) v = place(v);
  for (PointOf<N>& axis : set.axis) axis = turn(axis);
  set.centre = place(set.centre);
  return {set, body.move};
}

template <class N>
NearnessOf<N> near_at(const BodyOf<N>& a, const BodyOf<N>& b, const N& time) {
  const BodyOf<N> now_a = placed_at(a, time), now_b = placed_at(b, time);
  if (const auto* half_space = std::get_if<HalfSpaceOf<N>>(&now_a.set))
    return height_over(std::get<SetOf<N>>(now_b.set), *half_space);
  if (const auto* half_space = std::get_if<HalfSpaceOf<N>>(&now_b.set))
    return height_over(std::get<SetOf<N>>(now_a.set), *half_space);
  NearnessOf<N> found = fine_nearness(std::get<SetOf<N>>(now_a.set), std::get<SetOf<N>>(now_b.set), 1e-3, 200);
  // Where the origin lies in a face of a simplex of the difference, it is at no distance, and within none.
  if (found.upper < N(1e-40L)) found.meet = true;
  return found;
}

/// The same body in numbers of the processor.
BodyOf<long double> quick(const FineBody& body) {
  using Q = long double;
  const auto quick_number = [](const Fine& x) { return x.convert_to<Q>(); };
  const auto quick_point = [&](const FinePoint& p) {
    return PointOf<Q>{quick_number(p.x), quick_number(p.y), quick_number(p.z)};
  };
  if (const auto* half_space = std::get_if<FineHalfSpace>(&body.set))
    return {HalfSpaceOf<Q>{quick_point(half_space->point), quick_point(half_space->normal)}, body.move};
  const FineSet& set = std::get<FineSet>(body.set);
  SetOf<Q> result;
  result.kind = set.kind;
  result.centre = quick_point(set.centre);
  result.radius = quick_number(set.radius);
  for (std::size_t i = 0; i < 3; ++i) result.axis[i] = quick_point(set.axis[i]);
  for (const FinePoint& v : set.vertices) result.vertices.push_back(quick_point(v));
  return {result, body.move};
}

// What follows counts on more digits than those of doubles.
static_assert(std::numeric_limits<long double>::digits >= 64);

/// Says of two bodies that they are apart around a time where more than rounding speaks for it.
class QuickLook {
 public:
  QuickLook(const FineBody& a, const FineBody& b, const Fine& speed)
      : a_(quick(a)), b_(quick(b)), speed_(speed.convert_to<long double>()) {
    // The height over a plane of support is a sum of products of numbers that are no larger than what is farthest
    // apart, and a few hundred operations make each: 2¹⁴ times the rounding of one is far above that.
    slack_ = 0x1p-50L * (farthest_apart(a_, b_) + speed_);
  }

  bool sees_apart(const Fine& middle, const Fine& half) const {
    const auto near = near_at(a_, b_, middle.convert_to<long double>());
    return !near.meet && near.lower > speed_ * half.convert_to<long double>() + slack_;
  }

 private:
  BodyOf<long double> a_, b_;
  long double speed_;
  long double slack_;
};

/// One question, in the order of time.
class Subdivision {
 public:
  Subdivision(const FineBody& a, const FineBody& b, double narrowest)
      : a_(a),
        b_(b),
        narrowest_(narrowest),
        speed_(speed_of(a, farthest_apart(a, b)) + speed_of(b, farthest_apart(a, b))),
        quick_(a, b, speed_) {}

  FineContact answer() {
    if (near_at(a_, b_, Fine(0)).meet) return {FineContact::Kind::hit, Fine(0), Fine(0)};
    waiting_.push_back({Fine(0), Fine(1)});
    // More than anything but a long graze needs.
    for (int step = 0; step < 4000 && !waiting_.empty(); ++step) {
      const Interval next = waiting_.back();
      waiting_.pop_back();
      if (const auto met = look_at(next)) return {FineContact::Kind::hit, first_doubt_.value_or(next.begin), *met};
    }
    if (!waiting_.empty() && !first_doubt_) first_doubt_ = waiting_.back().begin;
    if (first_doubt_) return {FineContact::Kind::undecided, *first_doubt_, Fine(1)};
    return {};
  }

 private:
  struct Interval {
    Fine begin;
    Fine end;
  };

  /// The time at which they are seen to meet, once intervals are narrow.
  std::optional<Fine> look_at(const Interval& interval) {
    const Fine half = (interval.end - interval.begin) / 2, middle = interval.begin + half;
    if (quick_.sees_apart(middle, half)) return {};
    if (2 * half > narrowest_) {
      waiting_.push_back({middle, interval.end});
      waiting_.push_back({interval.begin, middle});
      return {};
    }
    const FineNearness near = near_at(a_, b_, middle);
    if (!near.meet && near.lower > speed_ * half) return {};
    if (!first_doubt_) first_doubt_ = interval.begin;
    if (near.meet) return middle;
    if (near_at(a_, b_, interval.end).meet) return interval.end;
    return {};
  }

  const FineBody& a_;
  const FineBody& b_;
  Fine narrowest_;
  Fine speed_;
  QuickLook quick_;
  std::vector<Interval> waiting_;
  std::optional<Fine> first_doubt_;
};

}  // namespace

FineBody moved(const FineBody& body, const Fine& time) { return placed_at(body, time); }

FineNearness nearness_at(const FineBody& a, const FineBody& b, const Fine& time) { return near_at(a, b, time); }

FineContact first_contact(const FineBody& a, const FineBody& b, double narrowest) {
  return Subdivision(a, b, narrowest).answer();
}

}  // namespace toccata::oracle
