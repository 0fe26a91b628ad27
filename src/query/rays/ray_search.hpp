#pragma once

#include <optional>
#include <span>
#include <vector>

#include "query/posed_shape.hpp"
#include "query/rays/mesh_rays.hpp"
#include "toccata/query/casts.hpp"

namespace toccata {

/// A model at its place, made ready for many rays. It refers to the model. Throws as cast_ray does of the model.
class RaySearch {
 public:
  RaySearch(const Model& target, const Pose& pose, Solid solid);
  RaySearch(const RaySearch&) = delete;
  RaySearch& operator=(const RaySearch&) = delete;

  [[nodiscard]] std::optional<RayHit> first_hit(const PreparedRay& ray) const;

  /// The same of many: those at one mesh are walked side by side.
  void first_hits(std::span<const PreparedRay> rays, std::span<std::optional<RayHit>> hits) const;

 private:
  [[nodiscard]] std::optional<RayHit> hit_of_part(const PosedPart& part, std::size_t mesh,
                                                  const PreparedRay& ray) const;

  PosedModel posed_;
  std::vector<RayTarget> meshes_;  ///< of the parts that are meshes, in their order
};

}  // namespace toccata
