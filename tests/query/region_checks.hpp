#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/query/faces_in_region.hpp"

namespace toccata::test {

/// How regions lie to a mesh.
inline const std::vector<std::string>& region_families() {
  static const std::vector<std::string> all{"boxes", "flat boxes",       "boxes that touch", "points",
                                            "balls", "balls that touch", "tiny balls",       "huge"};
  return all;
}

struct RegionCase {
  TriangleMesh mesh;
  Pose pose;
  Region region;
};

inline Vec3 some_offset(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

inline Aabb box_of_two(const Vec3& p, const Vec3& q) { return merge(merge(Aabb{}, p), q); }

/// A point of a face of the posed mesh: a corner, the middle of an edge, or anywhere.
inline Vec3 some_point_of(const TriangleMesh& mesh, const Pose& pose, Random& random) {
  const auto& corner = mesh.triangles()[random.below(mesh.triangle_count())];
  std::array<Vec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = transform(pose, mesh.vertices()[corner[i]]);
  const std::uint64_t what = random.below(3);
  if (what == 0) return p[0];
  if (what == 1) return 0.5 * (p[0] + p[1]);
  const double s = random.unit(), t = random.unit() * (1 - s);
  return p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
}

inline Region some_region(const std::string& family, const Vec3& near, double size, Random& random) {
  const double reach = size * std::exp2(random.between(-8, 1));
  if (family == "boxes") return box_of_two(near + some_offset(random, reach), near + some_offset(random, reach));
  if (family == "flat boxes") {
    Vec3 to = near + some_offset(random, size);
    to[static_cast<int>(random.below(3))] = near[static_cast<int>(random.below(3))];
    to.x = near.x;
    return box_of_two(near, to);
  }
  if (family == "boxes that touch") return box_of_two(near, near + some_offset(random, reach));
  if (family == "points") return random.below(2) == 0 ? Region(Aabb{near, near}) : Region(Ball{near, 0});
  if (family == "balls") return Ball{near + some_offset(random, size), reach};
  if (family == "tiny balls") return Ball{near + some_offset(random, 1e-12 * size), 1e-12 * size * random.unit()};
  if (family == "huge") {
    const Vec3 far = some_offset(random, 1e9 * size);
    return random.below(2) == 0 ? Region(box_of_two(near, near + far))
                                : Region(Ball{near + far, std::sqrt(dot(far, far))});
  }
  // 3, 4, 5: on a grid the ball touches the point exactly.
  const double step = std::exp2(static_cast<double>(random.below(4)) - 6);
  return Ball{near + Vec3{3 * step, 0, random.below(2) == 0 ? 4 * step : -4 * step}, 5 * step};
}

inline RegionCase region_case(const std::string& family, Random& random) {
  const double grid = random.below(2) == 0 ? 8 : 0;
  const std::string pose_family = pose_families()[random.below(pose_families().size())];
  RegionCase c{random_soup(random, 40, 0.4, grid), {}, {}};
  if (random.below(3) != 0) c.pose = random_poses(pose_family, random).pose_a;
  double size = 0;
  for (const Vec3& p : c.mesh.vertices()) size = std::max(size, std::fabs((transform(c.pose, p) - c.pose.offset).x));
  c.region = some_region(family, some_point_of(c.mesh, c.pose, random), size + 1e-300, random);
  return c;
}

inline oracle::ConvexSet exact_set(const Region& region) {
  if (const auto* ball = std::get_if<Ball>(&region)) return oracle::sphere_set(ball->centre, ball->radius);
  const Aabb& box = std::get<Aabb>(region);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1) != 0 ? box.lower.x : box.upper.x, (i & 2) != 0 ? box.lower.y : box.upper.y,
                       (i & 4) != 0 ? box.lower.z : box.upper.z});
  return oracle::hull_set(corners);
}

/// Every triangle in rational arithmetic.
inline std::vector<FoundElement> exact_faces_in_region(const RegionCase& c) {
  const oracle::ConvexSet region = exact_set(c.region);
  std::vector<FoundElement> found;
  for (Index i = 0; i < c.mesh.triangle_count(); ++i) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = oracle::world_vertex(c.pose, c.mesh.vertices()[c.mesh.triangles()[i][k]]);
    if (oracle::overlap(oracle::triangle_set(p[0], p[1], p[2]), region)) found.push_back({i, c.mesh.face_of(i)});
  }
  return found;
}

}  // namespace toccata::test
