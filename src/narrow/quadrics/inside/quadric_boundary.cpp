#include "toccata/narrow/quadrics.hpp"

#include <array>
#include <cmath>

#include "narrow/quadrics/distance/quadric_proof.hpp"
#include "narrow/quadrics/inside/quadric_foot.hpp"

namespace toccata {
namespace {

/// How far a point within a shape is from its boundary: no farther than from any plane that the shape lies behind, and
/// no nearer than the radius of a ball around it that the shape holds.
class DepthSearch {
 public:
  DepthSearch(const PosedQuadric& shape, const Vec3& point)
      : frame_(pair_frame(shape, shape)),
        body_(shape, frame_),
        unit_(body_),
        at_(frame_.place(point)),
        alone_(at_),
        foot_(quadric_foot(unit_, at_)) {}

  [[nodiscard]] BoundaryPoint found() {
    look_at_planes();
    if (foot_) look_at_side();
    BoundaryPoint result;
    result.side = Sign::negative;
    const double lower = std::isfinite(upper_) ? proved_lower() : 0;
    result.upper = std::nextafter(upper_ / frame_.factor, HUGE_VAL);
    result.lower = std::fmax(std::nextafter(lower / frame_.factor, 0), 0);
    result.point = frame_.back(nearest_);
    if (!(result.upper - result.lower <= relative_width * result.upper)) result.status = Status::not_converged;
    return result;
  }

 private:
  /// How far the plane is that touches the shape across a direction; true when it is the nearest.
  bool look_along(const FineDirection& direction) {
    const double height = -gap_along<BoundedNumber>(alone_, body_, direction);
    if (!(height < upper_)) return false;
    upper_ = height;
    return true;
  }

  /// Looks at the planes of caps, where the foot is what is nearest to the point in the plane.
  void look_at_planes() {
    if (unit_.caps() == 0) return;
    const BoundedVector& up = unit_.row(2);
    look_at_plane(up);
    if (unit_.caps() == 2) look_at_plane({-up[0], -up[1], -up[2]});
  }

  void look_at_plane(const BoundedVector& normal) {
    if (!look_along(vector_as<DoubleWord>(normal))) return;
    const BoundedNumber part = exactly(upper_) / length(normal);
    nearest_ = plain(at_ + part * normal);
  }

  void look_at_side() {
    if (!look_along(foot_->normal)) return;
    BoundedVector point = unit_.origin();
    for (std::size_t i = 0; i < 3; ++i) point[i] = point[i] + BoundedNumber{foot_->point[i], 0};
    nearest_ = plain(point);
  }

  [[nodiscard]] double proved_lower() const {
    for (const double part : {3e-13, 8e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3, 1e-1, 0.5}) {
      const double radius = upper_ * (1 - part);
      const UnitGenerator ball = unit_.ball(at_, radius);
      if ((foot_ && is_held_by(unit_, ball, foot_->multiplier)) || is_held(unit_, ball) == Within::yes) return radius;
    }
    return 0;
  }

  PairFrame frame_;
  QuadricBody body_;
  UnitFrame unit_;
  BoundedVector at_;
  QuadricBody alone_;
  std::optional<QuadricFoot> foot_;
  double upper_ = HUGE_VAL;
  Vec3 nearest_;
};

BoundaryPoint from_outside(const Vec3& point, const PosedQuadric& shape) {
  const Distance found = distance(shape, PosedPolytope(Point{point}));
  BoundaryPoint result{Sign::positive, found.lower, found.upper, found.on_a, Status::exact};
  if (!(result.upper - result.lower <= relative_width * result.upper)) result.status = Status::not_converged;
  return result;
}

}  // namespace

BoundaryPoint boundary_point(const Vec3& point, const PosedQuadric& shape) {
  const Sign side = side_of(point, shape);
  if (side == Sign::zero) return {side, 0, 0, point, Status::exact};
  return side == Sign::positive ? from_outside(point, shape) : DepthSearch(shape, point).found();
}

}  // namespace toccata
