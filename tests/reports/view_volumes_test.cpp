// The polyhedra that are drawn of a hierarchy are the volumes: within all their planes, and touching each that has a
// face.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "reports/view/drawn_hierarchy.hpp"
#include "toccata/bounds/all_volumes.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// All points x with normal · x ≤ offset.
struct Plane {
  Vec3 normal;
  double offset = 0;
};

template <std::size_t k>
std::vector<Plane> planes_of(const Kdop<k>& volume) {
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < k / 2; ++i) {
    const Vec3 normal = kdop_normals<k>()[i];
    const double length = std::sqrt(dot(normal, normal));
    planes.push_back({(1 / length) * normal, volume.upper[i] / length});
    planes.push_back({(-1 / length) * normal, -volume.lower[i] / length});
  }
  return planes;
}

std::vector<Plane> planes_of(const Obb& box) {
  std::vector<Plane> planes;
  for (int i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) {
      const Vec3 normal = side * box.axes[i];
      planes.push_back({normal, dot(normal, box.centre) + box.half[i]});
    }
  return planes;
}

/// Every plane through three of the points that has all others on one side.
std::vector<Plane> planes_around(const std::vector<Vec3>& points) {
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (i >= j || i >= k || j == k) continue;
        const Vec3 normal = cross(points[j] - points[i], points[k] - points[i]);
        const double length = std::sqrt(dot(normal, normal));
        if (length < 1e-9) continue;
        const Plane plane{(1 / length) * normal, dot((1 / length) * normal, points[i])};
        if (std::all_of(points.begin(), points.end(),
                        [&](const Vec3& p) { return dot(plane.normal, p) <= plane.offset + 1e-12; }))
          planes.push_back(plane);
      }
  return planes;
}

/// Where three planes meet that is not beyond another.
std::vector<Vec3> corners_of(const std::vector<Plane>& planes) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k) {
        const Plane &a = planes[i], &b = planes[j], &c = planes[k];
        const double det = dot(a.normal, cross(b.normal, c.normal));
        if (std::abs(det) < 1e-6) continue;
        const Vec3 at = (1 / det) * (a.offset * cross(b.normal, c.normal) + b.offset * cross(c.normal, a.normal) +
                                     c.offset * cross(a.normal, b.normal));
        if (std::all_of(planes.begin(), planes.end(),
                        [&](const Plane& plane) { return dot(plane.normal, at) <= plane.offset + 1e-9; }))
          corners.push_back(at);
      }
  return corners;
}

/// The width of the face on a plane: less than `least` for those that are a corner or an edge.
bool has_face(const Plane& plane, const std::vector<Vec3>& corners, double least) {
  std::vector<Vec3> on;
  for (const Vec3& corner : corners)
    if (dot(plane.normal, corner) >= plane.offset - 1e-9) on.push_back(corner);
  for (std::size_t i = 1; i < on.size(); ++i)
    for (std::size_t j = 1; j < i; ++j) {
      const Vec3 area = cross(on[i] - on[0], on[j] - on[0]);
      if (std::sqrt(dot(area, area)) > least * least) return true;
    }
  return false;
}

Triangle triangle_of(const TriangleMesh& mesh, Index number) {
  const auto& corner = mesh.triangles()[number];
  return {{mesh.vertices()[corner[0]], mesh.vertices()[corner[1]], mesh.vertices()[corner[2]]}};
}

struct Drawn {
  std::vector<Triangle> held;
  std::vector<Vec3> corners;  // of what is drawn around them
};

std::vector<Drawn> drawn_nodes(const TriangleMesh& mesh, const io::DrawnHierarchy& hierarchy) {
  std::vector<Drawn> nodes;
  for (const io::DrawnLevel& level : hierarchy.levels) {
    const std::size_t first = nodes.size();
    for (std::size_t node = 0; node < level.nodes; ++node) {
      Drawn& drawn = nodes.emplace_back();
      const auto& run = hierarchy.runs[level.first_node + node];
      for (Index i = run[0]; i < run[0] + run[1]; ++i) drawn.held.push_back(triangle_of(mesh, hierarchy.order[i]));
    }
    for (std::size_t face = level.first_face; face < level.first_face + level.faces; ++face)
      for (const Vec3& corner : hierarchy.faces[face])
        nodes[first + hierarchy.node_of_face[face]].corners.push_back(corner);
  }
  return nodes;
}

double farthest(const std::vector<Vec3>& points, const Vec3& normal) {
  double most = -1e300;
  for (const Vec3& point : points) most = std::max(most, dot(normal, point));
  return most;
}

void expect_drawn_within(const Drawn& drawn, const std::vector<Plane>& planes, double least_face) {
  const std::vector<Vec3> corners = corners_of(planes);
  for (const Plane& plane : planes) {
    const double reach = farthest(drawn.corners, plane.normal);
    EXPECT_LE(reach, plane.offset + 1e-9);
    if (!has_face(plane, corners, least_face)) continue;
    EXPECT_GE(reach, plane.offset - 1e-9);
  }
}

TriangleMesh ring() { return torus_mesh({.around = 12, .sides = 9}); }

template <class Volume>
void expect_drawn_as_it_is(CostVolume volume) {
  const auto mesh = std::make_shared<const TriangleMesh>(ring());
  const std::vector<Drawn> nodes = drawn_nodes(*mesh, io::drawn_hierarchy(Model(mesh), volume));
  ASSERT_GT(nodes.size(), 100U);
  for (std::size_t i = 0; i < nodes.size() && i < 127; ++i) {
    SCOPED_TRACE(i);
    expect_drawn_within(nodes[i], planes_of(fit<Volume>(std::span<const Triangle>(nodes[i].held))), 1e-2);
  }
}

TEST(ViewVolumes, OrientedBoxesAreDrawnAsWhatTheyAre) { expect_drawn_as_it_is<Obb>(cost_volume<Obb>); }

TEST(ViewVolumes, DiscreteOrientationPolytopesAreDrawnAsWhatTheyAre) {
  expect_drawn_as_it_is<Kdop<6>>(cost_volume<Kdop<6>>);
  expect_drawn_as_it_is<Kdop<14>>(cost_volume<Kdop<14>>);
  expect_drawn_as_it_is<Kdop<18>>(cost_volume<Kdop<18>>);
  expect_drawn_as_it_is<Kdop<26>>(cost_volume<Kdop<26>>);
}

TEST(ViewVolumes, HullsAreDrawnAsWhatTheyAre) {
  const auto mesh = std::make_shared<const TriangleMesh>(ring());
  const std::vector<Drawn> nodes = drawn_nodes(*mesh, io::drawn_hierarchy(Model(mesh), cost_volume<HullBound>));
  std::size_t faces = 0;
  for (const Drawn& drawn : nodes) {
    if (drawn.held.size() > 20) continue;
    std::vector<Vec3> points;
    for (const Triangle& triangle : drawn.held)
      points.insert(points.end(), triangle.vertex.begin(), triangle.vertex.end());
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
      return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Plane& plane : planes_around(points)) {
      EXPECT_LE(std::abs(farthest(drawn.corners, plane.normal) - plane.offset), 1e-9);
      ++faces;
    }
  }
  EXPECT_GT(faces, 1000U);
}

}  // namespace
}  // namespace toccata
