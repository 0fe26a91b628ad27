// Regions of contact of solids beside the parts of the regularised intersection of CGAL's Nef polyhedra, in exact
// numbers: how many there are, their boxes, areas and normals, and what their depths promise.
#include <CGAL/Side_of_triangle_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "query/cgal_solids.hpp"
#include "support/case_seeds.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata::test {
namespace {

using CgalVector = CgalKernel::Vector_3;
using CgalPart = std::vector<CgalTriangle>;

/// Coordinates are off by a last place at most; numbers found by way of the nearest points by more.
constexpr double last_place = 1e-15, near_enough = 1e-10;

CgalPoint exact_point(const Vec3& p) { return {p.x, p.y, p.z}; }
CgalVector exact_vector(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 rounded(const CgalVector& v) { return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())}; }

double length_of(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// Triangles that share points are of one part.
std::vector<CgalPart> parts_of(const CgalNef& solid) {
  const std::vector<CgalTriangle> all = triangles_of(solid);
  std::map<CgalPoint, std::size_t> first_at;  // the number of the first triangle at a point
  std::vector<std::size_t> leader(all.size());
  const auto leader_of = [&](std::size_t i) {
    while (leader[i] != i) i = leader[i];
    return i;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    leader[i] = i;
    for (int corner = 0; corner < 3; ++corner)
      leader[leader_of(i)] = leader_of(first_at.try_emplace(all[i][corner], i).first->second);
  }
  std::map<std::size_t, CgalPart> parts;
  for (std::size_t i = 0; i < all.size(); ++i) parts[leader_of(i)].push_back(all[i]);
  std::vector<CgalPart> result;
  for (auto& [number, part] : parts) result.push_back(std::move(part));
  return result;
}

/// The box of a part is that of the region.
bool is_around(const Aabb& box, const CgalPart& part) {
  for (int axis = 0; axis < 3; ++axis) {
    CgalNumber lower = part[0][0][axis], upper = lower;
    for (const CgalTriangle& t : part)
      for (int corner = 0; corner < 3; ++corner) {
        lower = std::min(lower, t[corner][axis]);
        upper = std::max(upper, t[corner][axis]);
      }
    if (CGAL::abs(lower - box.lower[axis]) > last_place || CGAL::abs(upper - box.upper[axis]) > last_place)
      return false;
  }
  return true;
}

/// Half the area of its surface, as it is seen along the direction.
CgalNumber shadow_of(const CgalPart& part, const CgalVector& along) {
  CgalNumber four_areas = 0;
  for (const CgalTriangle& t : part)
    four_areas += CGAL::abs(CGAL::scalar_product(along, CGAL::cross_product(t[1] - t[0], t[2] - t[0])));
  return four_areas / 4;
}

CgalVector doubled_area_of(const CgalTriangle& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]); }

