#include "query/rays/ray_search.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <variant>

#include "query/keep_least.hpp"
#include "query/relation/relation_locality.hpp"
#include "query/semantics.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/ray_caster.hpp"

namespace toccata {
namespace {

constexpr std::string_view name_of_target = "the target";

RayHit numbered(const Cast& cast, Index element = 0, Index face = 0) {
  RayHit hit{cast};
  hit.element = element;
  hit.face = face;
  return hit;
}

std::optional<RayHit> of_one_element(const std::optional<Cast>& cast) {
  return cast ? std::optional(numbered(*cast)) : std::nullopt;
}

bool starts_inside(const PosedTriangles& target, const Vec3& origin) {
  const Aabb point{origin, origin};
  return target.solid && overlap(target.mesh.box(), point) && is_interior(origin, target.mesh);
}

RayHit hit_at_start(const PreparedRay& ray) {
  RayHit hit;
  hit.point = ray.origin;
  return hit;
}

std::optional<RayHit> hit_of_surface(const RayTarget& search, const PreparedRay& ray, const TriangleHit& found) {
  if (!found.time.hit) return {};
  const Index face = search.mesh().face_of(found.triangle);
  const Cast cast = found.cast ? *found.cast : ray_hit(ray, search.world_triangle(found.triangle), found.time);
  RayHit hit = numbered(cast, found.triangle, face);
  hit.lower = found.lower;
  return hit;
}

std::optional<RayHit> hit_of(const PosedTriangles& target, const RayTarget& search, const PreparedRay& ray) {
  if (starts_inside(target, ray.origin)) return hit_at_start(ray);
  return hit_of_surface(search, ray, search.first_hit(ray));
}

/// At a mesh at the identity: it is posed for what begins in its box alone.
std::optional<RayHit> hit_of_standing(const Model& target, Solid solid, const PreparedRay& ray) {
  const bool as_solid = taken_as_solid(target, Pose{}, solid, name_of_target);
  if (as_solid && overlap(target.wide_bvh().box, Aabb{ray.origin, ray.origin}) &&
      is_interior(ray.origin, PosedMesh(target, Pose{}, name_of_target)))
    return hit_at_start(ray);
  const RayTarget search(target, target.leaf_triangles_for(1));
  return hit_of_surface(search, ray, search.first_hit(ray));
}

/// The hits of many rays at one mesh.
void hits_of(const PosedTriangles& target, const RayTarget& search, std::span<const PreparedRay> rays,
             std::span<std::optional<RayHit>> hits) {
  std::vector<TriangleHit> found(rays.size());
  search.first_hits(rays, found);
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = starts_inside(target, rays[i].origin) ? std::optional(hit_at_start(rays[i]))
                                                    : hit_of_surface(search, rays[i], found[i]);
}

void require_answered(ShapeKind target) {
  const PairCell cell = pair_cell(ShapeQuestion::cast_ray, ShapeKind::point, target);
  if (cell.state != PairState::defined)
    throw Error(fmt::format("cast-ray at a {} is not defined: {}", name_of(target), cell.text));
}

}  // namespace

RaySearch::RaySearch(const Model& target, const Pose& pose, Solid solid)
    : posed_(pose_model(target, pose, solid, name_of_target)) {
  for (const PosedPart& part : posed_.parts) {
    require_answered(part.kind);
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape)) meshes_.emplace_back(triangles->mesh);
  }
}

std::optional<RayHit> RaySearch::first_hit(const PreparedRay& ray) const {
  if (posed_.parts.size() == 1) return hit_of_part(posed_.parts[0], 0, ray);
  std::optional<RayHit> earliest;
  std::size_t mesh = 0;
  for (const PosedPart& part : posed_.parts) {
    std::optional<RayHit> found = hit_of_part(part, mesh, ray);
    if (std::holds_alternative<PosedTriangles>(part.shape)) ++mesh;
    if (!found) continue;
    found->element += part.first_element;
    found->face += part.first_face;
    keep_least(earliest, *found);
  }
  return earliest;
}

void RaySearch::first_hits(std::span<const PreparedRay> rays, std::span<std::optional<RayHit>> hits) const {
  const auto* triangles = std::get_if<PosedTriangles>(&posed_.parts[0].shape);
  if (posed_.parts.size() == 1 && triangles != nullptr) return hits_of(*triangles, meshes_[0], rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(rays[i]);
}

std::optional<RayHit> RaySearch::hit_of_part(const PosedPart& part, std::size_t mesh, const PreparedRay& ray) const {
  if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape)) return hit_of(*triangles, meshes_[mesh], ray);
  if (const auto* half_space = std::get_if<PosedHalfSpace>(&part.shape))
    return of_one_element(cast_ray(ray.origin, ray.motion, *half_space));
  if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape))
    return of_one_element(cast_ray(ray.origin, ray.motion, *quadric));
  return of_one_element(cast_ray(ray.origin, ray.motion, std::get<PosedPolytope>(part.shape)));
}

struct RayCaster::Ready {
  Ready(const Model& target, const Pose& pose, Solid solid) : model(target), search(model, pose, solid) {}
  Model model;
  RaySearch search;
};

RayCaster::RayCaster(const Model& target, const Pose& pose, Solid solid)
    : ready_(std::make_unique<const Ready>(target, pose, solid)) {}
RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<RayHit> RayCaster::cast_ray(const Vec3& origin, const Vec3& motion) const {
  return ready_->search.first_hit(PreparedRay(origin, motion));
}

std::optional<RayHit> cast_ray(const Vec3& origin, const Vec3& motion, const Model& target, const Pose& pose,
                               Solid solid) {
  if (!target.has_mesh()) return RaySearch(target, pose, solid).first_hit(PreparedRay(origin, motion));
  if (pose == Pose{}) return hit_of_standing(target, solid, PreparedRay(origin, motion));
  // The same without lists of one.
  const PosedShape posed = pose_shape(target, pose, solid, name_of_target);
  require_answered(kind_of(target.shape()));
  const auto& triangles = std::get<PosedTriangles>(posed);
  return hit_of(triangles, RayTarget(triangles.mesh), PreparedRay(origin, motion));
}

}  // namespace toccata
