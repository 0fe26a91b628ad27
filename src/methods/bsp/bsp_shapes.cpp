#include <algorithm>
#include <optional>

#include "math/constants.hpp"
#include "methods/bsp/bsp_bevels.hpp"
#include "methods/bsp/bsp_sweep.hpp"
#include "query/casts/mesh_casts.hpp"
#include "toccata/core/error.hpp"

// A convex shape against the solid of a BSP tree, standing or moving straight on.
namespace toccata {
namespace {

void require_finite_motion(const Vec3& motion) {
  if (!is_finite(motion)) throw Error("the motion has a coordinate that is not finite");
}

/// The triangles that a sweep comes to are cast once each, until the first meeting found.
class FirstTriangle {
 public:
  FirstTriangle(const BspTree::Parts& parts, const PosedPolytope& shape, const Vec3& motion)
      : parts_(parts), shape_(shape), motion_(motion), is_cast_(parts.planes.triangle_count()) {}

  std::optional<ShapeHit> answer() {
    BspSweep sweep(parts_, shape_, motion_);
    sweep.run([&](Index number, const BspStretch& in_plane) {
      const Triangle triangle = parts_.planes.triangle(number);
      if (is_of_interest(number) && sweep.may_meet(triangle, in_plane)) cast(number, triangle);
      return limit_;
    });
    return first_;
  }

 private:
  /// Whether a triangle is still to be cast: once one is met at the start, only a lesser one.
  [[nodiscard]] bool is_of_interest(Index number) const {
    return !is_cast_[number] && !(first_ && first_->upper == 0 && first_->element_b < number);
  }

  void cast(Index number, const Triangle& triangle) {
    is_cast_[number] = true;
    const auto found = cast_convex_until(shape_, motion_, PosedPolytope(triangle), limit_, kept_);
    if (!found) return;
    keep_first(first_, {*found, 0, number, 0, parts_.planes.mesh().face_of(number)});
    limit_ = std::min(limit_, first_->upper + widest_cast);
  }

  const BspTree::Parts& parts_;
  const PosedPolytope& shape_;
  Vec3 motion_;
  std::vector<bool> is_cast_;
  SimplexCache kept_;
  double limit_ = 1;
  std::optional<ShapeHit> first_;
};

}  // namespace

bool BspTree::overlap(const PosedPolytope& shape) const {
  if (locate(shape.vertex(0)).side != Side::outside) return true;
  BspSweep sweep(*parts_, shape, {});
  SimplexCache kept;
  bool met = false;
  sweep.run([&](Index number, const BspStretch& in_plane) {
    const Triangle triangle = parts_->planes.triangle(number);
    met = met || (sweep.may_meet(triangle, in_plane) && toccata::overlap(shape, PosedPolytope(triangle), &kept));
    return met ? -infinity : 1;
  });
  return met;
}

std::optional<ShapeHit> BspTree::cast_shape(const PosedPolytope& shape, const Vec3& motion) const {
  require_finite_motion(motion);
  const Vec3 point = shape.vertex(0);
  const bool starts_inside = locate(point).side == Side::inside;
  const std::optional<ShapeHit> first = FirstTriangle(*parts_, shape, starts_inside ? Vec3{} : motion).answer();
  if (first || !starts_inside) return first;
  ShapeHit held;
  held.point = point;
  return held;
}

std::optional<BspTrace> BspTree::trace(const PosedPolytope& shape, const Vec3& motion, BspBevels bevels) const {
  require_finite_motion(motion);
  BspSweep sweep(*parts_, shape, motion);
  std::optional<BspTrace> result;
  sweep.run_through_cells([&](const BspStretch& in_cell) {
    const BevelledStretch entered =
        bevels == BspBevels::none ? BevelledStretch{in_cell} : narrowed_by_bevels(sweep, in_cell);
    if (entered.stretch.is_empty()) return infinity;
    const double time = std::max(0.0, sweep.time_before(entered.stretch));
    if (!result || time < result->time)
      result = {time, entered.normal == Vec3{} ? sweep.entered_across(entered.stretch)
                                               : sweep.against_motion(entered.normal)};
    return result->time > 0 ? result->time : -infinity;
  });
  return result;
}

}  // namespace toccata
