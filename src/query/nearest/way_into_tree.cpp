#include "query/nearest/way_into_tree.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "query/meshes/cull_bounds.hpp"

namespace toccata {
namespace {

Mat3 inverse(const Mat3& m, double scale) {
  const Vec3 x = cross(m.column(1), m.column(2)), y = cross(m.column(2), m.column(0)),
             z = cross(m.column(0), m.column(1));
  const double factor = scale / dot(m.column(0), x);
  Mat3 result;
  result[0] = factor * x;
  result[1] = factor * y;
  result[2] = factor * z;
  return result;
}

}  // namespace

WayIntoTree::WayIntoTree(const PosedMesh& mesh) {
  const WideBvh& tree = mesh.model().wide_bvh();
  const double scale = 1 / tree.unit;
  back_ = inverse(mesh.pose().linear, scale);
  origin_ = scale * tree.origin;
  const Vec3 rho = largest_coordinates(mesh), sizes = world_sizes(mesh);
  const Mat3& linear = mesh.pose().linear;
  std::array<AxisTerms, 3> terms;
  for (int i = 0; i < 3; ++i) {
    const Vec3 row = back_[i], magnitude = magnitudes(row);
    Vec3 identity;
    identity[i] = scale;
    const Vec3 error = magnitudes(row.x * linear[0] + row.y * linear[1] + row.z * linear[2] - identity);
    terms[static_cast<std::size_t>(i)] = {dot(magnitude, sizes), sum_of_magnitudes(magnitude), dot(error, rho)};
  }
  set_bounds(scale, rho, mesh.pose().offset, terms);
}

WayIntoTree::WayIntoTree(const WideBvh& tree) {
  const double scale = 1 / tree.unit;
  for (int i = 0; i < 3; ++i) back_[i][i] = scale;
  for (int i = 0; i < 3; ++i) back_[i][(i + 1) % 3] = back_[i][(i + 2) % 3] = 0;
  origin_ = scale * tree.origin;
  // R = 1 and t = 0, by which sizes are rho, and E = 0.
  const Vec3 rho = largest_coordinates(tree.box);
  set_bounds(scale, rho, {}, {{{scale * rho.x, scale, 0}, {scale * rho.y, scale, 0}, {scale * rho.z, scale, 0}}});
}

void WayIntoTree::set_bounds(double scale, const Vec3& rho, const Vec3& offset, const std::array<AxisTerms, 3>& terms) {
  // E is off by 8 u (s + |B| |R|), of which |B| |R| rho is no more than |B| S.
  const double of_scale = 8 * unit_roundoff * scale * sum_of_magnitudes(rho);
  for (int i = 0; i < 3; ++i) {
    const AxisTerms& axis = terms[static_cast<std::size_t>(i)];
    const double off = 24 * unit_roundoff * axis.row_by_sizes + 16 * unit_roundoff * std::fabs(origin_[i]) +
                       8 * smallest_double * axis.row_sum + of_scale + axis.error_by_rho;
    if (!std::isfinite(off)) return;
    off_ = std::max(off_, 2 * off);
    off_by_size_ = std::max(off_by_size_, 32 * unit_roundoff * axis.row_sum);
  }
  off_ += off_by_size_ * largest_magnitude(offset) + 0x1p-100;
  usable_ = is_finite(back_) && std::isfinite(off_) && std::isfinite(off_by_size_) && is_finite(origin_);
}

Stretch stretch_of(const Mat3& m) {
  double squares = 0;
  for (int i = 0; i < 3; ++i) squares += dot(m[i], m[i]);
  if (!(squares > 0x1p-900) || !(squares < 0x1p900)) return {HUGE_VAL, false};
  const double factor = std::sqrt(squares / 3);
  Mat3 unit = m;
  for (int i = 0; i < 3; ++i) unit[i] = (1 / factor) * m[i];
  const bool is_rigid = is_surely_rigid(unit);
  // By the sum of all squares it is never more.
  return {(is_rigid ? factor : std::sqrt(squares)) * (1 + 0x1p-40), is_rigid};
}

}  // namespace toccata
