#include "query/penetration/solid_body.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "bounds/box_corners.hpp"
#include "math/vec3_measures.hpp"
#include "query/meshes/body_ranges.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/meshes/world_search.hpp"
#include "query/penetration/outside_faces.hpp"
#include "query/penetration/quadric_hull.hpp"
#include "query/penetration/whole_bodies.hpp"
#include "query/relation/relation_locality.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

Vec3 offset_of(const PosedShape& shape) {
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return convex->pose().offset;
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) return triangles->mesh.pose().offset;
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) return quadric->pose().offset;
  return {};
}

ConvexHull shrunk(const ConvexHull& hull, const Vec3& towards, double by) {
  std::vector<Vec3> points;
  for (Index i = 0; i < hull.vertex_count(); ++i) {
    const Vec3 vertex = hull.vertex(i);
    points.push_back(vertex + by * (towards - vertex));
  }
  return ConvexHull{points};
}

/// Some triangle meets the body. Faces of the body tell most of them from it before they are looked at closely.
bool some_triangle_meets(const PosedMesh& mesh, const ConvexHull& hull, const PosedPolytope& shape) {
  OutsideFaces faces(hull);
  const Aabb box = world_box(shape);
  bool is_met = false;
  visit_triangles_near(mesh, box, ranges_of(shape, box), [&](Index i) {
    const Triangle triangle = mesh.triangle(i);
    is_met = !faces.tell_apart(triangle) && overlap(PosedPolytope(triangle), shape);
    return !is_met;
  });
  return is_met;
}

/// Proved: no triangle meets it, and one of its points is inside.
bool lies_within(const ConvexHull& hull, const PosedMesh& mesh) {
  const PosedPolytope shape(hull);
  return !some_triangle_meets(mesh, hull, shape) && is_interior(shape.vertex(0), mesh);
}

std::optional<ConvexHull> grown_among(const Surroundings& around, const PosedMesh& mesh, CutBy cut) {
  const std::optional<ConvexHull> grown = grow_convex(around, cut);
  return grown ? drawn_within(mesh, *grown, around.point, 0) : std::nullopt;
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
    if (smaller.dimension() == 3 && lies_within(smaller, mesh)) return smaller;
  }
  return std::nullopt;
}

std::optional<ConvexHull> grow_within(const PosedMesh& mesh, const Vec3& point, double reach, CutBy cut) {
  if (!is_interior(point, mesh)) return std::nullopt;
  return grown_among(surroundings_of(mesh, point, reach), mesh, cut);
}

Penetration depth_between(const InnerPart& a, const InnerPart& b) {
  if (a.quadric && b.quadric) return penetration(*a.quadric, *b.quadric);
  if (a.quadric) return penetration(*a.quadric, b.shape);
  return b.quadric ? penetration(a.shape, *b.quadric) : penetration(a.shape, b.shape);
}

SolidBody::SolidBody(const PosedModel& posed, WholeBodies& wholes) : posed_(posed), extent_(extent_of(posed)) {
  for (const PosedPart& part : posed.parts) box_ = merge(box_, world_box(part.shape));
  find_whole(wholes);
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

void SolidBody::find_whole(WholeBodies& wholes) {
  if (posed_.parts.size() > 1 || std::holds_alternative<PosedQuadric>(posed_.parts[0].shape)) {
    outer_.emplace(ConvexHull{corners_of(box_)});
    return;
  }
  if (const auto* convex = std::get_if<PosedPolytope>(&posed_.parts[0].shape)) {
    outer_.emplace(*convex);
    exactly_convex_ = true;
  } else {
    const auto whole = wholes.of(std::get<PosedTriangles>(posed_.parts[0].shape).mesh);
    outer_.emplace(whole->hull);
    exactly_convex_ = whole->is_convex;
    whole_ = keep(whole->drawn);
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
    const Surroundings* around = surroundings_in(mesh, point, reach);
    if (around == nullptr) continue;
    if (const InnerPart* kept = keep(grown_among(*around, mesh, cut))) return kept;
  }
  return nullptr;
}

const Surroundings* SolidBody::surroundings_in(const PosedMesh& mesh, const Vec3& point, double reach) {
  const bool is_known = around_mesh_ == &mesh && around_.point == point && around_.reach == reach;
  if (!is_known) {
    around_mesh_ = &mesh;
    is_around_inside_ = is_interior(point, mesh);
    around_ = is_around_inside_ ? surroundings_of(mesh, point, reach) : Surroundings{point, reach, {}};
  }
  return is_around_inside_ ? &around_ : nullptr;
}

}  // namespace toccata
