#include "oracle/meshes.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace toccata::oracle {
namespace {

using FilePoint = std::tuple<double, double, double>;

// Doubles compare by value, so −0 is 0 here.
FilePoint file_point(const Vec3& v) { return {v.x, v.y, v.z}; }

MeshSet world_triangles(const TriangleMesh& mesh, const Pose& pose) {
  if (!is_finite(pose.linear) || !is_finite(pose.offset)) throw std::invalid_argument("the pose is not finite");
  std::vector<RationalPoint> world;
  for (const Vec3& local : mesh.vertices()) {
    const Vec3 vertex = world_vertex(pose, local);
    if (!is_finite(vertex)) throw std::invalid_argument("a world vertex is not finite");
    world.push_back(exact(vertex));
  }
  MeshSet result;
  for (const auto& [i, j, k] : mesh.triangles()) result.triangles.push_back({{world[i], world[j], world[k]}});
  return result;
}

/// How a line p + t · direction, t > 0, passes a triangle that does not contain p.
enum class Passing { misses, doubtful, upwards, downwards };

Passing passing(const RationalPoint& p, const RationalPoint& direction, const RationalTriangle& triangle) {
  const auto& v = triangle.vertex;
  int least = 1;
  int greatest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const int turn = dot(direction, cross(v[i] - p, v[(i + 1) % 3] - p)).sign();
    least = std::min(least, turn);
    greatest = std::max(greatest, turn);
    if (least < 0 && greatest > 0) return Passing::misses;
  }
  const RationalPoint up = normal(triangle);
  // Without area it bounds nothing.
  if (is_zero(up)) return Passing::misses;
  if (least == 0 || greatest == 0) return Passing::doubtful;
  const int slope = dot(up, direction).sign();
  if (slope * dot(up, v[0] - p).sign() < 0) return Passing::misses;
  return slope > 0 ? Passing::upwards : Passing::downwards;
}

/// Points of the moment curve. A plane through the origin holds at most two, so only finitely many of them can hit an
/// edge or lie in the plane of a triangle, and the search for one that does not comes to an end.
RationalPoint direction_of(long long k) { return {1, k, k * k}; }

/// The winding number just beyond p in any direction whose product with `towards` is positive; triangles through p must
/// be perpendicular to `towards`. With `towards` 0, p must be on no triangle and every direction will do.
int winding_number(const RationalPoint& p, const RationalPoint& towards, const MeshSet& mesh) {
  for (long long k = 2;; ++k) {
    RationalPoint direction = direction_of(k);
    if (!is_zero(towards)) {
      const int sign = dot(direction, towards).sign();
      if (sign == 0) continue;
      direction = Rational(sign) * direction;
    }
    int winding = 0;
    bool doubtful = false;
    for (const RationalTriangle& triangle : mesh.triangles) {
      if (!is_zero(towards) && contains(triangle, p)) continue;
      const Passing how = passing(p, direction, triangle);
      doubtful = doubtful || how == Passing::doubtful;
      winding += how == Passing::upwards ? 1 : how == Passing::downwards ? -1 : 0;
    }
    if (!doubtful) return winding;
  }
}

bool is_on_a_face(const RationalPoint& p, const MeshSet& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const RationalTriangle& t) { return contains(t, p); });
}

bool is_outside(const Location& location) { return !location.on_face && location.winding_number == 0; }
bool is_interior(const Location& location) { return !location.on_face && location.winding_number != 0; }

/// Some vertex of `a` belongs to the solid `b`.
bool some_vertex_in(const MeshSet& a, const MeshSet& b) {
  for (const RationalTriangle& triangle : a.triangles)
    for (const RationalPoint& vertex : triangle.vertex)
      if (!is_outside(locate(vertex, b))) return true;
  return false;
}

/// The planes along which `cutter` divides `triangle`: no open cell between them is partly in and partly out of it.
std::vector<HalfSpace> dividing_planes(const RationalTriangle& triangle, const RationalTriangle& cutter) {
  if (!boxes_overlap(triangle, cutter)) return {};
  const CommonSet common = common_set(triangle, cutter);
  const bool reaches_the_inside =
      common.kind != CommonSetKind::none && contains_in_relative_interior(triangle, centroid(common.extreme_points));
  if (!reaches_the_inside) return {};
  const Bounding bounds = bounding(cutter);
  // Off a plane that contains the cutter a cell is off the cutter.
  for (const HalfSpace& plane : bounds.containing)
    for (const RationalPoint& vertex : triangle.vertex)
      if (!height_above(plane, vertex).is_zero()) return {plane};
  return bounds.sides;
}

