#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "shapes/hull_cases.hpp"

// Hulls of points that are not in one plane, compared with CGAL's: the same volume, exactly, and the same vertices.
namespace toccata::test {
namespace {

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Predicates::Point_3>;

Exact::Point_3 exact(const Vec3& v) { return {v.x, v.y, v.z}; }

struct Lexicographic {
  bool operator()(const Vec3& p, const Vec3& q) const { return lexicographically_less(p, q); }
};

/// Six times the volume, and the extreme points.
struct HullSeen {
  Exact::FT volume = 0;
  std::set<Vec3, Lexicographic> vertices;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    volume += CGAL::determinant(exact(a) - CGAL::ORIGIN, exact(b) - CGAL::ORIGIN, exact(c) - CGAL::ORIGIN);
    vertices.insert({a, b, c});
  }
};

HullSeen seen_by_cgal(const std::vector<Vec3>& points) {
  std::vector<Predicates::Point_3> given;
  for (const Vec3& p : points) given.emplace_back(p.x, p.y, p.z);
  Mesh mesh;
  CGAL::convex_hull_3(given.begin(), given.end(), mesh);
  HullSeen seen;
  for (const auto face : mesh.faces()) {
    std::vector<Vec3> corners;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      corners.push_back({mesh.point(vertex).x(), mesh.point(vertex).y(), mesh.point(vertex).z()});
    for (std::size_t i = 2; i < corners.size(); ++i) seen.add(corners[0], corners[i - 1], corners[i]);
  }
  return seen;
}

HullSeen seen_by_toccata(const ConvexHull& hull) {
  HullSeen seen;
  const HullTopology t = hull.topology();
  const auto corner = [&](Index h) { return hull.vertex(t.origin[h]); };
  for (Index f = 0; f < t.face_count(); ++f)
    for (Index h = t.face_start[f] + 2; h < t.face_start[f + 1]; ++h)
      seen.add(corner(t.face_start[f]), corner(h - 1), corner(h));
  return seen;
}

/// CGAL may keep points within faces and edges, so its vertices are at least those.
std::string compare(const std::vector<Vec3>& points) {
  const ConvexHull hull(points);
  if (hull.dimension() < 3) return "";
  const HullSeen ours = seen_by_toccata(hull), theirs = seen_by_cgal(points);
  if (ours.volume != theirs.volume) return "volume";
  const bool included = std::ranges::includes(theirs.vertices, ours.vertices, Lexicographic());
  return included ? "" : "vertices";
}

TEST(ConvexHull, AgreesWithCgal) {
  for (const std::string& family : hull_families()) {
    if (family == "mixed") continue;  // slow, in CGAL as in Toccata
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Random random(seed + 100);
      const std::vector<Vec3> points = hull_points(family, random, seed % 4 == 0 ? 200 : 24);
      ASSERT_EQ(compare(points), "") << family << " seed " << seed;
    }
  }
}

TEST(ConvexHullSlow, AgreesWithCgalForManyPoints) {
  for (const char* family : {"ball", "sphere", "grid", "near-coplanar", "needle", "distant"}) {
    Random random(11);
    ASSERT_EQ(compare(hull_points(family, random, 5000)), "") << family;
  }
}

}  // namespace
}  // namespace toccata::test
