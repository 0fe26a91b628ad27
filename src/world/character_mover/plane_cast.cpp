#include "world/character_mover/plane_cast.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// By how much of it a square is enlarged that sums of squares are compared with: more than they are off by, and than
/// what the normals of a face and a side are not at right angles.
constexpr double beyond_rounding = 1 + 0x1p-40;

/// Later than any time of the way.
constexpr double beyond_the_way = 2;

}  // namespace

PlaneCast::PlaneCast(const FewCorners& corners, const Vec3& motion, const Reach& reach)
    : corners_(corners), motion_(motion), reach_(reach) {
  reach_.spare += 4 * height_slack(std::max(corners.extent, largest_magnitude(motion)), 0);
}

double PlaneCast::distance_from(double extent, double radius) const {
  return reach_.distance + radius + height_slack(corners_.extent, extent);
}

PlaneCast::Heights PlaneCast::heights_over(const ThingPlanes::Plane& plane, double distance) const {
  return {corners_.lowest_along(plane.normal) - plane.top - distance, -dot(plane.normal, motion_)};
}

double PlaneCast::free_of(const Heights& heights) const {
  if (!(heights.excess >= 0)) return 0;
  return heights.approach <= reach_.parallel_speed ? beyond_the_way : heights.excess / heights.approach;
}

bool PlaneCast::is_kept_off(const TriangleFace& face) const {
  if (!face.is_told) return false;
  const double distance = distance_from(face.extent, 0);
  return free_of(heights_over(face.upper, distance)) > 1 || free_of(heights_over(face.lower, distance)) > 1;
}

/// The body is met no sooner than when the squares of its heights over the face and the side add up to that of the
/// distance, of which the side's is least at an end of the way.
double PlaneCast::earliest_beside(const ThingPlanes& planes, const std::array<Heights, 2>& face, double side,
                                  double distance) const {
  const double spared = distance + reach_.spare + 4 * height_slack(planes.extent, 0);
  const double room = spared * spared * beyond_rounding - side * side;
  if (!(room >= 0)) return beyond_the_way;
  const double least_height = std::sqrt(room) * beyond_rounding;
  double earliest = 0;
  for (const Heights& heights : face) {
    const double excess = heights.excess + distance - least_height;
    if (!(excess >= 0)) continue;
    earliest = std::max(earliest, heights.approach > 0 ? excess / heights.approach : beyond_the_way);
  }
  return earliest;
}

PlaneCast::Times PlaneCast::times_of(const ThingPlanes& planes) const {
  const double distance = distance_from(planes.extent, planes.radius);
  std::array<Heights, 2> face{};
  double side = 0;
  Times times;
  for (std::size_t p = 0; p < planes.count && times.free <= 1; ++p) {
    const Heights heights = heights_over(planes.planes[p], distance);
    times.free = std::max(times.free, free_of(heights));
    times.earliest = std::max(times.earliest, free_of({heights.excess - reach_.spare, heights.approach}));
    if (p < face.size())
      face[p] = heights;
    else
      side = std::max(side, heights.excess + distance - std::max(0.0, heights.approach));
  }
  if (times.free > 1) return {beyond_the_way, beyond_the_way};
  if (planes.is_triangle && planes.count > 0)
    times.earliest =
        std::max(times.earliest, earliest_beside(planes, face, std::max(0.0, side - reach_.spare), distance));
  return times;
}

}  // namespace toccata