using Cell = std::vector<RationalPoint>;

/// Cuts each cell in two where the plane passes through its relative interior.
std::vector<Cell> divided(const std::vector<Cell>& cells, const HalfSpace& plane) {
  std::vector<Cell> result;
  for (const Cell& cell : cells) {
    const auto on_side = [&](int side) {
      return std::ranges::any_of(cell, [&](const RationalPoint& p) { return height_above(plane, p).sign() == side; });
    };
    if (on_side(-1) && on_side(1)) {
      result.push_back(clipped(cell, plane));
      result.push_back(clipped(cell, {-plane.normal, -plane.offset}));
    } else {
      result.push_back(cell);
    }
  }
  return result;
}

/// One point in each of the open cells into which the cutters divide a triangle. Every open cell is wholly on or wholly
/// off each cutter.
std::vector<RationalPoint> points_of_cells(const RationalTriangle& triangle, std::initializer_list<const MeshSet*> by) {
  std::vector<Cell> cells{extreme_points(triangle)};
  for (const MeshSet* cutters : by)
    for (const RationalTriangle& cutter : cutters->triangles)
      for (const HalfSpace& plane : dividing_planes(triangle, cutter)) cells = divided(cells, plane);
  std::vector<RationalPoint> points;
  for (const Cell& cell : cells) points.push_back(centroid(cell));
  return points;
}

/// Which of the open regions there are that the faces of two solids leave of space.
struct Regions {
  bool both = false;
  bool only_a = false;
  bool only_b = false;
};

/// Every region within a solid is bounded, and so has a cell of some face on its boundary: the regions on both sides of
/// every cell are all there are.
Regions regions(const MeshSet& a, const MeshSet& b) {
  Regions found;
  for (const MeshSet* mesh : {&a, &b})
    for (const RationalTriangle& triangle : mesh->triangles) {
      const RationalPoint up = normal(triangle);
      if (is_zero(up)) continue;
      for (const RationalPoint& p : points_of_cells(triangle, {&a, &b}))
        for (const RationalPoint& towards : {up, -up}) {
          const bool in_a = winding_number(p, towards, a) != 0;
          const bool in_b = winding_number(p, towards, b) != 0;
          found.both = found.both || (in_a && in_b);
          found.only_a = found.only_a || (in_a && !in_b);
          found.only_b = found.only_b || (in_b && !in_a);
          if (found.both && found.only_a && found.only_b) return found;
        }
    }
  return found;
}

Relation relation_of_solids(const MeshSet& a, const MeshSet& b) {
  if (!overlap(a, b)) return {};
  const Regions found = regions(a, b);
  if (!found.both) return {RelationKind::touching};
  if (found.only_a && found.only_b) return {RelationKind::overlapping};
  if (found.only_a) return {RelationKind::overlapping, Containment::b_in_a};
  return {RelationKind::overlapping, found.only_b ? Containment::a_in_b : Containment::equal};
}

Relation relation_of_surfaces(const MeshSet& a, const MeshSet& b) {
  if (!overlap(a, b)) return {};
  if (surfaces_cross(a, b)) return {RelationKind::crossing};
  return {RelationKind::touching, Containment::none, true};
}

/// The vertices of s that are vertices of t.
std::vector<RationalPoint> shared_vertices(const RationalTriangle& s, const RationalTriangle& t) {
  std::vector<RationalPoint> shared;
  for (const RationalPoint& p : s.vertex)
    if (std::ranges::find(t.vertex, p) != t.vertex.end()) shared.push_back(p);
  return shared;
}

std::vector<RationalPoint> sorted(std::vector<RationalPoint> points) {
  std::ranges::sort(points, [](const RationalPoint& p, const RationalPoint& q) { return p < q; });
  return points;
}

bool meet_beyond_shared(const RationalTriangle& s, const RationalTriangle& t) {
  std::vector<RationalPoint> shared = shared_vertices(s, t);
  if (shared.size() == 3 && shared_vertices(t, s).size() == 3) return true;
  if (shared.empty()) return overlap(s, t);
  const CommonSet common = common_set(s, t);
  shared.resize(3, shared.front());
  return sorted(common.extreme_points) != sorted(extreme_points({{shared[0], shared[1], shared[2]}}));
}

/// The interior is open, so a triangle that meets it does so in a whole open cell.
bool meets_interior(const MeshSet& surface, const MeshSet& solid) {
  for (const RationalTriangle& triangle : surface.triangles)
    for (const RationalPoint& p : points_of_cells(triangle, {&solid}))
      if (is_interior(locate(p, solid))) return true;
  return false;
}

