#include "support/volume_cases.hpp"

#include <cmath>
#include <cstdio>

#include "oracle/rational.hpp"
#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

Vec3 small_whole_numbers(Random& random) {
  const auto number = [&] { return static_cast<double>(random.below(5)) - 2; };
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

/// One point of a cloud of the regime, of about size 1, but for the needles.
Vec3 cloud_point(const std::string& regime, Random& random, const Mat3& axes) {
  if (regime == "grid") return small_whole_numbers(random);
  Vec3 s = random_vector(random, 1);
  if (regime == "flat") s.z = 0;
  if (regime == "line") s.y = s.z = 0;
  if (regime == "point") s = {};
  if (regime == "needle") s = {1000 * s.x, 1e-6 * s.y, 1e-6 * s.z};
  return (s.x * axes[0] + s.y * axes[1]) + s.z * axes[2];
}

std::vector<Vec3> cloud(const std::string& regime, Random& random) {
  const Mat3 axes = random_rotation(random);
  const Vec3 offset = regime == "grid" ? small_whole_numbers(random) : 1.5 * random_vector(random, 1);
  // Whole numbers, so that differences of clouds that share it need not be rounded much.
  const Vec3 origin = regime == "far" ? Vec3{0x1p30, -0x1p31, 0x1p29} : Vec3{};
  const int exponent = regime == "tiny" ? -995 : regime == "huge" ? 995 : 0;
  const std::size_t count = 1 + random.below(10);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = origin + (offset + cloud_point(regime, random, axes));
    points.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
  }
  return points;
}

Pose cloud_pose(const std::string& regime, Random& random) {
  static const std::vector<std::string> families = {"rigid", "rigid", "scaled", "sheared", "mirrored", "singular"};
  const std::uint64_t kind = random.below(families.size() + 1);
  if (kind == families.size()) return {};
  Pose pose = random_poses(families[kind], random).pose_a;
  // Near enough to the cloud to matter.
  const double size = regime == "tiny" ? 0x1p-995 : regime == "huge" ? 0x1p995 : 1;
  pose.offset = size * pose.offset;
  return pose;
}

}  // namespace

const std::vector<std::string>& volume_regimes() {
  static const std::vector<std::string> regimes = {"random", "grid", "flat", "line", "point",
                                                   "needle", "far",  "tiny", "huge"};
  return regimes;
}

VolumeCase volume_case(const std::string& regime, Random& random) {
  VolumeCase input;
  input.a = cloud(regime, random);
  input.b = cloud(regime, random);
  input.shared = random.below(3) == 0;
  if (input.shared) input.b.push_back(input.a[random.below(input.a.size())]);
  for (std::uint64_t i = 1 + random.below(4); i > 0; --i) {
    const auto corner = [&] { return input.a[random.below(input.a.size())]; };
    const Vec3 p = corner(), q = corner(), r = corner();
    input.triangles.push_back({{p, q, r}});
  }
  input.pose = cloud_pose(regime, random);
  return input;
}

std::vector<Vec3> corners(const std::vector<Triangle>& triangles) {
  std::vector<Vec3> points;
  for (const Triangle& t : triangles) points.insert(points.end(), t.vertex.begin(), t.vertex.end());
  return points;
}

std::optional<Vec3> exact_difference_of(const Vec3& p, const Vec3& q) {
  const Vec3 difference = p - q;
  const oracle::RationalPoint exact = oracle::exact(p) - oracle::exact(q);
  if (!(exact == oracle::exact(difference))) return {};
  return difference;
}

bool found_less_than_every_pair(double gap, const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const oracle::Rational squared = oracle::exact(gap) * oracle::exact(gap);
  for (const Vec3& p : a)
    for (const Vec3& q : b) {
      const oracle::RationalPoint way = oracle::exact(p) - oracle::exact(q);
      if (dot(way, way) < squared) return false;
    }
  return true;
}

bool holds_but_for_rounding(const Aabb& box, double x) {
  const double slack = 1e-12 * std::max(std::fabs(box.lower.x), std::fabs(box.upper.x));
  return box.lower.x - slack <= x && x <= box.upper.x + slack;
}

std::string to_text(const VolumeCase& input) {
  std::string text;
  const auto add = [&](const char* name, const std::vector<Vec3>& points) {
    text += std::string("\n") + name;
    for (const Vec3& p : points) {
      std::array<char, 128> numbers{};
      std::snprintf(numbers.data(), numbers.size(), " {%a, %a, %a},", p.x, p.y, p.z);
      text += numbers.data();
    }
  };
  add("a", input.a);
  add("b", input.b);
  add("triangles", corners(input.triangles));
  add("pose", {input.pose.linear[0], input.pose.linear[1], input.pose.linear[2], input.pose.offset});
  return text;
}

}  // namespace toccata::test
