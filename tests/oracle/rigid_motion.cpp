#include "oracle/rigid_motion.hpp"

#include <algorithm>
#include <vector>

namespace toccata::oracle {
namespace {

const Fine two_pi("6.28318530717958647692528676655900576839433879875021164194988918461563281257");

FinePoint plus(const FinePoint& a, const FinePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FinePoint minus(const FinePoint& a, const FinePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FinePoint times(const Fine& s, const FinePoint& a) { return {s * a.x, s * a.y, s * a.z}; }
Fine product(const FinePoint& a, const FinePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FinePoint crossed(const FinePoint& a, const FinePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Fine size(const FinePoint& a) { return sqrt(product(a, a)); }
FinePoint fine(const Vec3& v) { return {Fine(v.x), Fine(v.y), Fine(v.z)}; }

/// Sums of Taylor, for at most half a turn.
struct SineAndCosine {
  Fine sine = 0;
  Fine cosine = 0;
};
SineAndCosine sine_and_cosine(const Fine& angle) {
  SineAndCosine result;
  Fine term = 1;
  for (int i = 0; i < 80; ++i) {
    Fine& sum = i % 2 == 0 ? result.cosine : result.sine;
    if (i % 4 < 2)
      sum += term;
    else
      sum -= term;
    term = term * angle / Fine(i + 1);
  }
  return result;
}

/// A turn about an axis through the origin.
class FineTurn {
 public:
  FineTurn(const RigidMove& move, const Fine& time) {
    Fine turns = Fine(move.turns) * time;
    turns -= floor(turns + Fine(0.5));
    values_ = sine_and_cosine(two_pi * turns);
    if (move.turns != 0) axis_ = times(Fine(1) / size(fine(move.axis)), fine(move.axis));
  }

  FinePoint operator()(const FinePoint& v) const {
    const FinePoint along = times(product(axis_, v), axis_), across = minus(v, along);
    return plus(along, plus(times(values_.cosine, across), times(values_.sine, crossed(axis_, v))));
  }

 private:
  SineAndCosine values_;
  FinePoint axis_{Fine(0), Fine(0), Fine(1)};
};

/// How fast a point of the body is at most; of a half-space, how fast its surface is near points that come within
/// `far` of its point.
Fine speed_of(const FineBody& body, const Fine& far) {
  Fine reach = 0;
  const FinePoint centre = fine(body.move.centre);
  const auto see = [&](const FinePoint& p, const Fine& around) {
    const Fine distance = size(minus(p, centre)) + around;
    if (distance > reach) reach = distance;
  };
  if (const auto* half_space = std::get_if<FineHalfSpace>(&body.set)) {
    see(half_space->point, far);
  } else {
    const FineSet& set = std::get<FineSet>(body.set);
    for (const FinePoint& v : set.vertices) see(v, set.radius);
    if (set.kind != FineKind::hull) see(set.centre, size(set.axis[0]) + size(set.axis[1]) + size(set.axis[2]));
  }
  return size(fine(body.move.translation)) + two_pi * abs(Fine(body.move.turns)) * reach;
}

/// No point of either is ever farther from a point of the other.
Fine farthest_apart(const FineBody& a, const FineBody& b) {
  const auto far = [](const FineBody& body) {
    return size(fine(body.move.centre)) + speed_of({body.set, {body.move.centre, {0, 0, 1}, 1, {}}}, Fine(0)) / two_pi +
           size(fine(body.move.translation));
  };
  return far(a) + far(b);
}

FineNearness height_over(const FineSet& set, const FineHalfSpace& half_space) {
  const FinePoint up = times(Fine(1) / size(half_space.normal), half_space.normal);
  const FinePoint low = farthest(set, times(Fine(-1), up));
  const Fine height = product(minus(low, half_space.point), up);
  FineNearness found;
  found.meet = height <= 0;
  found.depth = found.meet ? Fine(-height) : Fine(0);
  found.lower = found.upper = found.meet ? Fine(0) : height;
  return found;
}

/// One question, in the order of time.
class Subdivision {
 public:
  Subdivision(const FineBody& a, const FineBody& b, double narrowest)
      : a_(a),
        b_(b),
        narrowest_(narrowest),
        speed_(speed_of(a, farthest_apart(a, b)) + speed_of(b, farthest_apart(a, b))) {}

  FineContact answer() {
    if (nearness_at(a_, b_, Fine(0)).meet) return {FineContact::Kind::hit, Fine(0), Fine(0)};
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
    const FineNearness near = nearness_at(a_, b_, middle);
    if (!near.meet && near.lower > speed_ * half) return {};
    if (2 * half > narrowest_) {
      waiting_.push_back({middle, interval.end});
      waiting_.push_back({interval.begin, middle});
      return {};
    }
    if (!first_doubt_) first_doubt_ = interval.begin;
    if (near.meet) return middle;
    if (nearness_at(a_, b_, interval.end).meet) return interval.end;
    return {};
  }

  const FineBody& a_;
  const FineBody& b_;
  Fine narrowest_;
  Fine speed_;
  std::vector<Interval> waiting_;
  std::optional<Fine> first_doubt_;
};

}  // namespace

FineBody moved(const FineBody& body, const Fine& time) {
  const FineTurn turn(body.move, time);
  const FinePoint centre = fine(body.move.centre), shift = times(time, fine(body.move.translation));
  const auto place = [&](const FinePoint& p) { return plus(plus(centre, turn(minus(p, centre))), shift); };
  if (const auto* half_space = std::get_if<FineHalfSpace>(&body.set))
    return {FineHalfSpace{place(half_space->point), turn(half_space->normal)}, body.move};
  FineSet set = std::get<FineSet>(body.set);
  for (FinePoint& v : set.vertices) v = place(v);
  for (FinePoint& axis : set.axis) axis = turn(axis);
  set.centre = place(set.centre);
  return {set, body.move};
}

FineNearness nearness_at(const FineBody& a, const FineBody& b, const Fine& time) {
  const FineBody now_a = moved(a, time), now_b = moved(b, time);
  if (const auto* half_space = std::get_if<FineHalfSpace>(&now_a.set))
    return height_over(std::get<FineSet>(now_b.set), *half_space);
  if (const auto* half_space = std::get_if<FineHalfSpace>(&now_b.set))
    return height_over(std::get<FineSet>(now_a.set), *half_space);
  FineNearness found = fine_nearness(std::get<FineSet>(now_a.set), std::get<FineSet>(now_b.set), 1e-3, 200);
  // Where the origin lies in a face of a simplex of the difference, it is at no distance, and within none.
  if (found.upper < Fine("1e-40")) found.meet = true;
  return found;
}

FineContact first_contact(const FineBody& a, const FineBody& b, double narrowest) {
  return Subdivision(a, b, narrowest).answer();
}

}  // namespace toccata::oracle
