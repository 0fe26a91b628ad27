#include "query/subdivision/level_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/vec3_measures.hpp"

namespace toccata {

Index LevelMesh::side_between(Index from, Index to) const {
  const std::span<const Index> sides = sides_at(from);
  const auto found = std::lower_bound(sides.begin(), sides.end(), to,
                                      [this](Index side, Index vertex) { return end_of(side) < vertex; });
  return found != sides.end() && end_of(*found) == to ? *found : no_index;
}

Index LevelMesh::edge_between(Index a, Index b) const {
  const Index side = side_between(a, b);
  if (side != no_index) return edge_of_side[side];
  const Index other = side_between(b, a);
  return other == no_index ? no_index : edge_of_side[other];
}

void LevelMesh::connect() {
  face_of_side.resize(corners.size());
  for (Index f = 0; f < face_count(); ++f)
    std::fill(face_of_side.begin() + first_side[f], face_of_side.begin() + first_side[f + 1], f);

  first_of_vertex.assign(points.size() + 1, 0);
  for (const Index corner : corners) ++first_of_vertex[corner + 1];
  std::partial_sum(first_of_vertex.begin(), first_of_vertex.end(), first_of_vertex.begin());
  sides_of_vertex.resize(corners.size());
  std::vector<Index> filled(first_of_vertex.begin(), first_of_vertex.end() - 1);
  for (Index side = 0; side < corners.size(); ++side) sides_of_vertex[filled[corners[side]]++] = side;
  for (std::size_t v = 0; v < points.size(); ++v)
    std::sort(sides_of_vertex.begin() + first_of_vertex[v], sides_of_vertex.begin() + first_of_vertex[v + 1],
              [this](Index a, Index b) { return end_of(a) < end_of(b); });

  edges.clear();
  edge_of_side.assign(corners.size(), no_index);
  for (Index side = 0; side < corners.size(); ++side) {
    if (edge_of_side[side] != no_index) continue;
    const Index other = side_between(end_of(side), corners[side]);
    edge_of_side[side] = static_cast<Index>(edges.size());
    if (other != no_index) edge_of_side[other] = edge_of_side[side];
    edges.push_back({{corners[side], end_of(side)}, {side, other}, 0});
  }
}

void Spokes::gather(const LevelMesh& mesh, Index vertex) {
  edges.clear();
  ends.clear();
  sharpness.clear();
  const auto add = [&](Index edge) {
    const LevelEdge& spoke = mesh.edges[edge];
    edges.push_back(edge);
    ends.push_back(spoke.ends[0] == vertex ? spoke.ends[1] : spoke.ends[0]);
    sharpness.push_back(spoke.sharpness);
  };
  for (const Index side : mesh.sides_at(vertex)) {
    add(mesh.edge_of_side[side]);
    const Index before = mesh.previous(side);
    if (mesh.twin(before) == no_index) add(mesh.edge_of_side[before]);
  }
}

LevelMesh cage_level(const SubdivisionCage& cage) {
  const PolygonMesh& polygons = cage.polygons();
  LevelMesh mesh;
  mesh.scheme = cage.scheme();
  mesh.points = polygons.vertices;
  mesh.corners = polygons.corners;
  mesh.first_side = polygons.first;
  mesh.cage_face.resize(mesh.face_count());
  std::iota(mesh.cage_face.begin(), mesh.cage_face.end(), Index{0});
  mesh.whole.assign(mesh.face_count(), 1);
  mesh.connect();
  for (const Vec3& point : mesh.points)
    mesh.largest_coordinate = std::max(mesh.largest_coordinate, largest_magnitude(point));

  for (LevelEdge& edge : mesh.edges)
    if (edge.sides[1] == no_index) edge.sharpness = std::numeric_limits<double>::infinity();
  for (const CageCrease& crease : cage.features().creases) {
    double& sharpness = mesh.edges[mesh.edge_between(crease.first, crease.second)].sharpness;
    sharpness = std::max(sharpness, crease.sharpness);
  }
  mesh.vertex_sharpness.assign(mesh.points.size(), 0);
  for (const CageCorner& corner : cage.features().corners)
    mesh.vertex_sharpness[corner.vertex] = std::max(mesh.vertex_sharpness[corner.vertex], corner.sharpness);
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const std::span<const Index> sides = mesh.sides_at(v);
    const bool is_in_a_corner = sides.size() == 1;
    if (is_in_a_corner && cage.features().border == CageBorder::sharp_corner)
      mesh.vertex_sharpness[v] = std::numeric_limits<double>::infinity();
    mesh.most_neighbours = std::max(mesh.most_neighbours, static_cast<Index>(sides.size()) + 1);
  }
  for (Index f = 0; f < mesh.face_count(); ++f)
    mesh.most_neighbours = std::max(mesh.most_neighbours, mesh.corner_count(f));
  return mesh;
}

LevelMesh first_level(const SubdivisionCage& cage) {
  LevelMesh mesh = cage_level(cage);
  if (mesh.scheme == SubdivisionScheme::loop) return mesh;
  return subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
}

}  // namespace toccata
