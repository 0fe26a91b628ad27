#include "narrow/quadrics/contact/quadric_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/depth/quadric_cap.hpp"
#include "narrow/quadrics/distance/fast_refinement.hpp"

namespace toccata {
namespace {

/// How far apart the bodies are brought in turn, so that they have nearest points; the pair is of size 1. Points that
/// lie aside of each other turn the normal by as much as the gap is small beside that, and are told the more finely.
constexpr std::array<double, 6> gaps_between{0x1p-2, 0x1p-6, 0x1p-12, 0x1p-20, 0x1p-28, 0x1p-36};

/// The nearest points lie across from each other, but for this; and almost.
constexpr double rounding_across = 0x1p-44;
constexpr double almost_across = 0x1p-8;

/// A direction that is no worse, but for this, is another one.
constexpr double rounding_along = 0x1p-46;

/// From one gap.
constexpr int most_separating_steps = 12;
constexpr int most_refinements = 4;

/// As far as it is told along a direction that is a double's.
double depth_along(const QuadricBody& a, const QuadricBody& b, const Vec3& normal) {
  return -gap_along<BoundedNumber>(a, b, fine(-normal));
}

/// From A to B, where the direction leads from B to A.
Vec3 normal_of(const FineDirection& direction) {
  return -unit_or_zero({direction[0].high, direction[1].high, direction[2].high});
}

/// The bodies moved apart along the normal, and no farther than by the gap.
QuadricNearest nearest_when_parted(const QuadricBody& a, const QuadricBody& b, const Vec3& way) {
  return nearest_of(a.moved(exactly(-way)), b, QuadricQuestion::distance);
}

/// Finds, for bodies that hardly meet, a direction along which they overlap hardly at all: A − B has a surface at the
/// origin, and no inside from which to look for it. But A made smaller by a part ε of its size, around its middle, is
/// apart from B, and has a proved direction to the nearest point d. With heights h seen from the middle, A and B
/// overlap along d by no more than ε (h(d) − h(n)), where n is a direction along which they do not: the less the
/// smaller ε is, and the nearer d comes to n.
class TouchingPair {
 public:
  TouchingPair(const QuadricBody& a, const QuadricBody& b) : a_(a), b_(b) {}

  /// The cheap guesses come first: where one shows that they no more than touch, none is better. `proved` is the normal
  /// of a plane between them, or zero.
  QuadricSeparation least(const Vec3& proved) {
    take_axes();
    if (best_.depth > rounding_along) take(proved);
    for (const double part : parts_made_smaller) {
      if (best_.depth <= rounding_along) break;
      const QuadricNearest near = nearest_of(a_.made_smaller(part), b_, QuadricQuestion::distance);
      if (near.contact == QuadricContact::apart) take(normal_of(near.direction));
    }
    return best_;
  }

 private:
  static constexpr std::array<double, 5> parts_made_smaller{0x1p-4, 0x1p-10, 0x1p-18, 0x1p-26, 0x1p-34};

  /// Those of the quadrics, and against them.
  void take_axes() {
    for (const QuadricBody* body : {&a_, &b_})
      if (body->quadric_kind())
        for (const BoundedVector& axis : body->axes())
          for (const double sign : {1.0, -1.0}) take(unit_or_zero(sign * plain(axis)));
  }

  void take(const Vec3& d) {
    if (d == Vec3{}) return;
    const double depth = depth_along(a_, b_, d);
    if (depth < best_.depth) best_ = {d, depth, a_.support(d).point, b_.support(-d).point};
  }

