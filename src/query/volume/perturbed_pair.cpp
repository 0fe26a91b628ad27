#include "query/volume/perturbed_pair.hpp"

#include <algorithm>
#include <tuple>

#include "math/constants.hpp"
#include "query/inside/inside_point.hpp"
#include "query/meshes/world_search.hpp"
#include "shapes/union_find.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

/// The sign of the product of the triangle's normal with the way of the first solid.
Sign side_of_way(const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign sign = projected_orientation(t, axis); sign != Sign::zero) return sign;
  return Sign::zero;
}

/// On which side of the triangle's plane each vertex lies; `way` is the sign with which the way of the first counts.
std::array<Sign, 3> perturbed_sides(const Triangle& plane, const Triangle& t, Sign way) {
  std::array<Sign, 3> sides{};
  for (int i = 0; i < 3; ++i) {
    Sign& side = sides[static_cast<std::size_t>(i)];
    side = orient3d(plane[0], plane[1], plane[2], t[i]);
    if (side == Sign::zero) side = side_of_way(plane) * way;
  }
  return sides;
}

/// orient3d of an edge of the first and one of the second. The edges are not parallel.
Sign perturbed_turn(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Sign turn = orient3d(a0, a1, b0, b1);
  if (turn != Sign::zero) return turn;
  constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const Vec3& axis : axes)
    if (const Sign sign = triple_product_sign({a1, a0}, {b1, b0}, {axis, {}}); sign != Sign::zero) return sign;
  return Sign::zero;
}

/// How one edge passes, as in EdgesThrough, by the sides of its ends and its turns with the other's edges.
int passes(Sign from, Sign to, const std::array<Sign, 3>& turns) {
  if (turns[0] != turns[1] || turns[1] != turns[2]) return 0;
  return from == Sign::positive && to == Sign::negative ? 1 : -1;
}

/// Where the point of the given side is, moved, beside the projected edge a → b: the sign of the first that is not 0
/// of its exact side and of the sides to which (ε, 0) and (0, ε²) lead.
Sign moved_side_of_edge(const Vec3& a, const Vec3& b, const Vec3& p, Sign way) {
  const Vec2 a2 = drop_axis(a, 0), b2 = drop_axis(b, 0);
  const Sign side = orient2d(a2, b2, drop_axis(p, 0));
  if (side != Sign::zero) return side;
  if (a2.y != b2.y) return a2.y > b2.y ? way : -way;
  if (a2.x != b2.x) return b2.x > a2.x ? way : -way;
  return Sign::zero;
}

/// The orientation of the triangle seen along x if the moved point is over it, else zero.
Sign cover_of(const Triangle& t, const Vec3& p, Sign way) {
  const Sign first = moved_side_of_edge(t[0], t[1], p, way);
  if (first == Sign::zero) return Sign::zero;
  for (int i = 1; i < 3; ++i)
    if (moved_side_of_edge(t[i], t[(i + 1) % 3], p, way) != first) return Sign::zero;
  return first;
}

}  // namespace

bool EdgesThrough::any() const {
  const auto passes_one = [](int through) { return through != 0; };
  return std::any_of(of_first.begin(), of_first.end(), passes_one) ||
         std::any_of(of_second.begin(), of_second.end(), passes_one);
}

bool comes_first(const PosedMesh& a, const PosedMesh& b) {
  const auto key = [](const PosedMesh& mesh) {
    const Aabb& box = mesh.box();
    const Triangle t = mesh.triangle(0);
    return std::tuple(box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z,
                      mesh.model().mesh().triangle_count(), t[0].x, t[0].y, t[0].z, t[1].x, t[1].y, t[1].z);
  };
  if (key(a) != key(b)) return key(a) < key(b);
  for (Index i = 0; i < a.model().mesh().triangle_count(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3 p = a.triangle(i)[corner], q = b.triangle(i)[corner];
      if (!(p == q)) return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    }
  return true;
}

EdgesThrough perturbed_edges_through(const Triangle& first, const Triangle& second) {
  EdgesThrough through;
  const std::array<Sign, 3> of_first = perturbed_sides(second, first, Sign::positive),
                            of_second = perturbed_sides(first, second, Sign::negative);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const auto corner = [](std::size_t k) { return static_cast<int>(k); };
    if (of_first[i] != of_first[next]) {
      std::array<Sign, 3> turns{};
      for (std::size_t j = 0; j < 3; ++j)
        turns[j] =
            perturbed_turn(first[corner(i)], first[corner(next)], second[corner(j)], second[corner((j + 1) % 3)]);
      through.of_first[i] = passes(of_first[i], of_first[next], turns);
    }
    if (of_second[i] != of_second[next]) {
      std::array<Sign, 3> turns{};
      for (std::size_t j = 0; j < 3; ++j)
        turns[j] =
            perturbed_turn(first[corner(j)], first[corner((j + 1) % 3)], second[corner(i)], second[corner(next)]);
      through.of_second[i] = passes(of_second[i], of_second[next], turns);
    }
  }
  return through;
}

void CrossingCurves::add(VertexGraph& first, Index of_first, VertexGraph& second, Index of_second,
                         const EdgesThrough& through) {
  std::vector<Index> ends;
  const auto see = [&](VolumeSide side, VertexGraph& graph, Index triangle, Index passed, const auto& passes_edge) {
    const std::array<Index, 3> corners = graph.corners(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (passes_edge[i] == 0) continue;
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      ends.push_back(end_at({side, {low, high}, passed}));
    }
  };
  see(VolumeSide::first, first, of_first, of_second, through.of_first);
  see(VolumeSide::second, second, of_second, of_first, through.of_second);
  for (std::size_t i = 1; i < ends.size(); ++i) segments_.emplace_back(ends[i - 1], ends[i]);
}

Index CrossingCurves::end_at(const EdgePass& pass) {
  return ends_.emplace(pass, static_cast<Index>(ends_.size())).first->second;
}

std::size_t CrossingCurves::count() const {
  UnionFind joined(ends_.size());
  for (const auto& [from, to] : segments_) joined.unite(from, to);
  std::size_t count = 0;
  for (Index i = 0; i < ends_.size(); ++i) count += joined.leader(i) == i ? 1U : 0U;
  return count;
}

int perturbed_winding(const Vec3& point, VolumeSide side, const PosedMesh& mesh) {
  if (!contains(mesh.box(), {point, point})) return 0;
  const Sign way = side == VolumeSide::first ? Sign::positive : Sign::negative;
  int winding = 0;
  visit_triangles_near(mesh, {point, {infinity, point.y, point.z}}, [&](Index number) {
    const Triangle t = mesh.triangle(number);
    const Sign orientation = cover_of(t, point, way);
    if (orientation == Sign::zero) return true;
    Sign above = orient3d(t[0], t[1], t[2], point) * orientation;
    if (above == Sign::zero) above = way;
    if (above == Sign::negative) winding += static_cast<int>(orientation);
    return true;
  });
  return winding;
}

}  // namespace toccata
