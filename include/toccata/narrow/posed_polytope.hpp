#pragma once

#include <array>
#include <span>
#include <string_view>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/posed_shapes.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

/// A bounded convex shape at its place, as the pair questions see every one of them: the convex hull of world vertices
/// (those of docs/truth.md) grown by a radius. A sphere has one vertex, a segment and a capsule two, a triangle three,
/// a box eight, a hull its own. Cheap to make: at most eight vertices are computed at once, those of a hull when they
/// are looked at. It refers to the hull it was made of, which has to outlive it.
class PosedPolytope {
 public:
  // Throw Error when the pose or a world vertex is not finite, the pose of a shape with a radius deforms it (the
  // largest row sum of |RᵀR − I| is more than 2⁻¹⁰; the message names the ellipsoid), or that of a solid is singular.
  explicit PosedPolytope(const Point& shape, const Pose& pose = {});
  explicit PosedPolytope(const Segment& shape, const Pose& pose = {});
  explicit PosedPolytope(const Triangle& shape, const Pose& pose = {});
  explicit PosedPolytope(const Sphere& shape, const Pose& pose = {});
  explicit PosedPolytope(const Box& shape, const Pose& pose = {});
  explicit PosedPolytope(const Capsule& shape, const Pose& pose = {});
  explicit PosedPolytope(const ConvexHull& shape, const Pose& pose = {});
  /// A hull that is not kept would be referred to after its end.
  explicit PosedPolytope(const ConvexHull&& shape, const Pose& pose = {}) = delete;
  explicit PosedPolytope(const Rounded& shape, const Pose& pose = {});

  PosedPolytope(const PosedPolytope& other);
  PosedPolytope& operator=(const PosedPolytope& other);
  ~PosedPolytope() = default;

  /// A copy with every vertex moved, and rounded anew where the vector is not a step of its last place: for searches,
  /// not for exact answers about the moved shape.
  [[nodiscard]] PosedPolytope moved(const Vec3& by) const;

  /// A copy of which every length is multiplied by 2^exponent: exact, but for over- and underflow.
  [[nodiscard]] PosedPolytope scaled(int exponent) const;

  [[nodiscard]] Index vertex_count() const { return count_; }

  /// In the world.
  [[nodiscard]] Vec3 vertex(Index i) const {
    const Vec3 stored{along_[0][i], along_[1][i], along_[2][i]};
    return in_world_ ? stored : transform(pose_, stored);
  }

  [[nodiscard]] double radius() const { return radius_; }

  /// Whether it has an interior: a positive radius, or it is a box or a hull that is not flat in its own frame.
  [[nodiscard]] bool solid() const { return solid_; }

  /// Vertices and faces of the shape in its own frame. In the world rounding may bend a face by the last place, and a
  /// mirroring pose turns every face round. A triangle whose world vertices are collinear has the topology of the
  /// segment between the lexicographically least and greatest of them, or of a point; it keeps its three vertices, and
  /// `leaving` of one that is no end is 0.
  [[nodiscard]] HullTopology topology() const { return topology_; }

  // For the supports. Coordinates along an axis, padded to a multiple of eight by repeating the last vertex; they are
  // world coordinates already when `in_world`, else the shape's own, to be posed.
  [[nodiscard]] const double* along(int axis) const { return along_[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] Index padded_count() const { return (count_ + 7) / 8 * 8; }
  [[nodiscard]] bool in_world() const { return in_world_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// For a hull, the greatest magnitude of a coordinate in its own frame; 0 for any other shape.
  [[nodiscard]] double stored_extent() const { return stored_extent_; }

  /// For a box, with a radius or without, the numbers that formulas for boxes read; for any other shape its slack is
  /// infinite.
  [[nodiscard]] const RigidBox& as_box() const { return box_; }

 private:
  enum class Bound { none, undeformed, regular };

  /// Up to eight vertices, to the world.
  template <std::size_t count>
  void place(const std::array<Vec3, count>& local, std::string_view who, Bound bound);
  /// Throws Error where the constructors say so.
  void check(std::span<const Vec3> local, std::string_view who, Bound bound) const;

  alignas(64) std::array<std::array<double, 8>, 3> few_;  // the world coordinates of up to eight vertices
  std::array<const double*, 3> along_{};                  // into few_, or into the hull
  RigidBox box_;
  Pose pose_;
  HullTopology topology_;
  double radius_ = 0;
  double stored_extent_ = 0;
  Index count_ = 0;
  bool in_world_ = true;
  bool solid_ = false;
};

}  // namespace toccata
