#include "methods/bsp/bsp_windings.hpp"

#include "math/exact.hpp"
#include "query/inside/inside_winding.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "shapes/union_find.hpp"
#include "shapes/welded_mesh.hpp"

namespace toccata {
namespace {

/// The triangles that hang together by edges of exactly two. In front of both it is the same space: near the edge there
/// is nothing else, and in a closed mesh the two run along it in opposite directions.
UnionFind united_across_edges(const TriangleMesh& mesh) {
  const std::vector<WeldedEdge> edges = edges_of_triangles(weld(mesh));
  UnionFind sheets(mesh.triangle_count());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) ++end;
    if (end - begin == 2) sheets.unite(edges[begin].triangle, edges[begin + 1].triangle);
    begin = end;
  }
  return sheets;
}

/// On either side of the middle of the triangle, where no other one is.
int winding_in_front(const PosedMesh& mesh, Index number) {
  const Triangle t = mesh.triangle(number);
  const RationalPoint sum = to_rational(t[0]) + to_rational(t[1]) + to_rational(t[2]);
  int axis = 0;
  while (axis < 2 && projected_orientation(t, axis) == Sign::zero) ++axis;
  const LineWinding winding = wind_along(mesh, ExactPoint(Rational(1, 3) * sum), axis);
  return projected_orientation(t, axis) == Sign::positive ? winding.ahead : winding.behind;
}

}  // namespace

std::vector<int> windings_in_front(const Model& solid) {
  const PosedMesh mesh(solid, Pose{});
  UnionFind sheets = united_across_edges(solid.mesh());
  std::vector<int> windings(solid.mesh().triangle_count());
  for (Index t = 0; t < windings.size(); ++t) {
    const Index leader = sheets.leader(t);  // the least, so it is known already
    windings[t] = leader == t ? winding_in_front(mesh, t) : windings[leader];
  }
  return windings;
}

}  // namespace toccata
