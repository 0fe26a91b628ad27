#include <algorithm>
#include <set>
#include <utility>

#include "query/subdivision/cage_checks.hpp"

namespace toccata {
namespace {

/// How many faces one passes who goes around the vertex, from the border if there is one.
std::size_t faces_around(const LevelMesh& mesh, Index vertex) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  Index begin = sides.front();
  for (const Index side : sides)
    if (mesh.twin(side) == no_index) begin = side;
  std::size_t count = 0;
  Index side = begin;
  do {
    ++count;
    side = mesh.twin(mesh.previous(side));
  } while (side != no_index && side != begin && count <= sides.size());
  return count;
}

/// Those of the sides that begin at the vertex which belong to faces that are connected with the face of `first` by
/// edges there.
std::set<Index> sides_around(const LevelMesh& mesh, Index first) {
  std::set<Index> found{first};
  std::vector<Index> waiting{first};
  const auto see = [&](Index side) {
    if (side != no_index && found.insert(side).second) waiting.push_back(side);
  };
  while (!waiting.empty()) {
    const Index side = waiting.back();
    waiting.pop_back();
    see(mesh.twin(mesh.previous(side)));
    const Index other = mesh.twin(side);
    see(other == no_index ? no_index : mesh.next(other));
  }
  return found;
}

/// The sides at the vertex, in groups of faces that share edges there.
std::vector<std::set<Index>> groups_at(const LevelMesh& mesh, Index vertex) {
  std::vector<std::set<Index>> groups;
  std::set<Index> left(mesh.sides_at(vertex).begin(), mesh.sides_at(vertex).end());
  while (!left.empty()) {
    groups.push_back(sides_around(mesh, *left.begin()));
    for (const Index side : groups.back()) left.erase(side);
  }
  return groups;
}

}  // namespace

void part_at_vertices(const LevelMesh& mesh, PolygonMesh& polygons, CageFeatures& features) {
  for (Index v = 0; v < mesh.points.size(); ++v) {
    if (faces_around(mesh, v) == mesh.sides_at(v).size()) continue;
    const std::vector<std::set<Index>> groups = groups_at(mesh, v);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Index own = i == 0 ? v : static_cast<Index>(polygons.vertices.size());
      if (i > 0) polygons.vertices.push_back(mesh.points[v]);
      for (const Index side : groups[i]) polygons.corners[side] = own;
      features.corners.push_back({own});
    }
  }
  for (CageCrease& crease : features.creases) {
    const Index side = mesh.edges[mesh.edge_between(crease.first, crease.second)].sides[0];
    const bool is_along = mesh.corners[side] == crease.first;
    crease.first = polygons.corners[side];
    crease.second = polygons.corners[mesh.next(side)];
    if (!is_along) std::swap(crease.first, crease.second);
  }
}

}  // namespace toccata
