#include "query/penetration/whole_bodies.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "query/penetration/solid_body.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Meshes with more vertices are not in every case tried for being convex.
constexpr std::size_t many_vertices = 10'000;

/// The most vertices of all hulls that are kept, some 128 bytes each; one is kept however many it has.
constexpr std::size_t most_vertices_kept = 500'000;
constexpr std::size_t most_kept = 256;

Vec3 mean_vertex(const ConvexHull& hull) {
  Vec3 sum;
  for (Index i = 0; i < hull.vertex_count(); ++i) sum = sum + hull.vertex(i);
  return (1.0 / hull.vertex_count()) * sum;
}

/// The hull of a solid mesh at its place, where that is the solid.
bool is_convex_solid(const PosedMesh& mesh) {
  const auto triangles = mesh.model().mesh().triangles();
  try {
    static_cast<void>(hull_of_convex_mesh({mesh.vertices(), {triangles.begin(), triangles.end()}}));
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::vector<Vec3> used_vertices(const PosedMesh& mesh) {
  std::vector<char> used(mesh.model().mesh().vertices().size());
  for (const auto& triangle : mesh.model().mesh().triangles())
    for (const Index i : triangle) used[i] = 1;
  std::vector<Vec3> vertices;
  for (Index i = 0; i < used.size(); ++i)
    if (used[i] != 0) vertices.push_back(mesh.vertex(i));
  return vertices;
}

std::size_t vertices_of(const WholeBody& body) {
  return std::size_t{body.hull.vertex_count()} + (body.drawn ? body.drawn->vertex_count() : 0);
}

/// Whether two poses have the same bits, 0 and -0 being two.
bool is_same(const Pose& a, const Pose& b) {
  return std::ranges::equal(a.numbers(), b.numbers(), {}, std::bit_cast<std::uint64_t, double>,
                            std::bit_cast<std::uint64_t, double>);
}

}  // namespace

WholeBody whole_body_of(const PosedMesh& mesh) {
  const std::vector<Vec3> vertices = used_vertices(mesh);
  WholeBody whole{.hull = ConvexHull{vertices}, .is_convex = false, .drawn = {}};
  const ConvexHull& hull = whole.hull;
  const bool is_large = vertices.size() > many_vertices;
  whole.is_convex = (!is_large || 2 * std::size_t{hull.vertex_count()} >= vertices.size()) && is_convex_solid(mesh);
  if (!whole.is_convex && !is_large && hull.dimension() == 3)
    whole.drawn = drawn_within(mesh, hull, mean_vertex(hull), 1 - 0x1p-36);
  return whole;
}

std::shared_ptr<const WholeBody> WholeBodies::of(const PosedMesh& mesh) {
  const std::shared_ptr<const TriangleMesh> shape = mesh_of(mesh.model().shape());
  const auto is_it = [&](const Kept& kept) {
    const bool is_same_mesh = !kept.mesh.owner_before(shape) && !shape.owner_before(kept.mesh);
    return is_same_mesh && is_same(kept.pose, mesh.pose());
  };
  std::erase_if(kept_, [&](const Kept& kept) {
    if (kept.mesh.expired()) vertices_ -= vertices_of(*kept.body);
    return kept.mesh.expired();
  });
  const auto found = std::ranges::find_if(kept_, is_it);
  if (found != kept_.end()) {
    std::rotate(kept_.begin(), found, found + 1);
    return kept_.front().body;
  }
  kept_.push_front({shape, mesh.pose(), std::make_shared<const WholeBody>(whole_body_of(mesh))});
  vertices_ += vertices_of(*kept_.front().body);
  while (kept_.size() > 1 && (kept_.size() > most_kept || vertices_ > most_vertices_kept)) {
    vertices_ -= vertices_of(*kept_.back().body);
    kept_.pop_back();
  }
  return kept_.front().body;
}

}  // namespace toccata
