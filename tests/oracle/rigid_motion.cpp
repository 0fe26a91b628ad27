#include "oracle/rigid_motion.hpp"

#include <cmath>
#include <vector>

#include "oracle/quick_motion.hpp"

namespace toccata::oracle {
namespace {

using std::abs, std::floor, std::sqrt;

/// The angle whose tangent is 1/n, by its series.
Fine arc_tangent_of_part(int n) {
  Fine sum = 0, power = Fine(1) / n;
  for (int i = 0; i < 120; ++i) {
    sum += (i % 2 == 0 ? power : Fine(-power)) / (2 * i + 1);
    power /= n * n;
  }
  return sum;
}

/// J. Machin, 1706.
const Fine& two_pi() {
  static const Fine value = 32 * arc_tangent_of_part(5) - 8 * arc_tangent_of_part(239);
  return value;
}

FinePoint plus(const FinePoint& a, const FinePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FinePoint minus(const FinePoint& a, const FinePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FinePoint times(const Fine& s, const FinePoint& a) { return {s * a.x, s * a.y, s * a.z}; }
Fine product(const FinePoint& a, const FinePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FinePoint crossed(const FinePoint& a, const FinePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Fine size(const FinePoint& a) { return sqrt(product(a, a)); }
FinePoint point_of(const Vec3& v) { return {Fine(v.x), Fine(v.y), Fine(v.z)}; }

/// Sums of Taylor, for at most half a turn.
struct SineAndCosine {
  Fine sine = 0;
  Fine cosine = 0;
};
SineAndCosine sine_and_cosine(const Fine& angle) {
  SineAndCosine result;
  Fine term = 1;
  for (int i = 0; i < 80 && abs(term) > Fine(1e-70L); ++i) {
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
class RigidTurn {
 public:
  RigidTurn(const RigidMove& move, const Fine& time) {
    Fine turns = Fine(move.turns) * time;
    turns -= floor(turns + Fine(0.5));
    values_ = sine_and_cosine(two_pi() * turns);
    if (move.turns != 0) axis_ = times(Fine(1) / size(point_of(move.axis)), point_of(move.axis));
  }

  FinePoint operator()(const FinePoint& v) const {
    const FinePoint along = times(product(axis_, v), axis_), across = minus(v, along);
    return plus(along, plus(times(values_.cosine, across), times(values_.sine, crossed(axis_, v))));
  }

 private:
  SineAndCosine values_;
  FinePoint axis_{Fine(0), Fine(0), Fine(1)};
};

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

FineBody placed_at(const FineBody& body, const Fine& time) {
  const RigidTurn turn(body.move, time);
  const FinePoint centre = point_of(body.move.centre), shift = times(time, point_of(body.move.translation));
  const auto place = [&](const FinePoint& p) { return plus(plus(centre, turn(minus(p, centre))), shift); };
  if (const auto* half_space = std::get_if<FineHalfSpace>(&body.set))
    return {FineHalfSpace{place(half_space->point), turn(half_space->normal)}, body.move};
  FineSet set = std::get<FineSet>(body.set);
  for (FinePoint& v : set.vertices) v = place(v);
  for (FinePoint& axis : set.axis) axis = turn(axis);
  set.centre = place(set.centre);
  return {set, body.move};
}

FineNearness near_at(const FineBody& a, const FineBody& b, const Fine& time) {
  const FineBody now_a = placed_at(a, time), now_b = placed_at(b, time);
  if (const auto* half_space = std::get_if<FineHalfSpace>(&now_a.set))
    return height_over(std::get<FineSet>(now_b.set), *half_space);
  if (const auto* half_space = std::get_if<FineHalfSpace>(&now_b.set))
    return height_over(std::get<FineSet>(now_a.set), *half_space);
  FineNearness found = fine_nearness(std::get<FineSet>(now_a.set), std::get<FineSet>(now_b.set), 1e-3, 200);
  // Where the origin lies in a face of a simplex of the difference, it is at no distance, and within none.
  if (found.upper < Fine(1e-40L)) found.meet = true;
  return found;
}

/// One question, in the order of time.
class Subdivision {
 public:
  Subdivision(const FineBody& a, const FineBody& b, double narrowest)
      : a_(a), b_(b), narrowest_(narrowest), quick_(a, b) {}

  FineContact answer() {
    if (meets(0)) return {FineContact::Kind::hit, Fine(0), Fine(0)};
    waiting_.push_back({0, 1});
    // More than anything but a long graze needs.
    for (int step = 0; step < 4000 && !waiting_.empty(); ++step) {
      const Interval next = waiting_.back();
      waiting_.pop_back();
      if (const auto met = look_at(next))
        return {FineContact::Kind::hit, Fine(first_doubt_.value_or(next.begin)), Fine(*met)};
    }
    if (!waiting_.empty() && !first_doubt_) first_doubt_ = waiting_.back().begin;
    if (first_doubt_) return {FineContact::Kind::undecided, Fine(*first_doubt_), Fine(1)};
    return {};
  }

 private:
  /// Halves of halves of [0, 1], which doubles hold.
  struct Interval {
    double begin;
    double end;
  };

  /// The time at which they are seen to meet, once intervals are narrow.
  std::optional<double> look_at(const Interval& interval) {
    const double half = (interval.end - interval.begin) / 2, middle = interval.begin + half;
    if (quick_.apart_around(middle, half)) return {};
    if (2 * half > narrowest_) {
      waiting_.push_back({middle, interval.end});
      waiting_.push_back({interval.begin, middle});
      return {};
    }
    if (quick_.at(middle) == QuickLook::Sight::unclear) {
      const FineNearness near = near_at(a_, b_, Fine(middle));
      // The speed is rounded.
      if (!near.meet && near.lower > Fine(static_cast<double>(quick_.speed())) * (half * (1 + 0x1p-40))) return {};
    }
    if (!first_doubt_) first_doubt_ = interval.begin;
    if (meets(middle)) return middle;
    if (meets(interval.end)) return interval.end;
    return {};
  }

  bool meets(double time) {
    const QuickLook::Sight sight = quick_.at(time);
    return sight == QuickLook::Sight::unclear ? near_at(a_, b_, Fine(time)).meet : sight == QuickLook::Sight::meet;
  }

  const FineBody& a_;
  const FineBody& b_;
  double narrowest_;
  QuickLook quick_;
  std::vector<Interval> waiting_;
  std::optional<double> first_doubt_;
};

}  // namespace

FineBody moved(const FineBody& body, const Fine& time) { return placed_at(body, time); }

FineNearness nearness_at(const FineBody& a, const FineBody& b, const Fine& time) { return near_at(a, b, time); }

bool meet_at(const FineBody& a, const FineBody& b, double time) {
  const QuickLook::Sight sight = QuickLook(a, b).at(time);
  return sight == QuickLook::Sight::unclear ? near_at(a, b, Fine(time)).meet : sight == QuickLook::Sight::meet;
}

FineContact first_contact(const FineBody& a, const FineBody& b, double narrowest) {
  return Subdivision(a, b, narrowest).answer();
}

}  // namespace toccata::oracle
