#include "query/nearest_search.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void require_surface(const PosedPart& part) {
  const auto* convex = std::get_if<PosedConvex>(&part.shape);
  if (std::holds_alternative<PosedTriangles>(part.shape) || (convex != nullptr && !convex->solid())) return;
  throw Error(fmt::format(
      "the nearest point of a surface is not told of a {}, which has an interior; ask for its distance from the point",
      name_of(part.kind)));
}

void require_distance(double max_distance) {
  if (!(max_distance >= 0)) throw Error(fmt::format("the greatest distance is {}; give 0 or more", max_distance));
}

SurfacePoint of_convex(const Vec3& point, const PosedConvex& shape, const PosedPart& part) {
  const Distance found = distance(PosedConvex(Point{point}), shape);
  return {true, lower_from(found.upper), found.upper, found.on_b, part.first_element, part.first_face, found.status};
}

}  // namespace

NearestSearch::NearestSearch(const Model& surface, const NearestQuery& query, std::size_t points,
                             std::vector<PosedPart> memory)
    : posed_(pose_model(surface, query.pose, Solid::none, "the surface", std::move(memory))),
      max_distance_(query.max_distance) {
  require_distance(max_distance_);
  for (const PosedPart& part : posed_.parts) {
    require_surface(part);
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape))
      meshes_.emplace_back(triangles->mesh, part.first_element, part.first_face, points);
  }
}

std::span<const SurfacePoint> NearestSearch::search(const Vec3& point, std::size_t k, SearchScratch& scratch) const {
  if (!is_finite(point)) throw Error("the point is not finite");
  scratch.counts = {};
  NearestElements nearest(k, max_distance_, scratch.surface_points);
  for (const PosedPart& part : posed_.parts)
    if (const auto* convex = std::get_if<PosedConvex>(&part.shape)) nearest.see(of_convex(point, *convex, part));
  for (const SurfaceTarget& mesh : meshes_) mesh.see_near(point, nearest, scratch);
  return nearest.in_order();
}

SurfacePoint NearestSearch::nearest(const Vec3& point, SearchScratch& scratch) const {
  const std::span<const SurfacePoint> found = search(point, 1, scratch);
  return found.empty() ? SurfacePoint{} : found.front();
}

std::vector<SurfacePoint> NearestSearch::nearest(const Vec3& point, std::size_t k, SearchScratch& scratch) const {
  const std::span<const SurfacePoint> found = search(point, k, scratch);
  return {found.begin(), found.end()};
}

}  // namespace toccata
