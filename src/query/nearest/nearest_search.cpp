#include "query/nearest/nearest_search.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include "core/require_length.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

constexpr std::string_view name_of_surface = "the surface";

void require_point(const Vec3& point) {
  if (!is_finite(point)) throw Error("the point is not finite");
}

SurfacePoint nearest_of_quadric(const Vec3& point, const PosedQuadric& shape) {
  const BoundaryPoint found = boundary_point(point, shape);
  const double lower = found.status == Status::exact ? lower_from(found.upper) : found.lower;
  return {lower, found.upper, found.point, 0, 0, found.status};
}

SurfacePoint numbered(SurfacePoint found, const PosedPart& part) {
  found.element = part.first_element;
  found.face = part.first_face;
  return found;
}

}  // namespace

std::optional<SurfacePoint> nearest_of_mesh(const Vec3& point, const Model& mesh, const NearestQuery& query,
                                            SearchScratch& scratch) {
  const auto ask = [&](const SurfaceTarget& target) {
    require_length(query.max_distance, "the greatest distance");
    require_point(point);
    scratch.counts = {};
    NearestElements nearest(1, query.max_distance, scratch.surface_points);
    target.see_near(point, nearest, scratch);
    return nearest.first();
  };
  if (query.pose == Pose{}) return ask(SurfaceTarget(mesh, 1));
  const PosedMesh posed(mesh, query.pose, name_of_surface);
  return ask(SurfaceTarget(posed, 0, 0, 1));
}

NearestSearch::NearestSearch(const Model& surface, const NearestQuery& query, std::size_t points,
                             std::vector<PosedPart> memory)
    : posed_(pose_model(surface, query.pose, Solid::none, name_of_surface, std::move(memory))),
      max_distance_(query.max_distance) {
  require_length(max_distance_, "the greatest distance");
  for (const PosedPart& part : posed_.parts) {
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape))
      meshes_.emplace_back(triangles->mesh, part.first_element, part.first_face, points);
    if (const auto* convex = std::get_if<PosedPolytope>(&part.shape))
      convexes_.push_back(std::make_unique<ConvexBoundary>(*convex));
  }
}

std::span<const SurfacePoint> NearestSearch::search(const Vec3& point, std::size_t k, SearchScratch& scratch) const {
  require_point(point);
  scratch.counts = {};
  NearestElements nearest(k, max_distance_, scratch.surface_points);
  auto convex = convexes_.begin();
  for (const PosedPart& part : posed_.parts) {
    if (std::holds_alternative<PosedPolytope>(part.shape))
      nearest.see(numbered((*convex++)->nearest(point, scratch), part));
    if (const auto* half_space = std::get_if<PosedHalfSpace>(&part.shape))
      nearest.see(numbered(nearest_of_boundary(point, *half_space), part));
    if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape))
      nearest.see(numbered(nearest_of_quadric(point, *quadric), part));
  }
  for (const SurfaceTarget& mesh : meshes_) mesh.see_near(point, nearest, scratch);
  return nearest.in_order();
}

std::optional<SurfacePoint> NearestSearch::nearest_within(const Vec3& point, SearchScratch& scratch) const {
  const std::span<const SurfacePoint> found = search(point, 1, scratch);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

void NearestSearch::nearest(std::span<const Vec3> points, std::span<std::optional<SurfacePoint>> found,
                            SearchScratch& scratch) const {
  if (posed_.parts.size() == 1 && meshes_.size() == 1 && meshes_[0].has_leaves())
    return meshes_[0].find_nearest(points, max_distance_, found, scratch);
  for (std::size_t i = 0; i < points.size(); ++i) found[i] = nearest_within(points[i], scratch);
}

std::vector<SurfacePoint> NearestSearch::nearest(const Vec3& point, std::size_t k, SearchScratch& scratch) const {
  const std::span<const SurfacePoint> found = search(point, k, scratch);
  return {found.begin(), found.end()};
}

}  // namespace toccata
