#include "query/casts/swept_view.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "query/meshes/cull_bounds.hpp"
#include "query/meshes/pair_cull.hpp"
#include "trees/prism_directions.hpp"

// The names and the bounds are those of docs/design/culling.md.
namespace toccata {
namespace {

/// Numbers below this neither overflow nor are they the differences of such that did.
constexpr double largest_swept_size = 0x1p1000;

/// One thing along a direction.
struct HeightsAlong {
  Vec3 form{};
  double offset = 0;
  HeightRange whole;
  double size = 0;         ///< Σ |L_k| S_k, and what the tree's units add
  double coordinates = 0;  ///< what smallest doubles are multiplied with
};

HeightsAlong along(const PosedMesh& mesh, const Vec3& direction) {
  const WideBvh& tree = mesh.model().wide_bvh();
  const Mat3& linear = mesh.pose().linear;
  const Vec3 on = transpose(linear) * direction;
  const double at_origin = dot(direction, mesh.pose().offset);
  const FormRange range = range_of(on, tree.box);
  // A box of a flat tree may be as thick as a last place of the tree's unit, and much is made of that by such a pose.
  const Vec3 units{sum_of_magnitudes(linear[0]), sum_of_magnitudes(linear[1]), sum_of_magnitudes(linear[2])};
  return {tree.unit * on,
          dot(on, tree.origin) + at_origin,
          {range.low + at_origin, range.high + at_origin},
          dot(magnitudes(direction), world_sizes(mesh) + (2 * tree.unit) * units),
          sum_of_magnitudes(largest_coordinates(mesh))};
}

HeightsAlong along(const PosedPolytope& shape, const Vec3& direction) {
  const SupportKernels kernels = support_kernels();
  const SupportSearch support(shape, kernels);
  const double reach = shape.radius() * plain_length(direction) * (1 + 0x1p-50);
  const double low = support.lower_bound(direction) - reach, high = -support.lower_bound(-direction) + reach;
  HeightsAlong result;
  const bool is_known = in_certain_range(direction) && std::isfinite(low) && std::isfinite(high);
  result.whole = is_known ? HeightRange{low, high} : HeightRange{-infinity, infinity};
  // Both are certain; what is computed with them is not.
  result.size = is_known ? std::max(std::fabs(low), std::fabs(high)) : 0;
  return result;
}

HeightsAlong along(const PosedQuadric& shape, const Vec3& direction) {
  const Mat3& linear = shape.pose().linear;
  const Vec3& half = shape.half();
  const Vec3 on = transpose(linear) * direction;
  const double middle = dot(direction, shape.pose().offset);
  Vec3 largest = magnitudes(shape.pose().offset);
  for (int i = 0; i < 3; ++i) largest[i] += dot(magnitudes(linear[i]), half);
  HeightsAlong result;
  result.size = dot(magnitudes(direction), largest);
  result.coordinates = sum_of_magnitudes(largest) + sum_of_magnitudes(half);
  const QuadricReach reach =
      with_kind(shape.kind(), [&](auto kind) { return kind.reach(half.x * on.x, half.y * on.y, half.z * on.z); });
  result.whole = {middle - reach.down, middle + reach.up};
  return result;
}

HeightsAlong along(const PosedHalfSpace& half_space, const Vec3& direction) {
  const double height = dot(direction, half_space.point);
  HeightsAlong result;
  const bool is_above = dot(direction, half_space.normal) < 0;
  result.whole = is_above ? HeightRange{height, infinity} : HeightRange{-infinity, height};
  result.size = dot(magnitudes(direction), magnitudes(half_space.point));
  return result;
}

Vec3 upwards(const Vec3& direction, const Vec3& motion) { return dot(direction, motion) < 0 ? -direction : direction; }

/// No more of rounding than of the mesh that it is of.
HeightRange heights_of(const Triangle& triangle, const Vec3& direction) {
  const auto [low, high] =
      std::minmax({dot(direction, triangle[0]), dot(direction, triangle[1]), dot(direction, triangle[2])});
  return {low, high};
}

bool is_usable(const SweptDirection& d, double size) {
  return size < largest_swept_size && d.pad < largest_swept_size && std::isfinite(d.per_speed) &&
         is_finite(d.form[0]) && is_finite(d.form[1]) && std::isfinite(d.offset[0]) && std::isfinite(d.offset[1]);
}

}  // namespace

/// The pad: four times that of two things that stand, for heights are computed from the trees' units, and as much again
/// so that the speed need not be 0.
template <class A, class B>
void SweptView::add(const A& a, const Vec3& motion, const B& b, const Vec3& direction) {
  const Vec3 up = upwards(direction, motion);
  const HeightsAlong of_a = along(a, up), of_b = along(b, up);
  const double speed = dot(up, motion), moved = dot(magnitudes(up), magnitudes(motion));
  const double size = (of_a.size + of_b.size) + moved;
  const double underflowed = (1 + sum_of_magnitudes(up)) + (of_a.coordinates + of_b.coordinates);
  const double pad = 64 * unit_roundoff * size + (underflow_of(64 * underflowed, size) + 0x1p-960);
  SweptDirection result;
  result.form = {of_a.form, of_b.form};
  result.offset = {of_a.offset, of_b.offset};
  result.whole = {of_a.whole, of_b.whole};
  result.pad = 2 * pad;
  result.per_speed = 1 / std::max(speed, pad);
  if (is_usable(result, size) && count_ < directions_.size()) directions_[count_++] = result;
}

/// The normals of the mesh's boxes, and those that cut off the edges and corners of what they leave around a convex
/// shape: of what is tested exactly, two thirds less for a ball as large as a few triangles, and more for larger ones.
template <class A, class B>
void SweptView::add_around(const PosedMesh& mesh, const A& a, const Vec3& motion, const B& b) {
  const PairCull cull(mesh, mesh);
  const auto normals = cull.directions();
  for (const CullDirection& d : normals) add(a, motion, b, d.world);
  if (normals.size() < 3) return;
  const Vec3 x = normals[0].world, y = normals[1].world, z = normals[2].world;
  for (const Vec3& edge : {x + y, x - y, y + z, y - z, x + z, x - z}) add(a, motion, b, edge);
  for (const Vec3& corner : {x + y + z, x + y - z, x - y + z, x - y - z}) add(a, motion, b, corner);
}

SweptView::SweptView(const PosedMesh& a, const Vec3& motion, const PosedMesh& b) {
  const PairCull cull(a, b);
  for (const CullDirection& d : cull.directions()) add(a, motion, b, d.world);
}

SweptView::SweptView(const PosedMesh& a, const Vec3& motion, const PosedMesh& b, std::size_t side, Index triangle) {
  const Triangle of_side = (side == 0 ? a : b).triangle(triangle);
  for (const Vec3& direction : prism_directions(of_side.vertex)) {
    const std::size_t before = count_;
    add(a, motion, b, direction);
    if (count_ > before) directions_[before].whole[side] = heights_of(of_side, upwards(direction, motion));
  }
}

SweptView::SweptView(const PosedMesh& a, const Vec3& motion, const PosedPolytope& b) { add_around(a, a, motion, b); }

SweptView::SweptView(const PosedPolytope& a, const Vec3& motion, const PosedMesh& b) { add_around(b, a, motion, b); }

SweptView::SweptView(const PosedMesh& a, const Vec3& motion, const PosedQuadric& b) { add_around(a, a, motion, b); }

SweptView::SweptView(const PosedQuadric& a, const Vec3& motion, const PosedMesh& b) { add_around(b, a, motion, b); }

SweptView::SweptView(const PosedMesh& a, const Vec3& motion, const PosedHalfSpace& b) {
  add(a, motion, b, near_unit(b.normal));
}

SweptView::SweptView(const PosedHalfSpace& a, const Vec3& motion, const PosedMesh& b) {
  add(a, motion, b, near_unit(a.normal));
}

}  // namespace toccata
