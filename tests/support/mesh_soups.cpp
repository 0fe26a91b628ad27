#include "support/mesh_soups.hpp"

#include <array>
#include <cmath>

namespace toccata::test {
namespace {

double snap(double value, double grid) { return grid == 0 ? value : std::round(value * grid) / grid; }

Vec3 snap(const Vec3& v, double grid) { return {snap(v.x, grid), snap(v.y, grid), snap(v.z, grid)}; }

Mat3 product(const Mat3& a, const Mat3& b) { return a * b; }

Mat3 diagonal(double x, double y, double z) { return {{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}}; }

Mat3 sheared(Random& random) {
  Mat3 shear;
  shear[0].y = random.between(-2, 2);
  shear[1].z = random.between(-2, 2);
  return product(random_rotation(random), shear);
}

/// A matrix of rank 2, or seldom 1: rows that are exact multiples or sums of others.
Mat3 singular(Random& random) {
  Mat3 flat = random_rotation(random);
  flat[2] = random.below(4) == 0 ? Vec3{} : 2 * flat[0];
  if (random.below(6) == 0) flat[1] = -flat[0];
  return flat;
}

Mat3 on_grid(Random& random) {
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    m[i] = snap(random_vector(random, 1), 2);
    m[i][i] += 1;
  }
  return m;
}

Mat3 random_linear(const std::string& family, Random& random) {
  const Mat3 rotation = random_rotation(random);
  const auto stretch = [&] { return std::exp(random.between(-1, 1)); };
  if (family == "scaled") {
    const double x = stretch(), y = stretch(), z = stretch();
    return product(rotation, diagonal(x, y, z));
  }
  if (family == "sheared") return sheared(random);
  if (family == "mirrored") return product(rotation, diagonal(1, -stretch(), 1));
  if (family == "singular") return singular(random);
  if (family == "small") return product(rotation, diagonal(1e-6, 1e-6, 1e-6));
  if (family == "large") return product(rotation, diagonal(1e6, 1e6, 1e6));
  if (family == "snapped") return on_grid(random);
  return rotation;
}

/// How large the family's unit cube is in the world.
double size_of(const std::string& family) { return family == "small" ? 1e-6 : family == "large" ? 1e6 : 1; }

Pose random_pose(const std::string& family, Random& random) {
  Pose pose{random_linear(family, random), {}};
  // The cube's centre goes near the origin; far families move both poses later.
  const Vec3 centre = transform(pose, {0.5, 0.5, 0.5});
  pose.offset = random_vector(random, 0.6 * size_of(family)) - centre;
  if (family == "snapped") pose.offset = snap(pose.offset, 4);
  return pose;
}

}  // namespace

Vec3 random_vector(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Mat3 random_rotation(Random& random) {
  std::array<double, 4> q{};
  double squared = 0;
  while (squared < 0.01 || squared > 1) {
    squared = 0;
    for (double& number : q) {
      number = random.between(-1, 1);
      squared += number * number;
    }
  }
  const double s = 2 / squared;
  const auto [w, x, y, z] = q;
  return {{{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
            {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
            {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}}};
}

TriangleMesh random_soup(Random& random, Index triangles, double size, double grid) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> corners;
  for (Index i = 0; i < triangles; ++i) {
    const Vec3 centre{random.unit(), random.unit(), random.unit()};
    const auto add = [&] {
      vertices.push_back(snap(centre + random_vector(random, size), grid));
      return static_cast<Index>(vertices.size() - 1);
    };
    const auto known = [&] { return static_cast<Index>(random.below(vertices.size())); };
    // Most triangles stand alone; some use an old vertex, some are segments.
    const Index first = add(), second = add();
    const std::uint64_t kind = random.below(10);
    corners.push_back({first, second, kind == 0 ? known() : kind == 1 ? second : add()});
  }
  return {std::move(vertices), std::move(corners)};
}

TriangleMesh box_between(const Vec3& lower, const Vec3& upper) {
  std::vector<Vec3> corner;
  for (int i = 0; i < 8; ++i)
    corner.push_back(
        {(i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y, (i & 4) != 0 ? upper.z : lower.z});
  return {std::move(corner),
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}}};
}

const std::vector<std::string>& pose_families() {
  static const std::vector<std::string> families{"rigid", "scaled", "sheared", "mirrored", "singular",
                                                 "far",   "small",  "large",   "snapped"};
  return families;
}

PairQuery random_poses(const std::string& family, Random& random) {
  PairQuery query{random_pose(family, random), random_pose(family, random), Solid::none, Solid::none};
  if (family != "far") return query;
  const Vec3 away{1e6 * random.between(-1, 1), -1e6, 1e6};
  query.pose_a.offset = query.pose_a.offset + away;
  query.pose_b.offset = query.pose_b.offset + away;
  return query;
}

}  // namespace toccata::test
