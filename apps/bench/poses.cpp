#include "poses.hpp"

#include <cmath>
#include <filesystem>
#include <optional>

#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/core/random.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

/// Four numbers of a ball that is not too near to its centre, so that every rotation is as likely.
Mat3 uniform_rotation(Random& random) {
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

Vec3 uniform_direction(Random& random) { return uniform_rotation(random).column(0); }

struct Extent {
  Vec3 centre;
  double diagonal = 0;
};

Extent extent_of(const TriangleMesh& mesh) {
  const Aabb box = fit_aabb(mesh.vertices());
  const Vec3 size = box.upper - box.lower;
  return {box.lower + 0.5 * size, std::sqrt(dot(size, size))};
}

/// Two models, and how large they are.
struct PairWithExtents {
  const Model& a;
  const Model& b;
  Extent extent_a = extent_of(a.mesh());
  Extent extent_b = extent_of(b.mesh());
};

/// The middle of a random triangle.
Vec3 random_place_on(const TriangleMesh& mesh, Random& random) {
  const auto& corner = mesh.triangles()[random.below(mesh.triangle_count())];
  const std::span<const Vec3> v = mesh.vertices();
  return (1 / 3.0) * ((v[corner[0]] + v[corner[1]]) + v[corner[2]]);
}

/// Two turned meshes, a point of B being moved away from one of A along a direction: from centre to centre, or, where
/// one mesh is so much smaller that it would hardly ever be met, from its centre to anywhere on the other's surface.
class Approach {
 public:
  Approach(const PairWithExtents& pair, Random& random) : pair_(pair), direction_(uniform_direction(random)) {
    const double diagonal_a = pair.extent_a.diagonal, diagonal_b = pair.extent_b.diagonal;
    pose_a_ = {uniform_rotation(random), random_vector(random, diagonal_a)};
    rotation_b_ = uniform_rotation(random);
    const bool small_a = diagonal_a < unlike * diagonal_b, small_b = diagonal_b < unlike * diagonal_a;
    point_a_ = transform(pose_a_, small_b ? random_place_on(pair.a.mesh(), random) : pair.extent_a.centre);
    point_b_ = small_a ? random_place_on(pair.b.mesh(), random) : pair.extent_b.centre;
    apart_ = small_a || small_b ? 1.02 * std::min(diagonal_a, diagonal_b) : 0.51 * (diagonal_a + diagonal_b);
  }

  PosePair at(double distance) const {
    return {pose_a_, {rotation_b_, point_a_ + distance * direction_ - transform({rotation_b_, {}}, point_b_)}};
  }

  /// The distance of the outermost contact, up to 2^-steps of the way; nothing when none is seen.
  std::optional<double> contact(int steps) const {
    constexpr int looks = 16;
    if (meets(apart_)) return std::nullopt;
    int look = looks - 1;
    while (look >= 0 && !meets(apart_ * look / looks)) --look;
    if (look < 0) return std::nullopt;
    double meeting = apart_ * look / looks, free = apart_ * (look + 1) / looks;
    for (int step = 0; step < steps; ++step) (meets((meeting + free) / 2) ? meeting : free) = (meeting + free) / 2;
    return meeting;
  }

 private:
  static constexpr double unlike = 0.25;

  bool meets(double distance) const {
    const PosePair poses = at(distance);
    return overlap(pair_.a, pair_.b, {poses.a, poses.b, Solid::none, Solid::none});
  }

  const PairWithExtents& pair_;
  Vec3 direction_;
  Pose pose_a_;
  Mat3 rotation_b_;
  Vec3 point_a_;
  Vec3 point_b_;  ///< in its own frame
  double apart_ = 0;
};

PosePair random_pose_pair(const PairWithExtents& pair, Random& random, const Nearness& nearness) {
  using Kind = Nearness::Kind;
  const double diagonal = std::min(pair.extent_a.diagonal, pair.extent_b.diagonal);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Approach approach(pair, random);
    const bool is_fine = nearness.kind == Kind::close || nearness.kind == Kind::gap;
    const std::optional<double> contact = approach.contact(is_fine ? 50 : 16);
    if (!contact) continue;
    if (nearness.kind == Kind::gap) return approach.at(*contact + nearness.gap * diagonal);
    if (nearness.kind == Kind::separated) return approach.at(*contact + (1e-4 + 0.02 * random.unit()) * diagonal);
    const double side = random.below(2) == 0 ? -1 : 1;
    const double share = nearness.kind == Kind::close ? std::pow(10, random.between(-14, -6)) : 0.02 * random.unit();
    return approach.at(*contact + side * share * diagonal);
  }
  throw Error("the meshes met in none of 100 random directions, so no poses near contact can be made");
}

