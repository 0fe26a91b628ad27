#include "world/character_mover/motion_planes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// Planes in the order in which the search needed them, and what lies on up to three of them.
class PlaneCorners {
 public:
  PlaneCorners(const Vec3& wanted, double tolerance) : wanted_(wanted), tolerance_(tolerance) {}

  void add(const MotionPlane& plane) { planes_.push_back(plane); }

  /// Nearest of all that keep to the planes and lie on the last of them: what lies on none of it was not enough.
  [[nodiscard]] std::optional<Vec3> nearest() {
    nearest_.reset();
    const std::size_t last = planes_.size() - 1;
    see(on_plane(planes_[last]));
    for (std::size_t i = 0; i < last; ++i) see(on_line(planes_[last], planes_[i]));
    for (std::size_t i = 0; i < last; ++i)
      for (std::size_t j = 0; j < i; ++j) see(at_corner(planes_[last], planes_[i], planes_[j]));
    return nearest_;
  }

 private:
  [[nodiscard]] Vec3 on_plane(const MotionPlane& p) const {
    return wanted_ + (p.at_least - dot(p.normal, wanted_)) * p.normal;
  }

  [[nodiscard]] std::optional<Vec3> on_line(const MotionPlane& p, const MotionPlane& q) const {
    const Vec3 line = cross(p.normal, q.normal);
    const double square = dot(line, line);
    if (!(square > flat_square)) return {};
    const Vec3 foot = (p.at_least / square) * cross(q.normal, line) + (q.at_least / square) * cross(line, p.normal);
    return foot + (dot(line, wanted_) / square) * line;
  }

  [[nodiscard]] static std::optional<Vec3> at_corner(const MotionPlane& p, const MotionPlane& q, const MotionPlane& r) {
    const Vec3 line = cross(q.normal, r.normal);
    const double volume = dot(p.normal, line);
    if (!(std::abs(volume) > flat_volume)) {
      const bool is_origin = p.at_least == 0 && q.at_least == 0 && r.at_least == 0;
      return is_origin ? std::optional(Vec3{}) : std::nullopt;
    }
    return (1 / volume) *
           (p.at_least * line + q.at_least * cross(r.normal, p.normal) + r.at_least * cross(p.normal, q.normal));
  }

  void see(const std::optional<Vec3>& motion) {
    if (!motion) return;
    const Vec3 change = *motion - wanted_;
    const double cost = dot(change, change);
    if (nearest_ && !(cost < cost_)) return;
    for (const MotionPlane& plane : planes_)
      if (!(dot(plane.normal, *motion) >= plane.at_least - tolerance_)) return;
    nearest_ = motion;
    cost_ = cost;
  }

  // Two planes within 10⁻⁷ of parallel have no line that doubles tell, and three no corner.
  static constexpr double flat_square = 1e-14, flat_volume = 1e-10;

  Vec3 wanted_;
  double tolerance_;
  std::vector<MotionPlane> planes_;
  std::optional<Vec3> nearest_;
  double cost_ = 0;
};

std::optional<Vec3> nearest_on(const Vec3& wanted, std::span<const MotionPlane> planes) {
  double size = length(wanted);
  for (const MotionPlane& plane : planes) size = std::max(size, std::abs(plane.at_least));
  const double tolerance = 0x1p-44 * size;
  PlaneCorners corners(wanted, tolerance);
  Vec3 motion = wanted;
  // Each round takes the plane that is broken the most; more than a few are needed by no motion.
  for (std::size_t round = 0; round < 24; ++round) {
    double worst = -tolerance;
    const MotionPlane* broken = nullptr;
    for (const MotionPlane& plane : planes)
      if (const double excess = dot(plane.normal, motion) - plane.at_least; excess < worst) {
        worst = excess;
        broken = &plane;
      }
    if (broken == nullptr) return motion;
    corners.add(*broken);
    const std::optional<Vec3> nearest = corners.nearest();
    if (!nearest) return {};
    motion = *nearest;
  }
  return {};
}

}  // namespace

std::optional<Vec3> nearest_motion(const Vec3& wanted, std::span<const MotionPlane> planes, const MotionCost& cost) {
  if (cost.height == 1) return nearest_on(wanted, planes);
  const auto stretched = [&](const Vec3& v, double factor) { return v + ((factor - 1) * dot(cost.up, v)) * cost.up; };
  std::vector<MotionPlane> changed;
  changed.reserve(planes.size());
  for (const MotionPlane& plane : planes) {
    const Vec3 normal = stretched(plane.normal, 1 / cost.height);
    const double size = length(normal);
    changed.push_back({normal / size, plane.at_least / size});
  }
  const std::optional<Vec3> found = nearest_on(stretched(wanted, cost.height), changed);
  return found ? std::optional(stretched(*found, 1 / cost.height)) : std::nullopt;
}

}  // namespace toccata
