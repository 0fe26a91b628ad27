#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "math/exact.hpp"
#include "math/vec3_measures.hpp"
#include "query/contacts/self_intersection.hpp"
#include "query/inside/inside_winding.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/world_search.hpp"
#include "query/volume/winding_volume.hpp"
#include "shapes/union_find.hpp"
#include "toccata/bounds/volume.hpp"

// Where no triangle of a surface meets another but at what the two share, its winding numbers are the same all along
// each side of a connected piece of it: to ask beside one triangle of each piece is enough.
namespace toccata {
namespace {

/// One of these triangles meets another of the mesh, wherever that is.
bool intersects_itself(const PosedMesh& mesh, std::span<const Index> triangles, SearchScratch& scratch) {
  // The tree against itself takes for each of its triangles a thirtieth of what it takes to look for one alone.
  constexpr std::size_t share_for_all = 24;
  const bool are_many = triangles.size() > mesh.model().mesh().triangle_count() / share_for_all;
  if (are_many && !intersects_itself(mesh, scratch)) return false;
  for (const Index number : triangles) {
    const Triangle t = mesh.triangle(number);
    bool found = false;
    visit_triangles_near(mesh, box_of(t), [&](Index other) {
      if (other == number) return true;
      const Triangle u = mesh.triangle(other);
      found = self_meet(t, u) && has_area(u);
      return !found;
    });
    if (found) return true;
  }
  return false;
}

/// An edge of a triangle, which is told by its place in a list.
struct UsedEdge {
  std::array<Index, 2> ends{};
  Index place = 0;
  friend auto operator<=>(const UsedEdge&, const UsedEdge&) = default;
};

/// The triangles that hang together by edges in the region that two of them share. All that have an edge there are
/// among them.
UnionFind pieces_of(VertexGraph& graph, std::span<const Index> triangles, const Aabb& region) {
  std::vector<UsedEdge> edges;
  for (Index place = 0; place < triangles.size(); ++place) {
    const std::array<Index, 3> corners = graph.corners(triangles[place]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      const Vec3 &from = graph.position(low), &to = graph.position(high);
      if (contains(region, from) || contains(region, to)) edges.push_back({{low, high}, place});
    }
  }
  std::sort(edges.begin(), edges.end());
  UnionFind pieces(triangles.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].ends == edges[i].ends) ++end;
    if (end - i == 2) pieces.unite(edges[i].place, edges[i + 1].place);
    i = end;
  }
  return pieces;
}

int axis_most_along(const Vec3& normal) {
  const std::array<double, 3> sizes{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  return static_cast<int>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

/// A point in the triangle, exactly: `near` but for its coordinate along the axis. None where that is outside.
std::optional<RationalPoint> point_within(const Triangle& t, int axis, const Vec3& near) {
  const Sign turn = projected_orientation(t, axis);
  for (int i = 0; i < 3; ++i)
    if (orient2d(drop_axis(t[i], axis), drop_axis(t[(i + 1) % 3], axis), drop_axis(near, axis)) != turn) return {};
  if (turn == Sign::zero) return {};
  const RationalPoint origin = to_rational(t[0]);
  const RationalPoint normal = cross(to_rational(t[1]) - origin, to_rational(t[2]) - origin);
  const RationalPoint from = to_rational(near) - origin;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  RationalPoint point = to_rational(near);
  Rational& moved = axis == 0 ? point.x : axis == 1 ? point.y : point.z;
  moved = origin[axis] - (normal[i] * from[i] + normal[j] * from[j]) / normal[axis];
  return point;
}

Vec3 middle_of_triangle(const Triangle& t) { return (1.0 / 3) * t[0] + (1.0 / 3) * t[1] + (1.0 / 3) * t[2]; }

/// On both sides of the triangle, where it meets no other.
std::optional<LineWinding> windings_beside(const PosedMesh& mesh, const Triangle& t) {
  const int axis = axis_most_along(cross(t[1] - t[0], t[2] - t[0]));
  std::optional<RationalPoint> point = point_within(t, axis, middle_of_triangle(t));
  return point ? std::optional(wind_along(mesh, ExactPoint(std::move(*point)), axis)) : std::nullopt;
}

}  // namespace

std::optional<int> only_winding_in(const PosedMesh& mesh, const Aabb& region, SearchScratch& scratch) {
  const std::vector<Index> triangles = triangles_in_region(mesh, region);
  if (triangles.empty()) return wind_along(mesh, ExactPoint(region.lower), 0).ahead;
  if (intersects_itself(mesh, triangles, scratch)) return {};
  VertexGraph graph(mesh);
  UnionFind pieces = pieces_of(graph, triangles, region);
  std::vector<char> is_seen(triangles.size());
  int only = 0;
  for (Index place = 0; place < triangles.size(); ++place) {
    char& seen = is_seen[pieces.leader(place)];
    if (seen != 0) continue;
    const std::optional<LineWinding> windings = windings_beside(mesh, mesh.triangle(triangles[place]));
    if (!windings) continue;
    seen = 1;
    for (const int winding : {windings->ahead, windings->behind}) {
      if (winding == 0 || winding == only) continue;
      if (only != 0) return {};
      only = winding;
    }
    if (windings->ahead != 0 && windings->behind != 0) return {};
  }
  for (Index place = 0; place < triangles.size(); ++place)
    if (is_seen[pieces.leader(place)] == 0) return {};
  // Triangles are found by their boxes: where none of them reaches into the region, it lies beside none of them.
  const int here = wind_along(mesh, ExactPoint(region.lower), 0).ahead;
  if (here != 0 && only != 0 && here != only) return {};
  return here != 0 ? here : only;
}

bool has_inside_beside(const PosedMesh& mesh, Index triangle, const Vec3& point, double at_most) {
  const Triangle t = mesh.triangle(triangle);
  const int axis = axis_most_along(cross(t[1] - t[0], t[2] - t[0]));
  const Vec3 to_middle = middle_of_triangle(t) - point;
  const Vec3 near = point + std::min(0.5, at_most / 2 / plain_length(to_middle)) * to_middle;
  std::optional<RationalPoint> within = point_within(t, axis, near);
  if (!within || !(std::abs(nearest_double((*within)[axis]) - near[axis]) < at_most / 2)) return false;
  const LineWinding windings = wind_along(mesh, ExactPoint(std::move(*within)), axis);
  return windings.ahead != 0 || windings.behind != 0;
}

}  // namespace toccata
