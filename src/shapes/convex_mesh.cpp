#include <algorithm>
#include <string>
#include <vector>

#include "shapes/hull_walk.hpp"
#include "shapes/welded_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// The faces of a closed mesh whose planes have all vertices behind them or on them lie on the boundary of the hull, and
// turn as it does. Each point of that boundary is then covered equally often (a closed chain on a sphere is a multiple
// of the sphere), and at least once: so the solid is the hull.
namespace toccata {
namespace {

[[noreturn]] void refuse(const TriangleMesh& mesh, Index triangle, const std::string& why) {
  throw Error("the mesh is not a convex solid: face " + std::to_string(mesh.face_of(triangle)) + " " + why);
}

void require_closed(const TriangleMesh& mesh) {
  const WeldedTriangles welded = weld(mesh);
  for (const EdgeUse& edge : edge_uses(welded)) {
    if (edge.upward == edge.downward) continue;
    const auto has_edge = [&](const std::array<Index, 3>& t) {
      return std::ranges::count(t, edge.low) > 0 && std::ranges::count(t, edge.high) > 0;
    };
    const auto at = std::ranges::find_if(welded.triangles, has_edge) - welded.triangles.begin();
    refuse(mesh, static_cast<Index>(at), "has an edge that is not used equally often in both directions: it is open");
  }
}

std::vector<Index> numbers_of_used_vertices(const TriangleMesh& mesh) {
  std::vector<Index> used;
  for (const auto& t : mesh.triangles()) used.insert(used.end(), t.begin(), t.end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

class ConvexMesh {
 public:
  explicit ConvexMesh(const TriangleMesh& mesh)
      : mesh_(mesh), used_(numbers_of_used_vertices(mesh)), hull_(points_of(mesh, used_)) {}

  [[nodiscard]] const ConvexHull& hull() const { return hull_; }

  void require_convex() {
    if (hull_.dimension() < 3) throw Error("the mesh is flat, so it is not a convex solid; use it as a surface");
    for (Index t = 0; t < mesh_.triangle_count(); ++t) {
      const auto& [a, b, c] = mesh_.triangles()[t];
      if (!has_area({{at(a), at(b), at(c)}}) || is_behind(a, b, c)) continue;
      const Index before = used_[hull_.source_of(highest_)];
      if (is_behind(a, c, b)) refuse(mesh_, t, "turns clockwise seen from outside; turn all faces round");
      refuse(mesh_, t,
             "has vertex " + std::to_string(before) + " before it; use it as a mesh, or make the hull of its vertices");
    }
  }

 private:
  static std::vector<Vec3> points_of(const TriangleMesh& mesh, const std::vector<Index>& used) {
    std::vector<Vec3> points;
    points.reserve(used.size());
    for (const Index v : used) points.push_back(mesh.vertices()[v]);
    return points;
  }

  [[nodiscard]] const Vec3& at(Index vertex) const { return mesh_.vertices()[vertex]; }

  /// No vertex lies before the plane of the three; else `highest_` does.
  bool is_behind(Index a, Index b, Index c) {
    highest_ = highest_vertex(hull_, at(a), at(b), at(c), highest_);
    return orient3d(at(a), at(b), at(c), hull_.vertex(highest_)) != Sign::positive;
  }

  const TriangleMesh& mesh_;
  std::vector<Index> used_;
  ConvexHull hull_;
  Index highest_ = 0;
};

}  // namespace

ConvexHull hull_of_convex_mesh(const TriangleMesh& mesh) {
  require_closed(mesh);
  ConvexMesh convex(mesh);
  convex.require_convex();
  return convex.hull();
}

}  // namespace toccata
