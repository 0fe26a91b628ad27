#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/no_index.hpp"
#include "math/vec3_measures.hpp"
#include "query/subdivision/cage_checks.hpp"
#include "shapes/union_find.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

using MeshSide = std::pair<Index, Index>;

/// The first of the vertices of the same coordinates.
std::vector<Index> first_of_place(const TriangleMesh& mesh) {
  const std::span<const Vec3> v = mesh.vertices();
  std::vector<Index> order(v.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto place = [&](Index i) { return std::array{v[i].x, v[i].y, v[i].z}; };
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  std::vector<Index> first(v.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// A side of a face that no other face shares, and where it is, whichever way it goes.
struct OpenSide {
  std::array<Index, 2> place;
  std::array<Index, 2> ends;  ///< in the order of the places
};

std::vector<OpenSide> open_sides(const PolygonMesh& faces, const std::vector<Index>& place) {
  std::vector<std::array<Index, 2>> sides;
  for (std::size_t f = 0; f + 1 < faces.first.size(); ++f)
    for (Index i = faces.first[f]; i < faces.first[f + 1]; ++i) {
      const Index a = faces.corners[i], b = faces.corners[i + 1 == faces.first[f + 1] ? faces.first[f] : i + 1];
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<OpenSide> open;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool is_shared = (i > 0 && sides[i - 1] == sides[i]) || (i + 1 < sides.size() && sides[i + 1] == sides[i]);
    if (is_shared) continue;
    auto [a, b] = sides[i];
    if (place[a] > place[b]) std::swap(a, b);
    open.push_back({{place[a], place[b]}, {a, b}});
  }
  return open;
}

/// The vertices that open sides at the same place have: these are seams, or all sides where every face has vertices of
/// its own. Faces that touch in a vertex only, and closed parts that touch, are joined no more than the mesh has them.
UnionFind vertices_at_seams(const TriangleMesh& mesh, const PolygonMesh& faces) {
  UnionFind vertices(mesh.vertices().size());
  std::vector<OpenSide> open = open_sides(faces, first_of_place(mesh));
  std::sort(open.begin(), open.end(), [](const OpenSide& a, const OpenSide& b) { return a.place < b.place; });
  for (std::size_t i = 1; i < open.size(); ++i)
    for (std::size_t end = 0; end < 2 && open[i].place == open[i - 1].place; ++end)
      vertices.unite(open[i - 1].ends[end], open[i].ends[end]);
  return vertices;
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

/// The polygons of the mesh's faces, by the numbers of its vertices, which are still to be added.
PolygonMesh polygons_of_mesh(const TriangleMesh& mesh) {
  PolygonMesh polygons{{}, {}, {0}};
  std::vector<Index> order(mesh.triangle_count());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return mesh.face_of(a) < mesh.face_of(b); });
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t i = 0; i < order.size(); ++i) {
    triangles.push_back(mesh.triangles()[order[i]]);
    const Index face = mesh.face_of(order[i]);
    if (i + 1 < order.size() && mesh.face_of(order[i + 1]) == face) continue;
    add_polygon(triangles, face, polygons);
    triangles.clear();
  }
  return polygons;
}

Index cage_vertex(const CagePolygons& cage, Index of_mesh) {
  const std::vector<Index>& vertex_of = cage.vertex_of;
  if (of_mesh >= vertex_of.size())
    throw Error(fmt::format("a crease or corner names vertex {}, but there are {} vertices, counted from 0", of_mesh,
                            vertex_of.size()));
  if (vertex_of[of_mesh] == no_index)
    throw Error(fmt::format("a crease or corner names vertex {}, but no face has it", of_mesh));
  return vertex_of[of_mesh];
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
  CagePolygons cage{polygons_of_mesh(mesh), std::vector<Index>(mesh.vertices().size(), no_index)};
  UnionFind vertices = vertices_at_seams(mesh, cage.polygons);
  std::vector<char> is_used(mesh.vertices().size(), 0);
  for (const Index corner : cage.polygons.corners) is_used[corner] = is_used[vertices.leader(corner)] = 1;
  for (Index i = 0; i < is_used.size(); ++i) {
    if (!is_used[i]) continue;
    const Index first = vertices.leader(i);
    if (first == i) {
      cage.vertex_of[i] = static_cast<Index>(cage.polygons.vertices.size());
      cage.polygons.vertices.push_back(mesh.vertices()[i]);
    }
    cage.vertex_of[i] = cage.vertex_of[first];
  }
  for (Index& corner : cage.polygons.corners) corner = cage.vertex_of[corner];
  return cage;
}

SubdivisionCage SubdivisionCage::of_mesh(const TriangleMesh& mesh, SubdivisionScheme scheme, CageFeatures features) {
  CagePolygons cage = cage_polygons(mesh);
  for (CageCrease& crease : features.creases) {
    crease.first = cage_vertex(cage, crease.first);
    crease.second = cage_vertex(cage, crease.second);
  }
  for (CageCorner& corner : features.corners) corner.vertex = cage_vertex(cage, corner.vertex);
  std::vector<Index> vertices(cage.polygons.vertices.size()), faces;
  for (Index i = static_cast<Index>(cage.vertex_of.size()); i-- > 0;)
    if (cage.vertex_of[i] != no_index) vertices[cage.vertex_of[i]] = i;
  for (Index t = 0; t < mesh.triangle_count(); ++t) faces.push_back(mesh.face_of(t));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  (void)checked_level(cage.polygons, scheme, features, {cage.polygons.vertices, vertices, faces});
  return {std::move(cage.polygons), scheme, std::move(features)};
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
    const Index side = edge.sides[0];  // of the polygons, too, of which vertices may have been parted
    if (dot(a, b) < least) creases.push_back({polygons.corners[side], polygons.corners[mesh.next(side)]});
  }
  return creases;
}

}  // namespace toccata
