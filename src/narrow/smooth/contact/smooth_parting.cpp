#include "narrow/smooth/contact/smooth_parting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/smooth/depth/smooth_cap.hpp"
#include "narrow/smooth/distance/quick_polish.hpp"

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
constexpr int most_parting_steps = 12;
constexpr int most_polishing = 4;

/// As far as it is told along a direction that is a double's.
double depth_along(const SmoothBody& a, const SmoothBody& b, const Vec3& normal) {
  return -gap_along<BoundedNumber>(a, b, fine(-normal));
}

/// From A to B, where the direction leads from B to A.
Vec3 normal_of(const FineDirection& direction) {
  return -unit_or_zero({direction[0].high, direction[1].high, direction[2].high});
}

/// The bodies moved apart along the normal, and no farther than by the gap.
SmoothNearest nearest_when_parted(const SmoothBody& a, const SmoothBody& b, const Vec3& way) {
  return nearest_of(a.moved(exactly(-way)), b, SmoothQuestion::distance);
}

/// Of bodies that hardly meet, a direction along which they overlap hardly at all: A − B has a surface at the origin,
/// and no inside from which to look for it. But A made smaller by a part ε of its size, around its middle, is apart
/// from B, and has a proved direction to the nearest point d. With heights h seen from the middle, A and B overlap
/// along d by no more than ε (h(d) − h(n)), where n is a direction along which they do not: the less the smaller ε is,
/// and the nearer d comes to n.
class TouchingPair {
 public:
  TouchingPair(const SmoothBody& a, const SmoothBody& b) : a_(a), b_(b) {}

  /// The cheap guesses come first: where one shows that they no more than touch, none is better. `proved` is the normal
  /// of a plane between them, or zero.
  SmoothParting least(const Vec3& proved) {
    take_axes();
    if (best_.depth > rounding_along) take(proved);
    for (const double part : parts_made_smaller) {
      if (best_.depth <= rounding_along) break;
      const SmoothNearest near = nearest_of(a_.made_smaller(part), b_, SmoothQuestion::distance);
      if (near.contact == SmoothContact::apart) take(normal_of(near.direction));
    }
    return best_;
  }

 private:
  static constexpr std::array<double, 5> parts_made_smaller{0x1p-4, 0x1p-10, 0x1p-18, 0x1p-26, 0x1p-34};

  /// Those of the smooth shapes, and against them.
  void take_axes() {
    for (const SmoothBody* body : {&a_, &b_})
      if (body->smooth_kind())
        for (const BoundedVector& axis : body->axes())
          for (const double sign : {1.0, -1.0}) take(unit_or_zero(sign * plain(axis)));
  }

  void take(const Vec3& d) {
    if (d == Vec3{}) return;
    const double depth = depth_along(a_, b_, d);
    if (depth < best_.depth) best_ = {d, depth, a_.support(d).point, b_.support(-d).point};
  }

  const SmoothBody& a_;
  const SmoothBody& b_;
  SmoothParting best_{{}, HUGE_VAL, {}, {}};
};

SmoothParting first_parting(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  // Of a point that exact signs found in both it is open whether it is an inner one.
  if (met.contact != SmoothContact::contact || met.shared)
    return TouchingPair(a, b).least(met.shared ? met.shared->normal : Vec3{});
  const Penetration least = least_depth(a, b);
  return {least.direction, least.upper, least.on_a, least.on_b};
}

/// Across the normal.
double aside(const Vec3& v, const Vec3& normal) { return plain_length(v - dot(v, normal) * normal); }

/// By Newton's method on the height of A − B, from farthest points that lie almost across from each other: of round
/// places, which have no others as far. False where it does not find the very points.
bool is_polished(SmoothParting& parting, const SmoothBody& a, const SmoothBody& b) {
  if (!(aside(parting.on_a - parting.on_b, parting.normal) <= almost_across)) return false;
  std::optional<Vec3> axis = parting.normal;
  for (int step = 0; axis && step < most_polishing; ++step) {
    const SmoothCap cap(a, b, HighestPoint(a, b, *axis));
    if (aside(cap.point(), cap.axis()) <= rounding_across) {
      const double depth = depth_along(a, b, cap.axis());
      if (!(depth < parting.depth + rounding_along)) return false;
      parting = {cap.axis(), depth, cap.on_a().point, cap.on_b().point};
      return true;
    }
    axis = cap.lower_axis();
  }
  return false;
}

/// Of what Newton's method in doubles ends with.
Vec3 point_of_side(const PlainBody& body, const QuickSide& side) {
  Vec3 point = side.grown_weight() * body.map(side.round);
  for (std::size_t i = 0; i < side.size; ++i) point = point + side.weight[i] * body.plain_centre(side.atom[i]);
  return point;
}

/// Where the bodies are brought apart along the normal, doubles mostly show that the nearest points lie across from
/// each other, as they do of the least depth: so the normal stays. False where they do not.
bool has_points_across(SmoothParting& parting, const SmoothBody& a, const SmoothBody& b) {
  constexpr double gap = gaps_between[0];
  const Vec3 apart = gap * parting.normal, way = parting.depth * parting.normal + apart;
  const PlainBody moved = a.PlainBody::moved(-way);
  SmoothSearch search(moved, b, -parting.normal);
  QuickPolish polish(moved, b);
  for (const double part : {0.1, 1e-3}) {
    search.run(part);
    std::array<SmoothSearch::Corner, 4> corner;
    const std::size_t count = search.corners(corner);
    if (search.inside()) return false;
    polish.begin({corner.data(), count}, search.nearest());
    if (!polish.run()) continue;
    const Vec3 x = point_of_side(moved, polish.on_a()), y = point_of_side(b, polish.on_b());
    if (!(plain_length(y - x - apart) <= rounding_across)) return false;
    parting.on_a = x + way;
    parting.on_b = y;
    return true;
  }
  return false;
}

/// How far the points under the normal are aside of each other, after which it is turned to the nearest ones; nothing
/// where that is no better.
std::optional<double> take_step(SmoothParting& parting, const SmoothBody& a, const SmoothBody& b, double gap) {
  const Vec3 way = (parting.depth + gap) * parting.normal;
  const SmoothNearest near = nearest_when_parted(a, b, way);
  if (near.contact != SmoothContact::apart) return {};
  parting.on_a = near.on_a + way;
  parting.on_b = near.on_b;
  const double off = aside(near.on_b - near.on_a, parting.normal);
  if (off <= rounding_across) return off;
  const Vec3 normal = normal_of(near.direction);
  const double depth = depth_along(a, b, normal);
  if (!(depth < parting.depth + rounding_along)) return {};
  parting.normal = normal;
  parting.depth = depth;
  return off;
}

}  // namespace

// All of A − B, moved so that it lies a gap before the origin, is no nearer to it than its nearest point w: along the
// direction of w they are parted no later. So each step shortens the way, until w lies along the normal.
SmoothParting parting_of(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  SmoothParting parting = first_parting(a, b, met);
  if (is_polished(parting, a, b) || has_points_across(parting, a, b)) return parting;
  for (const double gap : gaps_between) {
    double last = HUGE_VAL;
    for (int step = 0; step < most_parting_steps; ++step) {
      const std::optional<double> off = take_step(parting, a, b, gap);
      if (off && *off <= rounding_across) return parting;
      // What hardly turns from here turns more from nearer.
      if (!off || !(*off < 0.5 * last)) break;
      last = *off;
    }
  }
  return parting;
}

}  // namespace toccata