/// A turn about B's centre and a translation.
struct Step {
  Mat3 turn;
  Vec3 translation;
};

/// No vertex within half of B's diagonal of its centre moves farther than `length`: by half of that each.
Step random_step(Random& random, double length, double diagonal) {
  const double degrees = length / diagonal * 180 / 3.14159265358979;
  return {rotation_about(uniform_direction(random), degrees), 0.5 * length * uniform_direction(random)};
}

Pose moved_on(const Pose& pose, const Vec3& centre, const Step& step) {
  const Vec3 at = transform(pose, centre);
  const Pose turned = Pose{step.turn, {}} * Pose{pose.linear, {}};
  return {turned.linear, at + step.translation - transform(turned, centre)};
}

/// The way on from a pose of B; where none of a hundred directions is free, it stays.
Pose next_on_the_way(const PairWithExtents& pair, const PosePair& now, double length, Step& step, Random& random) {
  const double diagonal = std::min(pair.extent_a.diagonal, pair.extent_b.diagonal);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Pose next = moved_on(now.b, pair.extent_b.centre, step);
    const PairQuery query{now.a, next, Solid::none, Solid::none};
    if (!overlap(pair.a, pair.b, query) && within_distance(pair.a, pair.b, 0.04 * diagonal, query)) return next;
    step = random_step(random, length, pair.extent_b.diagonal);
  }
  return now.b;
}

/// From A's centre to B's, of length 1.
Vec3 way_apart(const PairWithExtents& pair, const PosePair& poses) {
  const Vec3 way = transform(poses.b, pair.extent_b.centre) - transform(poses.a, pair.extent_a.centre);
  const double length = std::sqrt(dot(way, way));
  return length > 0 ? (1 / length) * way : Vec3{1, 0, 0};
}

}  // namespace

std::vector<PosePair> read_poses(const std::filesystem::path& file) {
  std::vector<PosePair> poses;
  for (const PairQuery& query : toccata::read_poses(file)) poses.push_back({query.pose_a, query.pose_b});
  return poses;
}

std::vector<PosePair> random_poses(const Model& a, const Model& b, std::size_t count, std::uint64_t seed,
                                   const Nearness& nearness, int threads) {
  const PairWithExtents pair{a, b};
  Random seeds(seed);
  std::vector<Random> randoms;
  while (randoms.size() < count) randoms.emplace_back(seeds.bits());
  std::vector<PosePair> poses(count);
  parallel_for(count, threads, [&](std::size_t i) { poses[i] = random_pose_pair(pair, randoms[i], nearness); });
  return poses;
}

std::vector<PosePair> poses_on_the_way(const Model& a, const Model& b, std::size_t count, std::uint64_t seed,
                                       const WayShape& shape) {
  constexpr std::size_t steps = 50;
  const PairWithExtents pair{a, b};
  Random random(seed);
  const double diagonal = std::min(pair.extent_a.diagonal, pair.extent_b.diagonal), length = shape.motion * diagonal;
  std::vector<PosePair> poses;
  for (const PosePair& start : random_poses(a, b, (count + steps - 1) / steps, seed, {Nearness::Kind::separated}, 0)) {
    PosePair now = start;
    const Vec3 apart = shape.gap * diagonal * way_apart(pair, start);
    Step step = random_step(random, length, pair.extent_b.diagonal);
    for (std::size_t i = 0; i < steps && poses.size() < count; ++i) {
      poses.push_back({now.a, {now.b.linear, now.b.offset + apart}});
      now.b = next_on_the_way(pair, now, length, step, random);
    }
  }
  return poses;
}

std::vector<PosePair> moved_together(const std::vector<PosePair>& poses, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<PosePair> moved;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose motion{uniform_rotation(random), random_vector(random, 10)};
    const PosePair& pair = poses[i % poses.size()];
    moved.push_back({motion * pair.a, motion * pair.b});
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
