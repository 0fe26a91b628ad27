#pragma once

#include <cmath>

#include "query/decomposition/cut_plane.hpp"
#include "query/decomposition/solid_piece.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {

/// Rounded numbers are counted from the middle of the mesh in units of about its size, so that none is too large or too
/// small.
class SolidFrame {
 public:
  explicit SolidFrame(const MeshHealth& health) : middle_(0.5 * health.lower + 0.5 * health.upper) {
    double size = 0;
    for (int axis = 0; axis < 3; ++axis) size = std::fmax(size, 0.5 * health.upper[axis] - 0.5 * health.lower[axis]);
    exponent_ = size > 0 ? std::ilogb(size) + 1 : 0;
  }

  /// Within 1 of the origin, for points of the mesh.
  [[nodiscard]] Vec3 local(const Vec3& p) const {
    return {difference(p.x, middle_.x), difference(p.y, middle_.y), difference(p.z, middle_.z)};
  }
  [[nodiscard]] Vec3 world(const Vec3& p) const {
    return {middle_.x + length(p.x), middle_.y + length(p.y), middle_.z + length(p.z)};
  }
  /// A local length in units of the mesh.
  [[nodiscard]] double length(double local) const { return std::ldexp(local, exponent_); }
  [[nodiscard]] double volume(double local) const { return std::ldexp(local, 3 * exponent_); }

  [[nodiscard]] RoundedPlane plane(const PlaneChoice& choice) const {
    const Vec3 normal = (1 / std::sqrt(dot(choice.normal, choice.normal))) * choice.normal;
    return {normal, dot(normal, local(choice.through))};
  }

 private:
  [[nodiscard]] double difference(double p, double middle) const {
    return std::ldexp(p, -exponent_) - std::ldexp(middle, -exponent_);
  }

  Vec3 middle_;
  int exponent_ = 0;
};

}  // namespace toccata
