#include "toccata/query/nearest.hpp"

#include "query/nearest/nearest_search.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

std::optional<SurfacePoint> nearest_point(const Vec3& point, const Model& surface, const NearestQuery& query) {
  Workspace workspace;
  return nearest_point(point, surface, query, workspace);
}

std::optional<SurfacePoint> nearest_point(const Vec3& point, const Model& surface, const NearestQuery& query,
                                          Workspace& workspace) {
  SearchScratch& scratch = workspace.scratch();
  if (surface.has_mesh()) return nearest_of_mesh(point, surface, query, scratch);
  NearestSearch search(surface, query, 1, std::move(scratch.posed[0]));
  const std::optional<SurfacePoint> found = search.nearest_within(point, scratch);
  scratch.posed[0] = search.release();
  return found;
}

std::vector<SurfacePoint> nearest_points(const Vec3& point, std::size_t k, const Model& surface,
                                         const NearestQuery& query) {
  Workspace workspace;
  return nearest_points(point, k, surface, query, workspace);
}

std::vector<SurfacePoint> nearest_points(const Vec3& point, std::size_t k, const Model& surface,
                                         const NearestQuery& query, Workspace& workspace) {
  SearchScratch& scratch = workspace.scratch();
  NearestSearch search(surface, query, 1, std::move(scratch.posed[0]));
  std::vector<SurfacePoint> found = search.nearest(point, k, scratch);
  scratch.posed[0] = search.release();
  return found;
}

}  // namespace toccata
