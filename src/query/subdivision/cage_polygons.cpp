#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/no_index.hpp"
#include "math/vec3_measures.hpp"
#include "query/subdivision/level_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

using MeshSide = std::pair<Index, Index>;

/// The first of the vertices of the same coordinates, of each that a triangle names; of others no_index.
std::vector<Index> first_of_place(const TriangleMesh& mesh) {
  const std::span<const Vec3> v = mesh.vertices();
  std::vector<char> is_used(v.size(), 0);
  for (const std::array<Index, 3>& triangle : mesh.triangles())
    for (const Index corner : triangle) is_used[corner] = 1;
  std::vector<Index> order;
  for (Index i = 0; i < v.size(); ++i)
    if (is_used[i]) order.push_back(i);
  const auto place = [&](Index i) { return std::array{v[i].x, v[i].y, v[i].z}; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  std::vector<Index> first(v.size(), no_index);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// The border of a face: the sides of its triangles that none of them has the other way round, in its direction.
std::vector<MeshSide> border_of(std::span<const std::array<Index, 3>> triangles) {
  std::vector<MeshSide> sides, border;
  for (const std::array<Index, 3>& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) sides.emplace_back(t[i], t[(i + 1) % 3]);
  std::sort(sides.begin(), sides.end());
  for (const MeshSide& side : sides)
    if (!std::binary_search(sides.begin(), sides.end(), MeshSide{side.second, side.first})) border.push_back(side);
  return border;
}

/// Adds the corners around a face. One that was cut into n triangles has n + 2 of them, else it is no polygon.
void add_polygon(std::span<const std::array<Index, 3>> triangles, Index face, PolygonMesh& polygons) {
  const std::vector<MeshSide> border = border_of(triangles);
  const std::size_t begin = polygons.corners.size();
  Index corner = border.empty() ? no_index : triangles[0][0];
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto side = std::lower_bound(border.begin(), border.end(), MeshSide{corner, 0});
    if (side == border.end() || side->first != corner) break;
    polygons.corners.push_back(corner);
    corner = side->second;
  }
  if (polygons.corners.size() - begin != triangles.size() + 2 || corner != triangles[0][0])
    throw Error("face " + std::to_string(face) + " of the mesh is no polygon without holes: a cage needs such faces");
  polygons.first.push_back(static_cast<Index>(polygons.corners.size()));
}

/// Twice the area of the face as a vector (M. E. Newell), of a size that squares do not overflow.
Vec3 face_direction(const LevelMesh& mesh, Index face) {
  const std::span<const Index> c = mesh.face(face);
  Vec3 sum{};
  for (std::size_t i = 2; i < c.size(); ++i)
    sum += cross(mesh.points[c[i - 1]] - mesh.points[c[0]], mesh.points[c[i]] - mesh.points[c[0]]);
  return unit_or_zero(sum);
}

}  // namespace

CagePolygons cage_polygons(const TriangleMesh& mesh) {
  const std::vector<Index> first = first_of_place(mesh);
  CagePolygons cage{{}, std::vector<Index>(first.size(), no_index)};
  for (Index i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      cage.vertex_of[i] = static_cast<Index>(cage.polygons.vertices.size());
      cage.polygons.vertices.push_back(mesh.vertices()[i]);
    }
  }
  for (Index i = 0; i < first.size(); ++i)
    if (first[i] != no_index) cage.vertex_of[i] = cage.vertex_of[first[i]];

  std::vector<Index> order(mesh.triangle_count());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return mesh.face_of(a) < mesh.face_of(b); });
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::array<Index, 3> corners = mesh.triangles()[order[i]];
    for (Index& corner : corners) corner = cage.vertex_of[corner];
    triangles.push_back(corners);
    const Index face = mesh.face_of(order[i]);
    if (i + 1 < order.size() && mesh.face_of(order[i + 1]) == face) continue;
    add_polygon(triangles, face, cage.polygons);
    triangles.clear();
  }
  return cage;
}

std::vector<CageCrease> creases_by_angle(const PolygonMesh& polygons, double degrees) {
  if (!(degrees >= 0 && degrees <= 180)) throw Error("the angle of creases must be 0 … 180 degrees");
  const LevelMesh mesh = cage_level(SubdivisionCage(polygons, SubdivisionScheme::catmull_clark));
  std::vector<Vec3> directions;
  for (Index f = 0; f < mesh.face_count(); ++f) directions.push_back(face_direction(mesh, f));
  const double least = sine_cosine_of_turns(degrees / 360).cosine;
  std::vector<CageCrease> creases;
  for (const LevelEdge& edge : mesh.edges) {
    if (edge.sides[1] == no_index) continue;
    const Vec3 &a = directions[mesh.face_of_side[edge.sides[0]]], &b = directions[mesh.face_of_side[edge.sides[1]]];
    if (dot(a, b) < least) creases.push_back({edge.ends[0], edge.ends[1]});
  }
  return creases;
}

}  // namespace toccata
