#include "mover_judge.hpp"

#include <algorithm>
#include <cmath>

#include "toccata/query/distance.hpp"

namespace toccata::bench {
namespace {

/// A step is a catch that makes less of what nothing hinders.
constexpr double least_share = 0.9;

Vec3 middle_of(const Vec3& foot) { return foot + Vec3{0, 0, WalkerShape::height / 2}; }

bool passes_through(const SceneIndex& level, const Vec3& from, const Vec3& to) {
  const Vec3 start = middle_of(from), way = middle_of(to) - start;
  return !(way == Vec3{}) && level.cast_ray({start, way}).has_value();
}

/// Nothing is met any more by who has left the box of everything.
bool has_left(const Aabb& box, const Vec3& foot) {
  const Vec3 top = foot + Vec3{0, 0, WalkerShape::height};
  return !is_finite(foot) || !overlap(box, Aabb{foot, top});
}

std::size_t counted_of(const WalkedFeet& feet, const SceneIndex& level, const Aabb& box) {
  for (std::size_t i = 1; i < feet.size(); ++i)
    if (has_left(box, feet[i]) || passes_through(level, feet[i - 1], feet[i])) return i;
  return feet.size() - 1;
}

/// With room for who begins above everything.
Aabb box_of_level(const WalkWork& work) {
  const SceneInstance& first = work.models.front();
  const Aabb& box = first.model.bounds();
  return {box.lower + first.pose.offset, box.upper + first.pose.offset + Vec3{0, 0, 4}};
}

double depth_at(const WalkWork& work, const SceneIndex& level, const Pose& pose) {
  const double r = WalkerShape::radius;
  const Model axis = Segment({0, 0, r}, {0, 0, WalkerShape::height - r});
  double depth = 0;
  for (const Index object : level.overlapping({walker_model(), pose})) {
    const SceneInstance& other = work.models[object];
    const PairQuery query{pose, other.pose, Solid::automatic, other.solid};
    depth = std::max(depth, r - distance(axis, other.model, query).upper);
  }
  return depth;
}

struct AlongCorridor {
  double wished = 0, made = 0;
};

AlongCorridor along_corridor(const Vec3& wish, const Vec3& moved) {
  return {std::fabs(wish.x), std::copysign(1.0, wish.x) * moved.x};
}

}  // namespace

std::vector<std::size_t> counted_steps(const WalkWork& work, const SceneIndex& level,
                                       const std::vector<WalkedFeet>& walked) {
  const Aabb box = box_of_level(work);
  std::vector<std::size_t> counted;
  for (const WalkedFeet& feet : walked) counted.push_back(counted_of(feet, level, box));
  return counted;
}

WalkFaults judged_walks(const WalkWork& work, const SceneIndex& level, const std::vector<WalkedFeet>& walked) {
  const std::vector<std::size_t> counted = counted_steps(work, level, walked);
  WalkFaults faults;
  double wished = 0, made = 0;
  for (std::size_t w = 0; w < walked.size(); ++w) {
    const WalkedFeet& feet = walked[w];
    for (std::size_t i = 1; i <= counted[w]; ++i) {
      const Vec3 moved = feet[i] - feet[i - 1];
      ++faults.steps;
      faults.walked += std::hypot(moved.x, moved.y);
      if (passes_through(level, feet[i - 1], feet[i])) ++faults.tunnels;
      const Pose pose = Pose::translation(feet[i]);
      if (!level.overlapping({walker_model(), pose}).empty()) ++faults.overlaps;
      faults.deepest = std::max(faults.deepest, depth_at(work, level, pose));
      if (work.surface != TrueSurface::straight_corridor) continue;
      const AlongCorridor along = along_corridor(work.walks[w].wishes[i - 1], moved);
      wished += along.wished;
      made += along.made;
      if (along.made < least_share * along.wished) ++faults.catches;
    }
  }
  if (wished > 0) faults.lost = 1 - made / wished;
  return faults;
}

}  // namespace toccata::bench
