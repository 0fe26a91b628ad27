#include "world/body_box.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "math/constants.hpp"
#include "math/world_vertex.hpp"
#include "narrow/pose_checks.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The least and the greatest world coordinate of a hull along an axis. Eight vertices at a time, which compilers make
/// vectors of.
std::pair<double, double> range_along(const ConvexHull& hull, const Vec3& row, double offset) {
  constexpr std::size_t lanes = 8;
  const std::span<const double> x = hull.padded_coordinates(0), y = hull.padded_coordinates(1);
  const std::span<const double> z = hull.padded_coordinates(2);
  std::array<double, lanes> least, greatest;
  least.fill(infinity);
  greatest.fill(-infinity);
  for (std::size_t first = 0; first < x.size(); first += lanes)
    for (std::size_t i = 0; i < lanes; ++i) {
      const double sum = (row.x * x[first + i] + row.y * y[first + i]) + row.z * z[first + i];
      least[i] = sum < least[i] ? sum : least[i];
      greatest[i] = sum > greatest[i] ? sum : greatest[i];
    }
  // The last sum keeps the order.
  return {*std::min_element(least.begin(), least.end()) + offset,
          *std::max_element(greatest.begin(), greatest.end()) + offset};
}

/// Boxes of shapes under a pose that is a rotation but for a few roundings, so that it is one which they may all have;
/// none where numbers are so great that more has to be looked at, or for a shape that is seldom.
struct FastBox {
  std::optional<Aabb> operator()(const Sphere& sphere) const {
    if (!is_surely_finite(sphere.centre()) || !(sphere.radius() < 0x1p1000)) return {};
    const Vec3 centre = world_vertex(pose, sphere.centre());
    return widened(Aabb{centre, centre}, sphere.radius());
  }

  std::optional<Aabb> operator()(const Capsule& capsule) const {
    if (!is_surely_finite(capsule.start()) || !is_surely_finite(capsule.end()) || !(capsule.radius() < 0x1p1000))
      return {};
    const Vec3 start = world_vertex(pose, capsule.start());
    return widened(merge({start, start}, world_vertex(pose, capsule.end())), capsule.radius());
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
    Aabb world;
    for (int i = 0; i < 3; ++i)
      std::tie(world.lower[i], world.upper[i]) = range_along(hull, pose.linear[i], pose.offset[i]);
    return world;
  }

  std::optional<Aabb> operator()(const std::shared_ptr<const TriangleMesh>&) const {
    if (body.solid == Solid::all && !body.model.closed()) return {};
    return rigid_world_box(body.model, pose);
  }

  template <class Other>
  std::optional<Aabb> operator()(const Other&) const {
    return {};
  }

  const Body& body;
  const Pose& pose;
};

Aabb posed_box(const Body& body, const Pose& pose, std::string_view who) {
  if (is_surely_rigid(pose.linear) && is_surely_finite(pose.offset))
    if (const std::optional<Aabb> box = std::visit(FastBox{body, pose}, body.model.shape())) return *box;
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