/// Off the faces of the solid the surface leaves neither the interior nor the outside, so its vertices tell for all.
bool is_inside(const MeshSet& surface, const MeshSet& solid) {
  if (!intersecting_pairs(surface, solid).empty()) return false;
  for (const RationalTriangle& triangle : surface.triangles)
    for (const RationalPoint& vertex : triangle.vertex)
      if (!is_interior(locate(vertex, solid))) return false;
  return true;
}

Relation relation_of_surface_and_solid(const MeshSet& surface, const MeshSet& solid) {
  if (!overlap(surface, solid)) return {};
  if (!meets_interior(surface, solid)) return {RelationKind::touching};
  return {RelationKind::crossing, is_inside(surface, solid) ? Containment::a_in_b : Containment::none};
}

}  // namespace

bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<FilePoint, FilePoint>, long long> balance;
  for (const auto& corners : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      const FilePoint from = file_point(mesh.vertices()[corners[i]]);
      const FilePoint to = file_point(mesh.vertices()[corners[(i + 1) % 3]]);
      ++balance[{from, to}];
      --balance[{to, from}];
    }
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

MeshSet surface_set(const TriangleMesh& mesh, const Pose& pose) { return world_triangles(mesh, pose); }

MeshSet solid_set(const TriangleMesh& mesh, const Pose& pose) {
  if (!is_closed(mesh)) throw std::invalid_argument("an open mesh has no inside");
  MeshSet result = world_triangles(mesh, pose);
  if (is_singular(pose)) throw std::invalid_argument("a solid needs a pose that is not singular");
  result.solid = true;
  return result;
}

MeshSet height_field_set(std::span<const Vec3> vertices, std::size_t columns, std::size_t rows) {
  if (vertices.size() != columns * rows) throw std::invalid_argument("a height field has columns × rows vertices");
  const auto at = [&](std::size_t i, std::size_t j) { return exact(vertices[j * columns + i]); };
  MeshSet result;
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      result.triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      result.triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  return result;
}

std::vector<TrianglePair> intersecting_pairs(const MeshSet& a, const MeshSet& b) {
  std::vector<TrianglePair> result;
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
    for (std::size_t j = 0; j < b.triangles.size(); ++j)
      if (overlap(a.triangles[i], b.triangles[j])) result.push_back({i, j});
  return result;
}

std::optional<TrianglePair> first_intersecting_pair(const MeshSet& a, const MeshSet& b) {
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
    for (std::size_t j = 0; j < b.triangles.size(); ++j)
      if (overlap(a.triangles[i], b.triangles[j])) return TrianglePair{i, j};
  return std::nullopt;
}

std::vector<TrianglePair> self_intersecting_pairs(const MeshSet& mesh) {
  std::vector<TrianglePair> result;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j)
      if (meet_beyond_shared(mesh.triangles[i], mesh.triangles[j])) result.push_back({i, j});
  return result;
}

bool surfaces_cross(const MeshSet& a, const MeshSet& b) {
  for (const RationalTriangle& s : a.triangles)
    for (const RationalTriangle& t : b.triangles)
      if (boxes_overlap(s, t) && common_set(s, t).crossing) return true;
  return false;
}

Location locate(const RationalPoint& p, const MeshSet& closed) {
  if (is_on_a_face(p, closed)) return {true, 0};
  return {false, winding_number(p, {}, closed)};
}

// When no faces meet, a common point lies in the interior of one of the sets, and then so does a whole triangle of the
// other, or the common part would have no boundary.
bool overlap(const MeshSet& a, const MeshSet& b) {
  if (first_intersecting_pair(a, b)) return true;
  return (b.solid && some_vertex_in(a, b)) || (a.solid && some_vertex_in(b, a));
}

Relation relation(const MeshSet& a, const MeshSet& b) {
  if (a.solid && b.solid) return relation_of_solids(a, b);
  if (a.solid) return flipped(relation_of_surface_and_solid(b, a));
  return b.solid ? relation_of_surface_and_solid(a, b) : relation_of_surfaces(a, b);
}

Rational squared_distance(const MeshSet& a, const MeshSet& b) {
  if (overlap(a, b)) return 0;
  const auto hull = [](const RationalTriangle& t) { return ConvexSet{{t.vertex.begin(), t.vertex.end()}, 0}; };
  Rational least = squared_distance(hull(a.triangles[0]), hull(b.triangles[0]));
  for (const RationalTriangle& s : a.triangles)
    for (const RationalTriangle& t : b.triangles) least = std::min<Rational>(least, squared_distance(hull(s), hull(t)));
  return least;
}

}  // namespace toccata::oracle
