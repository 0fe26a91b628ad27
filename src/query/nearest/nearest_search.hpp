#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "query/nearest/convex_boundary.hpp"
#include "query/nearest/nearest_elements.hpp"
#include "query/nearest/surface_target.hpp"
#include "query/posed_shape.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata {

/// nearest_point of one mesh or height field: the same without lists of one.
[[nodiscard]] std::optional<SurfacePoint> nearest_of_mesh(const Vec3& point, const Model& mesh,
                                                          const NearestQuery& query, SearchScratch& scratch);

/// A surface at its place, made ready for many points. It refers to the model. Throws as nearest_point does of all but
/// the point.
class NearestSearch {
 public:
  /// About so many points will be asked about. The parts take the place of what is in `memory`.
  NearestSearch(const Model& surface, const NearestQuery& query, std::size_t points,
                std::vector<PosedPart> memory = {});
  NearestSearch(const NearestSearch&) = delete;
  NearestSearch& operator=(const NearestSearch&) = delete;

  /// Throws as nearest_point does of the point.
  [[nodiscard]] std::optional<SurfacePoint> nearest_within(const Vec3& point, SearchScratch& scratch) const;
  /// Where there is no greatest distance.
  [[nodiscard]] SurfacePoint nearest(const Vec3& point, SearchScratch& scratch) const {
    return *nearest_within(point, scratch);
  }
  [[nodiscard]] std::vector<SurfacePoint> nearest(const Vec3& point, std::size_t k, SearchScratch& scratch) const;

  /// nearest_within of many, of which some are looked for at a time.
  void nearest(std::span<const Vec3> points, std::span<std::optional<SurfacePoint>> found,
               SearchScratch& scratch) const;

  /// In the world.
  [[nodiscard]] const PosedModel& posed() const { return posed_; }

  /// Gives the memory back.
  [[nodiscard]] std::vector<PosedPart> release() { return std::move(posed_.parts); }

 private:
  [[nodiscard]] std::span<const SurfacePoint> search(const Vec3& point, std::size_t k, SearchScratch& scratch) const;

  PosedModel posed_;
  std::vector<SurfaceTarget> meshes_;                      ///< of the parts that are meshes, in their order
  std::vector<std::unique_ptr<ConvexBoundary>> convexes_;  ///< of those that are convex shapes, in their order
  double max_distance_;
};

}  // namespace toccata
