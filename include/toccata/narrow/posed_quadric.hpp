#pragma once

#include <cstdint>
#include <string_view>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/cone.hpp"
#include "toccata/shapes/cylinder.hpp"
#include "toccata/shapes/ellipsoid.hpp"

namespace toccata {

/// A cylinder, a cone or an ellipsoid at its place: the image of the shape under its pose taken as real numbers, which
/// need not be rigid (docs/truth.md, "quadric").
class PosedQuadric {
 public:
  enum class Kind : std::uint8_t { cylinder, cone, ellipsoid };

  // Throw Error when the pose is not finite or singular, or the shape reaches beyond the finite doubles.
  explicit PosedQuadric(const Cylinder& shape, const Pose& pose = {});
  explicit PosedQuadric(const Cone& shape, const Pose& pose = {});
  explicit PosedQuadric(const Ellipsoid& shape, const Pose& pose = {});

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Half axes of the ellipsoid; of a cylinder and a cone the radius twice, and the half height.
  [[nodiscard]] const Vec3& half() const { return half_; }

  /// A copy that lies elsewhere; the new place is rounded where the vector is not a step of its last place.
  [[nodiscard]] PosedQuadric moved(const Vec3& by) const;

  friend bool operator==(const PosedQuadric&, const PosedQuadric&) = default;

 private:
  PosedQuadric(Kind kind, const Vec3& half, const Pose& pose, std::string_view who);

  Kind kind_;
  Vec3 half_;
  Pose pose_;
};

}  // namespace toccata
