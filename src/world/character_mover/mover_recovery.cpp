#include <algorithm>
#include <cmath>

#include "math/cube_directions.hpp"
#include "query/ask.hpp"
#include "toccata/query/penetration.hpp"
#include "world/character_mover/mover_walk.hpp"

namespace toccata {
namespace {

/// More rounds than any way out takes that there is.
constexpr int most_recovery_rounds = 16;

/// No free place is looked for that is nearer than that, where a way out was farther than the body is large.
constexpr double least_part_of_size = 0x1p-3;

bool are_overlapping(std::span<const NearThing> near) {
  return std::any_of(near.begin(), near.end(), [](const NearThing& thing) { return thing.gap.distance <= 0; });
}

}  // namespace

/// The least motion after which things that are too near are as far as the skin, judged by the planes across the
/// shortest ways to them, and that goes into none of what is in its way. The nearest come first: of a floor of many
/// triangles the way out of the nearest leads out of all, while the planes of those beside it lean, and ask for more.
std::optional<Vec3> MoverWalk::way_out(const Vec3& position, std::vector<NearThing> near,
                                       std::span<const Plane> blocking) const {
  std::stable_sort(near.begin(), near.end(),
                   [](const NearThing& a, const NearThing& b) { return a.gap.distance < b.gap.distance; });
  std::vector<MotionPlane> planes;
  for (const Plane& plane : blocking)
    if (plane.gap.distance >= setting_.too_near()) planes.push_back({plane.gap.normal, 0});
  Vec3 motion{};
  for (const NearThing& next : near) {
    if (around_.body().gap_at(position + motion, *next.thing).distance >= setting_.too_near()) continue;
    planes.push_back({next.gap.normal, setting_.skin - next.gap.distance});
    const std::optional<Vec3> farther = nearest_motion({}, planes);
    if (!farther) return {};
    motion = *farther;
  }
  return motion;
}

/// A body within a solid mesh leaves it by the shortest way that is told.
std::optional<Vec3> MoverWalk::out_of_solid(const Vec3& position, const SearchedObjects& objects) {
  const auto holder = around_.holder_of(position);
  if (!holder) return {};
  const Model& body = around_.body().model();
  const InstanceView at = objects.at(holder->object);
  const Model& mesh = holder->mesh.model();
  if (!is_defined(ShapeQuestion::penetration, body, mesh) || !taken_as_solid(body, Solid::automatic)) return {};
  const PairQuery query{around_.body().pose_at(position), holder->mesh.pose(), Solid::automatic, at.solid};
  const Penetration depth = penetration(body, mesh, query);
  if (!(depth.upper > 0)) return {};
  return position - (depth.upper + setting_.skin) * depth.direction;
}

bool MoverWalk::is_free(const Vec3& position) {
  return around_.things_within(position, setting_.too_near()).empty() && !around_.holder_of(position);
}

/// Planes of things that nearly face each other meet far away. Where that led farther than the body is large, a free
/// place is looked for half as far or less, in the directions of the sides, edges and corners of a cube.
std::optional<Vec3> MoverWalk::nearer_place(const Vec3& position, double distance) {
  double shorter = distance;
  while (shorter > least_part_of_size * around_.body().size()) shorter /= 2;
  while (shorter < distance) {
    for (const Vec3& direction : cube_directions) {
      const Vec3 way = normalized(direction);
      if (way != Vec3{} && is_free(position + shorter * way)) return position + shorter * way;
    }
    shorter *= 2;
  }
  return {};
}

RecoveredPlace MoverWalk::recovered(const Vec3& position, const SearchedObjects& objects) {
  RecoveredPlace place{position};
  if (const auto outside = out_of_solid(position, objects)) place.position = *outside;
  std::vector<Plane> blocking;
  std::vector<NearThing> near = around_.things_within(place.position, setting_.too_near());
  for (int round = 0; round < most_recovery_rounds && !near.empty(); ++round) {
    for (Plane& plane : blocking) plane.gap = around_.body().gap_at(place.position, plane.thing);
    const std::optional<Vec3> motion = way_out(place.position, near, blocking);
    if (!motion || *motion == Vec3{}) break;
    const auto met = around_.first_meeting(place.position, *motion);
    if (met) blocking.push_back({met->thing, met->gap});
    place.position += (met ? met->time : 1) * *motion;
    near = around_.things_within(place.position, setting_.too_near());
  }
  const double pushed = length(place.position - position);
  if (near.empty() && pushed > around_.body().size())
    if (const auto nearer = nearer_place(position, pushed)) place.position = *nearer;
  const bool is_held = around_.holder_of(place.position).has_value();
  place.stuck = are_overlapping(near) || is_held;
  place.tight = !near.empty() || is_held;
  return place;
}

}  // namespace toccata
