#include "query/meshes/pair_cull.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// The direction of v with a largest coordinate of 1; not finite where v is zero or not finite.
Vec3 of_size_one(const Vec3& v) {
  const double size = largest_magnitude(v);
  return {v.x / size, v.y / size, v.z / size};
}

/// The square of the largest entry: areas grow about as much.
double area_scale(const Mat3& linear) {
  const double size =
      std::max({largest_magnitude(linear[0]), largest_magnitude(linear[1]), largest_magnitude(linear[2])});
  return size * size;
}

/// The posed axes are about at right angles, whatever their lengths.
bool spreads_well(const Mat3& linear) {
  const Vec3 u = of_size_one(linear.column(0)), v = of_size_one(linear.column(1)), w = of_size_one(linear.column(2));
  const double volume = dot(cross(u, v), w);
  return 2 * volume * volume >= (dot(u, u) * dot(v, v)) * dot(w, w);
}

bool is_usable(const CullDirection& d) {
  return is_finite(d.world) && is_finite(d.on_a) && is_finite(d.on_b) && std::isfinite(d.offset) &&
         std::isfinite(d.pad);
}

}  // namespace

PairCull::PairCull(const PosedMesh& a, const PosedMesh& b, double pad_scale)
    : pad_scale_(pad_scale),
      world_sizes_(world_sizes(a) + world_sizes(b)),
      coordinates_(sum_of_magnitudes(largest_coordinates(a)) + sum_of_magnitudes(largest_coordinates(b))),
      area_scale_a_(area_scale(a.pose().linear)),
      area_scale_b_(area_scale(b.pose().linear)) {
  add_box_normals(a, a, b);
  add_box_normals(b, a, b);
  // The normals of rigidly posed boxes are enough; those of a flattened or strongly sheared one may all be alike.
  if (spreads_well(a.pose().linear) && spreads_well(b.pose().linear)) return;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) add(axis, a, b);
}

/// The sides of a local box that is posed by R have the rows of R's inverse as normals; up to a factor these are the
/// cross products of its columns, which exist for a singular R as well.
void PairCull::add_box_normals(const PosedMesh& of, const PosedMesh& a, const PosedMesh& b) {
  const Mat3& linear = of.pose().linear;
  for (int i = 0; i < 3; ++i) {
    const Vec3 u = of_size_one(linear.column((i + 1) % 3));
    const Vec3 v = of_size_one(linear.column((i + 2) % 3));
    add(of_size_one(cross(u, v)), a, b);
  }
}

/// pad(L) of docs/design/culling.md.
double PairCull::pad_of(const Vec3& world) const {
  const Vec3 size = magnitudes(world);
  const double underflowed = 1 + sum_of_magnitudes(size) + coordinates_;
  return pad_scale_ * culling_pad(dot(size, world_sizes_), underflowed);
}

void PairCull::add(const Vec3& world, const PosedMesh& a, const PosedMesh& b) {
  CullDirection direction;
  direction.world = world;
  direction.on_a = transpose(a.pose().linear) * world;
  direction.on_b = transpose(b.pose().linear) * world;
  direction.offset = dot(world, a.pose().offset - b.pose().offset);
  direction.pad = pad_of(world);
  const auto known = directions();
  const bool is_known = std::any_of(known.begin(), known.end(), [&](const CullDirection& other) {
    return other.world == world || other.world == -world;
  });
  if (!is_known && is_usable(direction)) directions_[count_++] = direction;
}

}  // namespace toccata
