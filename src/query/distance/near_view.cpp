#include "query/distance/near_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "query/meshes/cull_bounds.hpp"
#include "query/posed_shape.hpp"

namespace toccata {
namespace {

// Within these, squares of lengths and of errors are ordinary doubles.
constexpr double smallest_near_size = 1e-100;
constexpr double largest_near_size = 1e100;

double sum_of_magnitudes(const Mat3& m) {
  return (sum_of_magnitudes(m[0]) + sum_of_magnitudes(m[1])) + sum_of_magnitudes(m[2]);
}

Mat3 scaled(double factor, const Mat3& m) { return {{factor * m[0], factor * m[1], factor * m[2]}}; }

/// aᵀ b.
Mat3 transposed_times(const Mat3& a, const Mat3& b) {
  Mat3 product;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product[i][j] = dot(a.column(i), b.column(j));
  return product;
}

/// For a rotation times a number, that number; for anything else it says nothing.
double factor_of(const Mat3& m) { return std::sqrt((dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2])) / 3); }

Aabb core_box(const PosedPolytope& shape) {
  Aabb box;
  for (Index i = 0; i < shape.vertex_count(); ++i) box = merge(box, shape.vertex(i));
  return box;
}

bool is_ordinary(double size) { return size > smallest_near_size && size < largest_near_size; }

/// How far world coordinates are from the real numbers that they round, and what was rounded on the way to an offset.
double rounding_of(const NearFrame& own, const NearFrame& other) {
  return 64 * unit_roundoff * (sum_of_magnitudes(own.sizes) + sum_of_magnitudes(other.sizes));
}

NearView general_view(const NearFrame& own, const NearFrame& other) {
  NearView view;
  view.rigid = false;
  view.own = scaled(own.unit, own.linear);
  view.other = scaled(other.unit, other.linear);
  view.offset = other.offset - own.offset;
  const double size = (sum_of_magnitudes(view.own) + sum_of_magnitudes(view.other)) + sum_of_magnitudes(view.offset);
  view.pad = 0x1p-40 * size + rounding_of(own, other);
  view.scale = is_ordinary(size) ? 1 : std::numeric_limits<double>::quiet_NaN();
  return view;
}

}  // namespace

NearFrame near_frame(const PosedMesh& mesh) {
  const WideBvh& tree = mesh.model().wide_bvh();
  return {mesh.pose().linear, transform(mesh.pose(), tree.origin), tree.unit, world_sizes(mesh)};
}

ConvexNearBvh::ConvexNearBvh(const PosedPolytope& shape) : ConvexNearBvh(core_box(shape)) {}
ConvexNearBvh::ConvexNearBvh(const PosedQuadric& shape) : ConvexNearBvh(world_box(shape)) {}

ConvexNearBvh::ConvexNearBvh(const Aabb& box) {
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper;
  frame.offset = middle;
  const Vec3 half{std::max(box.upper.x - middle.x, middle.x - box.lower.x),
                  std::max(box.upper.y - middle.y, middle.y - box.lower.y),
                  std::max(box.upper.z - middle.z, middle.z - box.lower.z)};
  const double largest = std::max({half.x, half.y, half.z});
  frame.unit =
      largest > smallest_near_size && largest < largest_near_size ? std::exp2(std::ceil(std::log2(largest))) : 1;
  const bool is_plain = largest < largest_near_size;
  OrientedBox lane;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = half[axis] / frame.unit * (1 + 0x1p-20) + 1e-30;
    lane.extent[static_cast<std::size_t>(axis)] = static_cast<float>(extent);
    frame.sizes[axis] = std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]));
  }
  if (!is_plain) frame.sizes.x = infinity;  // no bound is known then
  block.count = 1;
  block.child[0] = ~0;
  for (std::size_t i = 0; i < OrientedBlock::width; ++i) set_lane(block, i, i == 0 ? lane : OrientedBox{});
}

NearView near_view(const NearFrame& own, const NearFrame& other) {
  const double own_factor = factor_of(own.linear), other_factor = factor_of(other.linear);
  const Mat3 own_rotation = scaled(1 / own_factor, own.linear), other_rotation = scaled(1 / other_factor, other.linear);
  if (!is_ordinary(own_factor) || !is_ordinary(other_factor) || !is_surely_rigid(own_rotation) ||
      !is_surely_rigid(other_rotation))
    return general_view(own, other);
  NearView view;
  view.scale = own_factor * own.unit;
  view.ratio = other_factor * other.unit / view.scale;
  view.rotation = transposed_times(own_rotation, other_rotation);
  const Vec3 between = (1 / view.scale) * (other.offset - own.offset);
  view.offset = {dot(own_rotation.column(0), between), dot(own_rotation.column(1), between),
                 dot(own_rotation.column(2), between)};
  const double size = 4 + (4 * view.ratio + sum_of_magnitudes(view.offset));
  view.pad = 0x1p-36 * size + rounding_of(own, other) / view.scale;
  if (!is_ordinary(view.scale) || !(size < largest_near_size) || !(view.pad < largest_near_size))
    view.scale = std::numeric_limits<double>::quiet_NaN();
  return view;
}

}  // namespace toccata
