#include "dop_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "toccata/bounds/kdop.hpp"

namespace toccata::bench {
namespace {

struct DopSide {
  Vec3 normal;
  double offset = 0;
};

template <std::size_t k>
std::vector<DopSide> sides_of(const Kdop<k>& dop) {
  constexpr auto normals = kdop_normals<k>();
  std::vector<DopSide> sides;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    sides.push_back({normals[i], dop.upper[i]});
    sides.push_back({-normals[i], -dop.lower[i]});
  }
  return sides;
}

/// Where three planes meet that are not parallel to a line and no other plane cuts it off.
std::vector<Vec3> corners_of(const std::vector<DopSide>& sides) {
  constexpr double rounding = 1e-12;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j)
      for (std::size_t l = j + 1; l < sides.size(); ++l) {
        const DopSide &a = sides[i], &b = sides[j], &c = sides[l];
        const double volume = dot(a.normal, cross(b.normal, c.normal));  // a whole number
        if (volume == 0) continue;
        const Vec3 sum = a.offset * cross(b.normal, c.normal) + b.offset * cross(c.normal, a.normal) +
                         c.offset * cross(a.normal, b.normal);
        const Vec3 corner = (1 / volume) * sum;
        if (std::ranges::all_of(sides, [&](const DopSide& s) { return dot(s.normal, corner) <= s.offset + rounding; }))
          corners.push_back(corner);
      }
  return corners;
}

std::vector<Vec3> random_points(Random& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    const Vec3 p{x, y, z};
    points.push_back((1 / std::max(1.0, std::sqrt(dot(p, p)))) * p);
  }
  return points;
}

}  // namespace

ConvexHull random_dop(const std::string& kind, Random& random) {
  const std::vector<Vec3> points = random_points(random);
  return ConvexHull(with_planes(kind, [&]<std::size_t k>() { return corners_of(sides_of(fit<Kdop<k>>(points))); }));
}

}  // namespace toccata::bench
