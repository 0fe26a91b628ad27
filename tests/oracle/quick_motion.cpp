#include "oracle/quick_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

namespace toccata::oracle {
namespace {

using Number = long double;
using Point = PointOf<Number>;

// What is called rounding below counts on more digits than those of doubles.
static_assert(std::numeric_limits<Number>::digits >= 64);

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(Number s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
Number dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Number length(const Point& a) { return std::sqrt(dot(a, a)); }

/// Off by 2⁻¹⁰⁵ of it.
Number quick_number(const Fine& x) {
  const auto high = x.convert_to<double>();
  return Number(high) + Number(Fine(x - high).convert_to<double>());
}
Point quick_point(const FinePoint& p) { return {quick_number(p.x), quick_number(p.y), quick_number(p.z)}; }
Point quick_point(const Vec3& v) { return {v.x, v.y, v.z}; }
FinePoint from_origin(const FinePoint& p, const Vec3& origin) {
  return {p.x - Fine(origin.x), p.y - Fine(origin.y), p.z - Fine(origin.z)};
}

struct Turn {
  Point axis;
  Number sine;
  Number cosine;
  Point operator()(const Point& v) const {
    const Point along = dot(axis, v) * axis;
    return along + cosine * (v - along) + sine * cross(axis, v);
  }
};

/// Whether the origin lies in the tetrahedron, farther than `slack` from its faces: then also in one whose corners are
/// elsewhere by that much. It does where it makes tetrahedra of the same orientation with all four faces.
bool surely_holds_origin(const SimplexOf<Number>& s, Number slack) {
  if (s.size() != 4) return false;
  int side = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point &p = s[(i + 1) % 4], &q = s[(i + 2) % 4], &r = s[(i + 3) % 4];
    const Point u = q - p, v = r - p, normal = cross(u, v);
    const Number volume = dot(normal, p), size = length(normal);
    if (!(std::abs(volume) > slack * size + 0x1p-59L * length(u) * length(v) * length(p))) return false;
    // These three corners turn the other way in every second face.
    const int seen = (volume > 0) == (i % 2 == 0) ? 1 : -1;
    if (side != 0 && seen != side) return false;
    side = seen;
  }
  return true;
}

}  // namespace

QuickLook::Body::Body(const FineBody& body, const Vec3& origin)
    : way(quick_point(body.move.translation)),
      rate(2 * boost::math::constants::pi<Number>() * Number(body.move.turns)) {
  const Vec3& middle = body.move.centre;
  centre = quick_point(middle) - quick_point(origin);
  if (body.move.turns != 0) axis = (1 / length(quick_point(body.move.axis))) * quick_point(body.move.axis);
  if (const auto* half_space = std::get_if<FineHalfSpace>(&body.set)) {
    start.vertices = {quick_point(from_origin(half_space->point, middle))};
    normal = quick_point(half_space->normal);
    normal = (1 / length(*normal)) * *normal;
  } else {
    const FineSet& set = std::get<FineSet>(body.set);
    start.kind = set.kind;
    start.radius = quick_number(set.radius);
    for (const FinePoint& v : set.vertices) start.vertices.push_back(quick_point(from_origin(v, middle)));
    if (set.kind != FineKind::hull) {
      start.centre = quick_point(from_origin(set.centre, middle));
      for (std::size_t i = 0; i < 3; ++i) start.axis[i] = quick_point(set.axis[i]);
      reach = length(start.centre) + length(start.axis[0]) + length(start.axis[1]) + length(start.axis[2]);
    }
  }
  for (const Point& v : start.vertices) reach = std::max(reach, length(v));
  now = start;
}

void QuickLook::Body::place(Number time, const Point& from) {
  const Turn turn{axis, std::sin(rate * time), std::cos(rate * time)};
  centre_now = (centre - from) + time * way;
  for (std::size_t i = 0; i < start.vertices.size(); ++i) now.vertices[i] = centre_now + turn(start.vertices[i]);
  for (std::size_t i = 0; i < 3; ++i) now.axis[i] = turn(start.axis[i]);
  now.centre = centre_now + turn(start.centre);
  if (normal) up = turn(*normal);
}

// The slack. A height is a sum of products of numbers that are no larger than what is farthest apart, or than the way
// that a turn makes; fewer than a hundred operations make each, and sines are as near as their angles: 2¹⁰ times the
// rounding of one operation is above that.
QuickLook::QuickLook(const FineBody& a, const FineBody& b) : a_(a, b.move.centre), b_(b, b.move.centre) {
  const Number straight = length(a_.way - b_.way);
  const Number turn_a = std::abs(a_.rate), turn_b = std::abs(b_.rate);
  far_ = length(a_.centre) + straight + a_.reach + b_.reach + a_.start.radius + b_.start.radius;
  speed_ = straight + turn_a * a_.reach + turn_b * b_.reach;
  bend_ = turn_a * turn_a * a_.reach + turn_b * turn_b * b_.reach;
  slack_ = 0x1p-54L * (far_ + length(a_.way) + length(b_.way) + speed_);
  if (a_.normal) speed_ += turn_a * far_;
  if (b_.normal) speed_ += turn_b * far_;
}

QuickLook::Separation QuickLook::separation_at(Number time) {
  // Seen from the centre of B, so that what both share of their way does not cost digits.
  a_.place(time, time * b_.way);
  b_.place(time, time * b_.way);
  Separation separation;
  if (a_.normal || b_.normal) {
    separation.direction = a_.normal ? Number(-1) * a_.up : b_.up;
    const Point low = farthest(a_.now, Number(-1) * separation.direction),
                high = farthest(b_.now, separation.direction);
    separation.gap = dot(separation.direction, a_.normal ? a_.now.vertices[0] - high : low - b_.now.vertices[0]);
    separation.meet = separation.gap < -slack_;
    return separation;
  }
  const auto near = fine_nearness(a_.now, b_.now, 1e-6, 100, last_direction_);
  separation.meet = near.meet && surely_holds_origin(near.around, slack_);
  if (near.meet || !(near.lower > 0)) return separation;
  separation.direction = (1 / length(near.direction)) * near.direction;
  separation.gap = near.lower;
  return separation;
}

QuickLook::Sight QuickLook::at(double time) {
  const Separation separation = separation_at(time);
  if (separation.meet) return Sight::meet;
  return separation.gap > slack_ ? Sight::apart : Sight::unclear;
}

// Two points x of A and y of B keep apart along a direction n that turns with some angular velocity w: with r = x − y
// the height n · r has the rate n′ · r + n · r′, where n′ = w × n, and its second derivative n″ · r + 2 n′ · r′ + n ·
// r″ is at most |w|² far + 2 |w| speed + bend. Without the latter the height of two points goes evenly, and the least
// of all heights within some time of the middle is that of one of the ends. The rate of x is way + rate × (x − centre),
// and n · (rate × (x − centre)) = (n × rate) · (x − centre), so the least height is a support of A and one of B.
QuickLook::Number QuickLook::least_at(const Separation& separation, const Point& turning, Number later) const {
  const Point& n = separation.direction;
  const Point of_a = cross(n, a_.rate * a_.axis), of_b = cross(n, b_.rate * b_.axis), of_n = cross(n, turning);
  const Point to_a = n + later * (of_a - of_n), to_b = n + later * (of_b - of_n);
  // A radius is taken along directions that are longer than n: rather too much of it.
  const Number low = dot(to_a, farthest(a_.now, Number(-1) * to_a)), high = dot(to_b, farthest(b_.now, to_b));
  const Number even = dot(n, a_.way - b_.way) - dot(of_a, a_.centre_now) + dot(of_b, b_.centre_now);
  return (low - high) + later * even;
}

bool QuickLook::stays_apart(const Separation& separation, const Point& turning, Number half) const {
  const Number w = length(turning), bending = w * w * far_ + 2 * w * speed_ + bend_;
  const Number turns = w + std::abs(a_.rate) + std::abs(b_.rate);
  const Number lost = half * half / 2 * bending * (1 + 0x1p-50L) + slack_ * (1 + half * turns);
  return separation.gap > lost && least_at(separation, turning, -half) > lost &&
         least_at(separation, turning, half) > lost;
}

bool QuickLook::apart_around(double middle, double half) {
  const Separation separation = separation_at(middle);
  if (!(separation.gap > slack_)) return false;
  const Point& n = separation.direction;
  // As the direction was seen to turn between two looks, of which the last was beside this one.
  const Number since = Number(middle) - last_time_;
  const Point seen = last_time_ < 0 || since == 0 ? Point{} : (1 / since) * cross(last_direction_, n);
  last_time_ = middle;
  last_direction_ = n;
  if (separation.gap > speed_ * Number(half) + slack_) return true;
  const Point with_a = a_.rate * a_.axis, with_b = b_.rate * b_.axis;
  if (a_.normal) return stays_apart(separation, with_a, half);
  if (b_.normal) return stays_apart(separation, with_b, half);
  return stays_apart(separation, seen, half) || stays_apart(separation, {}, half) ||
         stays_apart(separation, with_a, half) || stays_apart(separation, with_b, half);
}

}  // namespace toccata::oracle