  const QuadricBody& a_;
  const QuadricBody& b_;
  QuadricSeparation best_{{}, HUGE_VAL, {}, {}};
};

QuadricSeparation first_separation(const QuadricBody& a, const QuadricBody& b, const QuadricNearest& met) {
  // It is open whether a point that exact signs found in both is an inner one.
  if (met.contact != QuadricContact::contact || met.shared)
    return TouchingPair(a, b).least(met.shared ? met.shared->normal : Vec3{});
  const Penetration least = least_depth(a, b);
  return {least.direction, least.upper, least.on_a, least.on_b};
}

/// Across the normal.
double aside(const Vec3& v, const Vec3& normal) { return plain_length(v - dot(v, normal) * normal); }

/// By Newton's method on the height of A − B, from farthest points that lie almost across from each other: of round
/// places, which have no others as far. False where it does not find the very points.
bool is_refined(QuadricSeparation& separation, const QuadricBody& a, const QuadricBody& b) {
  if (!(aside(separation.on_a - separation.on_b, separation.normal) <= almost_across)) return false;
  std::optional<Vec3> axis = separation.normal;
  for (int step = 0; axis && step < most_refinements; ++step) {
    const QuadricCap cap(a, b, HighestPoint(a, b, *axis));
    if (aside(cap.point(), cap.axis()) <= rounding_across) {
      const double depth = depth_along(a, b, cap.axis());
      if (!(depth < separation.depth + rounding_along)) return false;
      separation = {cap.axis(), depth, cap.on_a().point, cap.on_b().point};
      return true;
    }
    axis = cap.lower_axis();
  }
  return false;
}

/// The point of a side as Newton's method in doubles ends with it.
Vec3 point_of_side(const PlainBody& body, const FastSide& side) {
  Vec3 point = side.grown_weight() * body.map(side.round);
  for (std::size_t i = 0; i < side.size; ++i) point = point + side.weight[i] * body.plain_centre(side.generator[i]);
  return point;
}

/// Where the bodies are brought apart along the normal, doubles mostly show that the nearest points lie across from
/// each other, as they do of the least depth: so the normal stays. False where they do not.
bool has_points_across(QuadricSeparation& separation, const QuadricBody& a, const QuadricBody& b) {
  constexpr double gap = gaps_between[0];
  const Vec3 apart = gap * separation.normal, way = separation.depth * separation.normal + apart;
  const PlainBody moved = a.PlainBody::moved(-way);
  QuadricSearch search(moved, b, -separation.normal);
  FastRefinement refinement(moved, b);
  for (const double part : {0.1, 1e-3}) {
    search.run(part);
    if (search.inside()) return false;
    refinement.begin(search.simplex(), search.nearest());
    if (!refinement.run()) continue;
    const Vec3 x = point_of_side(moved, refinement.on_a()), y = point_of_side(b, refinement.on_b());
    if (!(plain_length(y - x - apart) <= rounding_across)) return false;
    separation.on_a = x + way;
    separation.on_b = y;
    return true;
  }
  return false;
}

/// How far the points under the normal are aside of each other, after which it is turned to the nearest ones; nothing
/// where that is no better.
std::optional<double> take_step(QuadricSeparation& separation, const QuadricBody& a, const QuadricBody& b, double gap) {
  const Vec3 way = (separation.depth + gap) * separation.normal;
  const QuadricNearest near = nearest_when_parted(a, b, way);
  if (near.contact != QuadricContact::apart) return {};
  separation.on_a = near.on_a + way;
  separation.on_b = near.on_b;
  const double off = aside(near.on_b - near.on_a, separation.normal);
  if (off <= rounding_across) return off;
  const Vec3 normal = normal_of(near.direction);
  const double depth = depth_along(a, b, normal);
  if (!(depth < separation.depth + rounding_along)) return {};
  separation.normal = normal;
  separation.depth = depth;
  return off;
}

}  // namespace

std::optional<QuadricSeparation> separation_at_lowest_place(const QuadricBody& a, const QuadricBody& b) {
  const std::optional<Penetration> least = depth_of_lowest_place(a, b);
  if (!least || !(aside(least->on_b - least->on_a, least->direction) <= rounding_across)) return {};
  return QuadricSeparation{least->direction, depth_along(a, b, least->direction), least->on_a, least->on_b};
}

// All of A − B, moved so that it lies a gap before the origin, is no nearer to it than its nearest point w: along the
// direction of w they are parted no later. So each step shortens the way, until w lies along the normal.
QuadricSeparation separation_of(const QuadricBody& a, const QuadricBody& b, const QuadricNearest& met) {
  QuadricSeparation separation = first_separation(a, b, met);
  if (is_refined(separation, a, b) || has_points_across(separation, a, b)) return separation;
  for (const double gap : gaps_between) {
    double last = HUGE_VAL;
    for (int step = 0; step < most_separating_steps; ++step) {
      const std::optional<double> off = take_step(separation, a, b, gap);
      if (off && *off <= rounding_across) return separation;
      // What hardly turns from here turns more from nearer.
      if (!off || !(*off < 0.5 * last)) break;
      last = *off;
    }
  }
  return separation;
}

}  // namespace toccata
