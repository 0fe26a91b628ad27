#pragma once

#include <algorithm>
#include <limits>

#include "math/constants.hpp"
#include "query/meshes/posed_mesh.hpp"

namespace toccata {

// What the culling tests share. The proof is docs/design/culling.md, and the names are its.

/// η, the smallest positive double; u is `unit_roundoff`.
constexpr double smallest_double = std::numeric_limits<double>::denorm_min();

struct FormRange {
  double low;
  double high;
};

/// The least and the greatest value of form · x over the box: ((f0·x0 + f1·x1) + f2·x2), each product and sum rounded.
inline FormRange range_of(const Vec3& form, const Aabb& box) {
  const double x0 = form.x * box.lower.x, x1 = form.x * box.upper.x;
  const double y0 = form.y * box.lower.y, y1 = form.y * box.upper.y;
  const double z0 = form.z * box.lower.z, z1 = form.z * box.upper.z;
  return {(std::min(x0, x1) + std::min(y0, y1)) + std::min(z0, z1),
          (std::max(x0, x1) + std::max(y0, y1)) + std::max(z0, z1)};
}

/// A gap that rounding cannot have made. Not for a gap that overflowed, nor for NaN: both comparisons are written so
/// that what is not a number fails them, and nothing is culled.
inline bool is_certain(double gap, double pad) { return gap > pad && gap <= std::numeric_limits<double>::max(); }

/// Not less than so many smallest doubles; less than u · size more, where they are nothing beside that. A processor may
/// take fifty times as long for a product with one of them as for any other.
inline double underflow_of(double count, double size) {
  return count < 0x1p1000 * size ? unit_roundoff * size : count * smallest_double;
}

/// pad(L): `rounded` is W, or S along an axis, and `underflowed` is what smallest doubles are multiplied with.
inline double culling_pad(double rounded, double underflowed) {
  return 16 * unit_roundoff * rounded + underflow_of(8 * underflowed, rounded);
}

/// ρ: the largest magnitude of each coordinate in a box.
[[nodiscard]] Vec3 largest_coordinates(const Aabb& box);

/// S_i = Σ_j |R_ij| ρ_j + |t_i|: the size of the sum that rounds to a world coordinate, for local points in a box.
[[nodiscard]] Vec3 world_sizes(const Pose& pose, const Aabb& local);

/// The same for the triangles of a mesh.
[[nodiscard]] Vec3 largest_coordinates(const PosedMesh& mesh);
[[nodiscard]] Vec3 world_sizes(const PosedMesh& mesh);

}  // namespace toccata
