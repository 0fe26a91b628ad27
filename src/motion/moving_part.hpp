#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/point_bounds.hpp"
#include "query/posed_shape.hpp"
#include "toccata/motion/rigid_motion.hpp"

namespace toccata {

/// How a part moves within a stretch: all its points with one velocity, and beyond that about an axis through a centre,
/// which goes along, or about the centre however it will.
struct PartMotion {
  Pose pose;            ///< of the part, when the move began
  Vec3 centre;          ///< in the world, at that time
  Vec3 axis{};          ///< of length 1; zero: any
  double rate = 0;      ///< radians per unit of time
  MotionBounds alike;   ///< of the points on the axis
  double reach = 0;     ///< no point of the part's core is farther from the axis
  double rounding = 0;  ///< more than a reach may be off that is computed from a point of the part

  /// How far a world point, as it is under `pose`, is from the axis, but for rounding.
  [[nodiscard]] double reach_of(const Vec3& point) const {
    const Vec3 from = point - centre;
    return length(axis == Vec3{} ? from : from - dot(from, axis) * axis);
  }

  /// The bounds for points that are no farther than `within` from the axis.
  [[nodiscard]] MotionBounds bounds(double within) const {
    MotionBounds bounds = alike;
    bounds.speed += rate * within;
    bounds.bending += rate * rate * within;
    return bounds;
  }
};

/// What of a shape turns with it, in its own frame, and how far the shape reaches beyond that along every direction, at
/// every time: of a ball, a capsule or a rounded shape its radius. All else is its own core.
struct MovingCore {
  std::vector<Vec3> outline;  ///< their hull contains the core; of a half-space its point
  double radius = 0;
};

/// A shape of a model that moves, which is no compound: the model itself, or a part of it.
class MovingPart {
 public:
  /// `chain`: the poses of the compounds that it is in and its own, from the outermost.
  MovingPart(const Model& shape, std::vector<Pose> chain, const RigidMotion& motion, Solid solid, std::string_view who);

  /// Where its elements and faces begin to be counted.
  Index first_element = 0;
  Index first_face = 0;

  [[nodiscard]] const Model& shape() const { return *shape_; }
  [[nodiscard]] ShapeKind kind() const { return kind_of(shape_->shape()); }
  [[nodiscard]] bool is_half_space() const { return kind() == ShapeKind::half_space; }

  /// Throws Error when the motion is told by a function and has moved faster than its bound since it was last asked.
  [[nodiscard]] Pose pose_at(double time) const;
  [[nodiscard]] PosedShape at(double time) const { return pose_shape(*shape_, pose_at(time), solid_, who_); }
  /// The same of a convex shape, as what it is known to be.
  template <PosedConvexSet S>
  [[nodiscard]] S convex_at(double time) const {
    return pose_convex<S>(*shape_, pose_at(time), who_);
  }

  [[nodiscard]] PartMotion motion(const TimeStretch& stretch) const;

  /// How much a direction of it may be off when it is posed in doubles.
  [[nodiscard]] double pose_error(const TimeStretch& stretch) const;

  [[nodiscard]] const MovingCore& core() const { return core_; }

 private:
  struct Sample {
    double time;
    Pose pose;
  };

  [[nodiscard]] const RigidMotion::Piece* piece(const TimeStretch& stretch) const;
  [[nodiscard]] Pose through_chain(Pose pose) const;
  [[nodiscard]] double size(const Pose& start) const;
  [[nodiscard]] double farthest_reach(const PartMotion& motion) const;
  void require_bound(const Sample& before, const Sample& now) const;

  const Model* shape_;
  std::vector<Pose> chain_;
  const RigidMotion* motion_;
  Solid solid_;
  std::string_view who_;
  MovingCore core_;
  mutable std::optional<Sample> last_;  ///< of a function
};

/// All shapes of a model. They refer to the model and to the motion.
[[nodiscard]] std::vector<MovingPart> moving_parts(const Model& model, const RigidMotion& motion, Solid solid,
                                                   std::string_view who);

/// Bounds for the gap between every two points, one of each core: what parts two shapes along a direction is what parts
/// their cores, less both radii, which do not change. For a half-space they bound how high points of the other's core
/// are above it.
[[nodiscard]] GapBounds gap_bounds(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch);

}  // namespace toccata
