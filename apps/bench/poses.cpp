#include "poses.hpp"

#include <cmath>
#include <optional>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/rotation.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

/// Four numbers of a ball that is not too near to its centre, so that every rotation is as likely.
Mat3 random_rotation(Random& random) {
  const auto number = [&] { return random.between(-1, 1); };
  while (true) {
    const double x = number(), y = number(), z = number(), w = number();
    const double squared = x * x + y * y + z * z + w * w;
    if (0.01 < squared && squared < 1) return rotation_of({x, y, z, w});
  }
}

Vec3 random_vector(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

Vec3 random_direction(Random& random) { return random_rotation(random).column(0); }

struct Extent {
  Vec3 centre;
  double diagonal = 0;
};

Extent extent_of(const Model& model) {
  const Aabb& box = model.tree().nodes.front().volume;
  const Vec3 size = box.upper - box.lower;
  return {box.lower + 0.5 * size, std::sqrt(dot(size, size))};
}

/// Two turned meshes, B's centre being moved away from A's along a direction.
class Approach {
 public:
  Approach(const Model& a, const Model& b, Random& random)
      : a_(a), b_(b), extent_b_(extent_of(b)), direction_(random_direction(random)) {
    const Extent extent_a = extent_of(a);
    pose_a_ = {random_rotation(random), random_vector(random, extent_a.diagonal)};
    rotation_b_ = random_rotation(random);
    centre_a_ = transform(pose_a_, extent_a.centre);
    apart_ = 0.51 * (extent_a.diagonal + extent_b_.diagonal);
  }

  PosePair at(double distance) const {
    const Vec3 turned_centre = transform({rotation_b_, {}}, extent_b_.centre);
    return {pose_a_, {rotation_b_, centre_a_ + distance * direction_ - turned_centre}};
  }

  /// The distance of the outermost contact, up to 2^-steps of the way; nothing when none is seen.
  std::optional<double> contact(int steps) const {
    constexpr int looks = 16;
    int look = looks - 1;
    while (look >= 0 && !meets(apart_ * look / looks)) --look;
    if (look < 0) return std::nullopt;
    double meeting = apart_ * look / looks, free = apart_ * (look + 1) / looks;
    for (int step = 0; step < steps; ++step) (meets((meeting + free) / 2) ? meeting : free) = (meeting + free) / 2;
    return meeting;
  }

 private:
  bool meets(double distance) const {
    const PosePair poses = at(distance);
    return overlap(a_, b_, {poses.a, poses.b, Solid::none, Solid::none});
  }

  const Model& a_;
  const Model& b_;
  Extent extent_b_;
  Vec3 direction_;
  Pose pose_a_;
  Mat3 rotation_b_;
  Vec3 centre_a_;
  double apart_ = 0;
};

PosePair random_pose_pair(const Model& a, const Model& b, Random& random, Nearness nearness) {
  const double diagonal = std::min(extent_of(a).diagonal, extent_of(b).diagonal);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Approach approach(a, b, random);
    const std::optional<double> contact = approach.contact(nearness == Nearness::close ? 50 : 16);
    if (!contact) continue;
    const double side = random.below(2) == 0 ? -1 : 1;
    const double share = nearness == Nearness::close ? std::pow(10, random.between(-14, -6)) : 0.02 * random.unit();
    return approach.at(*contact + side * share * diagonal);
  }
  throw Error("the meshes met in none of 100 random directions, so no poses near contact can be made");
}

}  // namespace

std::vector<PosePair> random_poses(const Model& a, const Model& b, std::size_t count, std::uint64_t seed,
                                   Nearness nearness) {
  Random random(seed);
  std::vector<PosePair> poses;
  while (poses.size() < count) poses.push_back(random_pose_pair(a, b, random, nearness));
  return poses;
}

std::vector<PosePair> moved_together(const std::vector<PosePair>& poses, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<PosePair> moved;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose motion{random_rotation(random), random_vector(random, 10)};
    const PosePair& pair = poses[i % poses.size()];
    moved.push_back({compose(motion, pair.a), compose(motion, pair.b)});
  }
  return moved;
}

bool are_rigid(const PosePair& poses) {
  const auto rotates = [](const Mat3& m) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (std::abs(dot(m.column(i), m.column(j)) - (i == j ? 1 : 0)) > 1e-9) return false;
    return dot(cross(m[0], m[1]), m[2]) > 0;
  };
  return rotates(poses.a.linear) && rotates(poses.b.linear);
}

}  // namespace toccata::bench