/// Twice the area that two triangles in one plane share.
CgalNumber doubled_common_area(const CgalTriangle& t, const CgalTriangle& u, const CgalVector& along) {
  const auto found = CGAL::intersection(t, u);
  if (!found) return 0;
  std::vector<CgalPoint> corners;
  if (const auto* triangle = boost::get<CgalTriangle>(&*found))
    corners = {triangle->vertex(0), triangle->vertex(1), triangle->vertex(2)};
  else if (const auto* polygon = boost::get<std::vector<CgalPoint>>(&*found))
    corners = *polygon;
  CgalVector doubled(0, 0, 0);
  for (std::size_t i = 2; i < corners.size(); ++i)
    doubled = doubled + CGAL::cross_product(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return CGAL::abs(CGAL::scalar_product(along, doubled));
}

/// Of faces that touch from outside, how large what they share is, seen along the direction: no intersection of solids
/// has these, and the area of a region has.
CgalNumber touching_shadow(const std::vector<CgalTriangle>& a, const std::vector<CgalTriangle>& b,
                           const CgalVector& along) {
  CgalNumber doubled = 0;
  for (const CgalTriangle& t : a)
    for (const CgalTriangle& u : b) {
      const CgalVector n = doubled_area_of(t), m = doubled_area_of(u);
      if (CGAL::cross_product(n, m) != CgalVector(0, 0, 0) || CGAL::scalar_product(n, m) > 0) continue;
      if (t.supporting_plane().has_on(u[0])) doubled += doubled_common_area(t, u, along);
    }
  return doubled / 2;
}

CgalNumber squared_distance_from(const CgalPoint& p, const std::vector<CgalTriangle>& surface) {
  CgalNumber least = CGAL::squared_distance(p, surface[0]);
  for (const CgalTriangle& t : surface) least = std::min(least, CGAL::squared_distance(p, t));
  return least;
}

/// Whether √x + √y ≥ depth, of exact numbers that are not negative.
bool is_as_deep(const CgalNumber& x, const CgalNumber& y, const CgalNumber& depth) {
  const CgalNumber more = depth * depth - x - y;
  return more <= 0 || more * more <= 4 * x * y;
}

CgalPoint nearest_on_edge(const CgalPoint& p, const CgalPoint& from, const CgalPoint& to) {
  const CgalNumber along = CGAL::scalar_product(p - from, to - from) / CGAL::squared_distance(from, to);
  return from + std::clamp(along, CgalNumber(0), CgalNumber(1)) * (to - from);
}

CgalPoint nearest_on_triangle(const CgalPoint& p, const CgalTriangle& t) {
  const CgalPoint below = t.supporting_plane().projection(p);
  if (t.has_on(below)) return below;
  CgalPoint nearest = nearest_on_edge(p, t[0], t[1]);
  for (const CgalPoint& other : {nearest_on_edge(p, t[1], t[2]), nearest_on_edge(p, t[2], t[0])})
    if (CGAL::compare_distance_to_point(p, other, nearest) == CGAL::SMALLER) nearest = other;
  return nearest;
}

/// The ways from p to the points of the surface that are as near as the nearest, but for rounding.
std::vector<Vec3> shortest_ways(const CgalPoint& p, const CgalNumber& squared_distance,
                                const std::vector<CgalTriangle>& surface) {
  const double at_most = std::sqrt(CGAL::to_double(squared_distance)) + near_enough;
  std::vector<Vec3> ways;
  for (const CgalTriangle& t : surface)
    if (CGAL::squared_distance(p, t) <= at_most * at_most) ways.push_back(rounded(nearest_on_triangle(p, t) - p));
  return ways;
}

/// One solid as CGAL has it.
struct CgalSide {
  CgalSide(const TriangleMesh& mesh, const Pose& pose)
      : polyhedron(cgal_polyhedron(mesh, pose)), solid(cgal_solid(mesh, pose)), side_of(polyhedron) {
    for (auto facet = polyhedron.facets_begin(); facet != polyhedron.facets_end(); ++facet) {
      const auto edge = facet->halfedge();
      surface.emplace_back(edge->vertex()->point(), edge->next()->vertex()->point(),
                           edge->next()->next()->vertex()->point());
    }
  }
  [[nodiscard]] bool holds(const CgalPoint& p) const { return side_of(p) != CGAL::ON_UNBOUNDED_SIDE; }

  CgalPolyhedron polyhedron;
  CgalNef solid;
  CGAL::Side_of_triangle_mesh<CgalPolyhedron, CgalKernel> side_of;
  std::vector<CgalTriangle> surface;
};

/// The deepest point lies in the part and is as deep as promised; the normal leads across, there.
std::string fault_of_deepest(const ContactRegion& region, const CgalPart& part, const CgalSide& a, const CgalSide& b) {
  const CgalPoint deepest = exact_point(region.deepest);
  const CgalNumber in_a = squared_distance_from(deepest, a.surface), in_b = squared_distance_from(deepest, b.surface),
                   in_part = squared_distance_from(deepest, part);
  const double rounding = near_enough * near_enough;
  if (!a.holds(deepest) && in_a > rounding) return "the deepest point is outside of A";
  if (!b.holds(deepest) && in_b > rounding) return "the deepest point is outside of B";
  // In both, the surface of what is in common is as near as the nearer of theirs.
  if (in_part != std::min(in_a, in_b) && in_part > rounding) return "the deepest point is in another part";
  if (!is_as_deep(in_a, in_b, region.depth->lower)) return "the deepest point is less deep than the lower bound";
  for (const Vec3& to_a : shortest_ways(deepest, in_a, a.surface))
    for (const Vec3& to_b : shortest_ways(deepest, in_b, b.surface)) {
      const Vec3 across = to_a - to_b, way = length_of(across) > near_enough ? across : to_a;
      if (length_of((1 / length_of(way)) * way - region.normal) < 1e-9 + near_enough / length_of(way)) return "";
    }
  return "the normal does not lead from B's nearest point to A's";
}

/// No point of the part is deeper than the upper bound: neither the deepest that was found, nor corners and middles of
/// its surface, nor points between two.
std::string fault_of_upper_bound(const ContactRegion& region, const CgalPart& part, const CgalSide& a,
                                 const CgalSide& b, Random& random) {
  constexpr int points = 30;
  const auto some_point = [&] {
    const CgalTriangle& t = part[random.below(part.size())];
    return random.below(2) == 0 ? t[0] : CGAL::centroid(t);
  };
  for (int i = 0; i < points; ++i) {
    const bool is_on_surface = i % 3 == 1;
    const CgalPoint p = i == 0          ? exact_point(region.deepest)
                        : is_on_surface ? some_point()
                                        : CGAL::midpoint(some_point(), some_point());
    if (!is_on_surface && !(a.holds(p) && b.holds(p))) continue;
    const CgalNumber upper = region.depth->upper + last_place;
    const CgalNumber in_a = squared_distance_from(p, a.surface), in_b = squared_distance_from(p, b.surface);
    if (is_as_deep(in_a, in_b, upper)) return "a common point is deeper than the upper bound";
  }
  return "";
}

/// B moved by less than the lower bound has a solid in common with A.
std::string fault_of_motion(const ContactRegion& region, const CgalSide& a, const CgalSide& b, Random& random) {
  const Vec3 any = random_vector(random, 1);
  const Vec3 way = random.below(2) == 0 ? region.normal : (1 / length_of(any)) * any;
  const CgalVector motion = exact_vector(0.999 * region.depth->lower * way);
  if (!(motion.squared_length() < CgalNumber(region.depth->lower) * region.depth->lower)) return "";
  CgalNef moved = b.solid;
  moved.transform(CGAL::Aff_transformation_3<CgalKernel>(CGAL::TRANSLATION, motion));
  return (a.solid * moved).interior().is_empty() ? "moved by less than the lower bound they are apart" : "";
}

std::string fault_of_region(const ContactRegion& region, const CgalPart& part, const CgalSide& a, const CgalSide& b,
                            Random& random) {
  const CgalVector along = exact_vector(region.normal);
  CgalNumber area = shadow_of(part, along);
  const auto is_other = [&] { return CGAL::to_double(CGAL::abs(area - region.area)) > 1e-12 * (1 + region.area); };
  if (is_other()) area += touching_shadow(a.surface, b.surface, along);
  if (is_other()) return fmt::format("area {}, CGAL {}", region.area, CGAL::to_double(CGAL::exact(area)));
  std::string fault = fault_of_deepest(region, part, a, b);
  if (fault.empty()) fault = fault_of_upper_bound(region, part, a, b, random);
  return fault;
}

std::string fault_of_regions_beside_cgal(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const TriangleMesh mesh_a = solid_for_cgal(family, random), mesh_b = solid_for_cgal(family, random);
  const PairQuery query{.pose_a = {some_turn(random), {}},
                        .pose_b = {some_turn(random), random.below(8) == 0 ? Vec3{} : random_vector(random, 0.8)}};
  std::vector<ContactRegion> regions = contact_regions(Model(mesh_a), Model(mesh_b), query);
  if (regions.empty()) return "";  // apart, or one within the other
  const CgalSide a(mesh_a, query.pose_a), b(mesh_b, query.pose_b);
  std::vector<CgalPart> parts = parts_of(a.solid * b.solid);
  std::erase_if(regions, [](const ContactRegion& region) { return region.depth->upper < near_enough; });  // they touch
  if (regions.size() != parts.size()) return fmt::format("{} regions, CGAL {}", regions.size(), parts.size());
  for (const ContactRegion& region : regions) {
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const CgalPart& one) { return is_around(region.box, one); });
    if (part == parts.end()) return "no part of CGAL's has the region's box";
    std::string fault = fault_of_region(region, *part, a, b, random);
    if (!fault.empty()) return fault;
  }
  return regions.empty() ? "" : fault_of_motion(regions[0], a, b, random);
}

SweepResult run_regions_beside_cgal(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases,
                   [&](std::uint64_t case_seed) { return fault_of_regions_beside_cgal(family, case_seed); });
}

const bool regions_cgal_known = register_sweep({"contact-regions-cgal",
                                                {"boxes", "spheres", "prisms", "tetrahedra", "l shapes", "mixed"},
                                                1000,
                                                5,
                                                run_regions_beside_cgal,
                                                50});

}  // namespace
}  // namespace toccata::test
