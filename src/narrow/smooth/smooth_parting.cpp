#include "narrow/smooth/smooth_parting.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// How far apart the bodies are brought in turn, so that they have nearest points; the pair is of size 1. From farther
/// out a step turns the normal more, from nearer the points are told more finely.
constexpr std::array<double, 4> gaps_between{0x1p-2, 0x1p-6, 0x1p-12, 0x1p-20};

/// The nearest points lie across from each other, but for this.
constexpr double rounding_across = 0x1p-44;

/// A direction that is no worse, but for this, is another one.
constexpr double rounding_along = 0x1p-46;

/// From one gap.
constexpr int most_steps = 3;

/// As far as it is told along a direction that is a double's.
double depth_along(const SmoothBody& a, const SmoothBody& b, const Vec3& normal) {
  return -gap_along<BoundedNumber>(a, b, fine(-normal));
}

/// The bodies moved apart along the normal, and no farther than by the gap.
SmoothNearest nearest_when_parted(const SmoothBody& a, const SmoothBody& b, const Vec3& way) {
  return nearest_of(a.moved(exactly(-way)), b, SmoothQuestion::distance);
}

enum class Step : std::uint8_t { none, another, last };

Step take_step(SmoothParting& parting, const SmoothBody& a, const SmoothBody& b, double gap) {
  const Vec3 way = (parting.depth + gap) * parting.normal;
  const SmoothNearest near = nearest_when_parted(a, b, way);
  if (near.contact != SmoothContact::apart) return Step::none;
  parting.on_a = near.on_a + way;
  parting.on_b = near.on_b;
  const Vec3 between = near.on_b - near.on_a;
  if (plain_length(between - dot(between, parting.normal) * parting.normal) <= rounding_across) return Step::last;
  const Vec3 normal = -unit_or_zero({near.direction[0].high, near.direction[1].high, near.direction[2].high});
  const double depth = depth_along(a, b, normal);
  if (!(depth < parting.depth + rounding_along)) return Step::none;
  parting.normal = normal;
  parting.depth = depth;
  return Step::another;
}

}  // namespace

// All of A − B, moved so that it lies a gap before the origin, is no nearer to it than its nearest point w: along the
// direction of w they are parted no later. So each step shortens the way, until w lies along the normal.
SmoothParting parting_of(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met) {
  const Penetration least = least_depth(a, b, met);
  SmoothParting parting{least.direction, least.upper, least.on_a, least.on_b};
  for (const double gap : gaps_between)
    for (int step = 0; step < most_steps; ++step)
      if (const Step taken = take_step(parting, a, b, gap); taken == Step::none)
        break;
      else if (taken == Step::last)
        return parting;
  return parting;
}

}  // namespace toccata
