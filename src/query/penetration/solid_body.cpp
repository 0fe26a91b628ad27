#include "query/penetration/solid_body.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "bounds/box_corners.hpp"
#include "math/vec3_measures.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/penetration/quadric_hull.hpp"
#include "query/relation/relation_locality.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// Of meshes with more vertices it is not tried in every case whether they are convex.
constexpr std::size_t many_vertices = 10'000;

Vec3 offset_of(const PosedShape& shape) {
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return convex->pose().offset;
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) return triangles->mesh.pose().offset;
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) return quadric->pose().offset;
  return {};
}

Vec3 mean_vertex(const ConvexHull& hull) {
  Vec3 sum;
  for (Index i = 0; i < hull.vertex_count(); ++i) sum = sum + hull.vertex(i);
  return (1.0 / hull.vertex_count()) * sum;
}

ConvexHull shrunk(const ConvexHull& hull, const Vec3& towards, double by) {
  std::vector<Vec3> points;
  for (Index i = 0; i < hull.vertex_count(); ++i) {
    const Vec3 vertex = hull.vertex(i);
    points.push_back(vertex + by * (towards - vertex));
  }
  return ConvexHull{points};
}

/// Proved: no triangle meets it, and one of its points is inside.
bool lies_within(const PosedPolytope& shape, const PosedMesh& mesh) {
  return !overlap(PosedTriangles{mesh, false}, shape) && is_interior(shape.vertex(0), mesh);
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

}  // namespace

bool holds(const PosedShape& shape, const Vec3& point) {
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return overlap(*convex, PosedPolytope(Point(point)));
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) return overlap(*quadric, PosedPolytope(Point(point)));
  return is_interior(point, std::get<PosedTriangles>(shape).mesh);
}

double extent_of(const PosedModel& posed) {
  Aabb box;
  double extent = 0;
  for (const PosedPart& part : posed.parts) {
    box = merge(box, world_box(part.shape));
    extent = std::max(extent, largest_magnitude(offset_of(part.shape)));
  }
  return extent + (largest_magnitude(box.lower) + largest_magnitude(box.upper));
}

std::optional<ConvexHull> drawn_within(const PosedMesh& mesh, const ConvexHull& hull, const Vec3& towards,
                                       double least_share) {
  for (const double less : {0x1p-40, 0x1p-30, 0x1p-20, 0x1p-10, 0x1p-4}) {
    if (1 - less < least_share) break;
    ConvexHull smaller = shrunk(hull, towards, less);
    if (smaller.dimension() == 3 && lies_within(PosedPolytope(smaller), mesh)) return smaller;
  }
  return std::nullopt;
}

std::optional<ConvexHull> grow_within(const PosedMesh& mesh, const Vec3& point, double reach, CutBy cut) {
  if (!is_interior(point, mesh)) return std::nullopt;
  const std::optional<ConvexHull> grown = grow_convex(mesh, point, reach, cut);
  return grown ? drawn_within(mesh, *grown, point, 0) : std::nullopt;
}

Penetration depth_between(const InnerPart& a, const InnerPart& b) {
  if (a.quadric && b.quadric) return penetration(*a.quadric, *b.quadric);
  if (a.quadric) return penetration(*a.quadric, b.shape);
  return b.quadric ? penetration(a.shape, *b.quadric) : penetration(a.shape, b.shape);
}

SolidBody::SolidBody(const PosedModel& posed) : posed_(posed), extent_(extent_of(posed)) {
  for (const PosedPart& part : posed.parts) box_ = merge(box_, world_box(part.shape));
  find_whole();
  find_inner_parts();
}

void SolidBody::find_inner_parts() {
  for (const PosedPart& part : posed_.parts) {
    const auto* convex = std::get_if<PosedPolytope>(&part.shape);
    const auto* quadric = std::get_if<PosedQuadric>(&part.shape);
    const std::optional<ConvexHull> hull = quadric != nullptr ? hull_within(*quadric) : std::nullopt;
    InnerPart* const kept = convex != nullptr ? &kept_.emplace_back(*convex)
                            : hull            ? &kept_.emplace_back(*hull)
                                              : nullptr;
    if (hull) kept->quadric = *quadric;
    inner_.push_back(kept);
  }
}

const InnerPart* SolidBody::as_one() const {
  if (exactly_convex_) return whole_;
  return std::holds_alternative<PosedQuadric>(posed_.parts[0].shape) && posed_.parts.size() == 1 ? inner_[0] : nullptr;
}

const InnerPart* SolidBody::within(const PosedPart& part) const {
  return inner_[static_cast<std::size_t>(&part - posed_.parts.data())];
}

void SolidBody::find_whole() {
  if (posed_.parts.size() > 1 || std::holds_alternative<PosedQuadric>(posed_.parts[0].shape)) {
    outer_.emplace(ConvexHull{corners_of(box_)});
    return;
  }
  if (const auto* convex = std::get_if<PosedPolytope>(&posed_.parts[0].shape)) {
    outer_.emplace(*convex);
    exactly_convex_ = true;
  } else {
    const PosedMesh& mesh = std::get<PosedTriangles>(posed_.parts[0].shape).mesh;
    const std::vector<Vec3> vertices = used_vertices(mesh);
    const ConvexHull hull{vertices};
    outer_.emplace(hull);
    const bool is_large = vertices.size() > many_vertices;
    exactly_convex_ = (!is_large || 2 * std::size_t{hull.vertex_count()} >= vertices.size()) && is_convex_solid(mesh);
    if (!exactly_convex_ && !is_large && hull.dimension() == 3)
      whole_ = keep(drawn_within(mesh, hull, mean_vertex(hull), 1 - 0x1p-36));
  }
  if (exactly_convex_) whole_ = &*outer_;
}

bool SolidBody::contains(const Vec3& point) const {
  return std::any_of(posed_.parts.begin(), posed_.parts.end(),
                     [&](const PosedPart& part) { return holds(part.shape, point); });
}

const InnerPart* SolidBody::keep(const std::optional<ConvexHull>& hull) {
  return hull ? &kept_.emplace_back(*hull) : nullptr;
}

std::vector<const InnerPart*> SolidBody::convex_parts() {
  if (whole_ != nullptr) return {whole_};
  std::vector<const InnerPart*> found;
  std::copy_if(inner_.begin(), inner_.end(), std::back_inserter(found), [](const InnerPart* part) { return part; });
  return found;
}

const InnerPart* SolidBody::grow(const Vec3& point, double reach, CutBy cut) {
  if (whole_ != nullptr) return whole_;
  for (const PosedPart& part : posed_.parts) {
    if (const InnerPart* inner = within(part); inner != nullptr && holds(part.shape, point)) return inner;
    if (!std::holds_alternative<PosedTriangles>(part.shape)) continue;
    const PosedMesh& mesh = std::get<PosedTriangles>(part.shape).mesh;
    if (const InnerPart* kept = keep(grow_within(mesh, point, reach, cut))) return kept;
  }
  return nullptr;
}

}  // namespace toccata
