#include "world/body_box.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "math/world_vertex.hpp"
#include "narrow/pose_checks.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The least and the greatest of eight sums of three products at a time: what a compiler makes vectors of.
void widen(const std::array<const double*, 3>& local, const Vec3& row, double offset, double& lower, double& upper) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> world;
  for (std::size_t i = 0; i < lanes; ++i)
    world[i] = ((row.x * local[0][i] + row.y * local[1][i]) + row.z * local[2][i]) + offset;
  for (const double value : world) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
}

/// Boxes of shapes under a pose that is a rotation but for a few roundings, so that it is one which they may all have;
/// none where numbers are so great that more has to be looked at, or for a shape that is seldom.
struct QuickBox {
  std::optional<Aabb> operator()(const Sphere& sphere) const {
    if (!is_surely_finite(sphere.centre()) || !(sphere.radius() < 0x1p1000)) return {};
    const Vec3 centre = world_vertex(pose, sphere.centre());
    return grown(Aabb{centre, centre}, sphere.radius());
  }

  std::optional<Aabb> operator()(const Capsule& capsule) const {
    if (!is_surely_finite(capsule.start()) || !is_surely_finite(capsule.end()) || !(capsule.radius() < 0x1p1000))
      return {};
    const Vec3 start = world_vertex(pose, capsule.start());
    return grown(merge({start, start}, world_vertex(pose, capsule.end())), capsule.radius());
  }

  /// The least of all sums is the sum of the least, as rounding keeps the order.
  std::optional<Aabb> operator()(const Box& box) const {
    const Vec3 lower = box.centre() - box.half_extents(), upper = box.centre() + box.half_extents();
    if (!is_surely_finite(lower) || !is_surely_finite(upper)) return {};
    Aabb world;
    for (int i = 0; i < 3; ++i) {
      const Vec3& row = pose.linear[i];
      const auto [x0, x1] = std::minmax({row.x * lower.x, row.x * upper.x});
      const auto [y0, y1] = std::minmax({row.y * lower.y, row.y * upper.y});
      const auto [z0, z1] = std::minmax({row.z * lower.z, row.z * upper.z});
      world.lower[i] = ((x0 + y0) + z0) + pose.offset[i];
      world.upper[i] = ((x1 + y1) + z1) + pose.offset[i];
    }
    return world;
  }

  std::optional<Aabb> operator()(const ConvexHull& hull) const {
    if (hull.dimension() != 3 || !(hull.largest_coordinate() < 0x1p998)) return {};
    std::array<const double*, 3> local{};
    for (std::size_t axis = 0; axis < 3; ++axis) local[axis] = hull.padded_coordinates(static_cast<int>(axis)).data();
    Aabb world;
    const Index count = (hull.vertex_count() + 7) / 8 * 8;
    for (Index first = 0; first < count; first += 8) {
      for (int i = 0; i < 3; ++i) widen(local, pose.linear[i], pose.offset[i], world.lower[i], world.upper[i]);
      for (const double*& coordinates : local) coordinates += 8;
    }
    return world;
  }

  template <class Other>
  std::optional<Aabb> operator()(const Other&) const {
    return {};
  }

  const Pose& pose;
};

Aabb posed_box(const Body& body, const Pose& pose, std::string_view who) {
  if (is_surely_rigid(pose.linear) && is_surely_finite(pose.offset))
    if (const std::optional<Aabb> box = std::visit(QuickBox{pose}, body.model.shape())) return *box;
  if (std::holds_alternative<Compound>(body.model.shape()))
    return world_box(pose_model(body.model, pose, body.solid, who));
  return world_box(pose_shape(body.model, pose, body.solid, who));
}

}  // namespace

Aabb body_box(const Body& body, const Pose& pose, FunctionRef<std::string()> who) {
  try {
    return posed_box(body, pose, "the body");
  } catch (const Error&) {
    return posed_box(body, pose, who());  // names are made where they are needed
  }
}

}  // namespace toccata
