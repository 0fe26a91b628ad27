#pragma once

#include <memory>

#include "toccata/query/casts.hpp"

namespace toccata {

/// A model at its place, made ready once for rays that are asked about one after the other: what depends on the model
/// and its pose alone is not done again for each. Rays that are known together are asked about with `cast_ray_each`.
/// Constant functions may be called from many threads at once.
class RayCaster {
 public:
  /// Throws as `cast_ray` does of the model. A model that is deformed later stays as it was here.
  explicit RayCaster(const Model& target, const Pose& pose = {}, Solid solid = Solid::automatic);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// What `cast_ray` answers for the ray, to the bit. Throws as it does of the ray.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const Vec3& motion) const;

 private:
  struct Ready;
  std::unique_ptr<const Ready> ready_;
};

}  // namespace toccata
