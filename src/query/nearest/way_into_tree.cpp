#include "query/nearest/way_into_tree.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "query/meshes/cull_bounds.hpp"

namespace toccata {
namespace {

/// A factor for the rounding of a root, and for a matrix that is hardly rigid.
constexpr double hardly_more = 1 + 0x1p-40;

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

/// The terms of one row of B: |B_i| S, the sum of |B_i|, and |E_i| rho.
struct AxisTerms {
  double row_by_sizes;
  double row_sum;
  double error_by_rho;
};

struct OffBounds {
  double at_origin;
  double by_size;
  bool are_finite;  ///< and so are the matrix and the origin
};

/// `terms_of(axis)` tells an axis's terms.
template <class TermsOf>
OffBounds bounds_of(double scale, const Vec3& origin, const Vec3& rho, const Vec3& offset, const TermsOf& terms_of) {
  // E is off by 8 u (s + |B| |R|), of which |B| |R| rho is no more than |B| S.
  const double of_scale = 8 * unit_roundoff * scale * sum_of_magnitudes(rho);
  double greatest = 0, greatest_row = 0, all = 0;
  for (int i = 0; i < 3; ++i) {
    const AxisTerms axis = terms_of(i);
    const double off = 24 * unit_roundoff * axis.row_by_sizes + 16 * unit_roundoff * std::fabs(origin[i]) +
                       underflow_of(8 * axis.row_sum, axis.row_by_sizes) + of_scale + axis.error_by_rho;
    greatest = std::max(greatest, off);
    greatest_row = std::max(greatest_row, axis.row_sum);
    all += off + axis.row_sum;
  }
  const double by_size = 32 * unit_roundoff * greatest_row;
  const double at_origin = 2 * greatest + (by_size * largest_magnitude(offset) + 0x1p-100);
  return {at_origin, by_size, std::isfinite(all) && std::isfinite(at_origin)};
}

}  // namespace

WayIntoTree::WayIntoTree(const PosedMesh& mesh) {
  const WideBvh& tree = mesh.model().wide_bvh();
  const double scale = 1 / tree.unit;
  const Mat3& linear = mesh.pose().linear;
  back_ = inverse(linear, scale);
  origin_ = scale * tree.origin;
  const Vec3 rho = largest_coordinates(mesh), sizes = world_sizes(mesh);
  const OffBounds off = bounds_of(scale, origin_, rho, mesh.pose().offset, [&](int i) {
    const Vec3 row = back_[i], magnitude = magnitudes(row);
    Vec3 identity;
    identity[i] = scale;
    const Vec3 error = magnitudes(row.x * linear[0] + row.y * linear[1] + row.z * linear[2] - identity);
    return AxisTerms{dot(magnitude, sizes), sum_of_magnitudes(magnitude), dot(error, rho)};
  });
  off_ = off.at_origin;
  off_by_size_ = off.by_size;
  usable_ = off.are_finite;
}

WayIntoTree::WayIntoTree(const WideBvh& tree) {
  const double scale = 1 / tree.unit;
  for (int i = 0; i < 3; ++i) back_[i][i] = scale;
  for (int i = 0; i < 3; ++i) back_[i][(i + 1) % 3] = back_[i][(i + 2) % 3] = 0;
  origin_ = scale * tree.origin;
  // R = 1 and t = 0, by which sizes are rho, and E = 0.
  const Vec3 rho = largest_coordinates(tree.box);
  const OffBounds off = bounds_of(scale, origin_, rho, {}, [&](int i) { return AxisTerms{scale * rho[i], scale, 0}; });
  off_ = off.at_origin;
  off_by_size_ = off.by_size;
  usable_ = off.are_finite;
}

RayFrame ray_frame(const WideBvh& tree, const WayIntoTree& way, const Vec3& offset) {
  const double scale = 1 / tree.unit;
  RayFrame frame;
  frame.back = way.back();
  frame.offset = offset;
  frame.origin = way.origin();
  frame.box = {scale * tree.box.lower - way.origin(), scale * tree.box.upper - way.origin()};
  frame.off = way.off_at_origin();
  frame.off_by_size = way.off_by_size();
  frame.has_units = tree.unit < 0x1p1023;
  frame.usable = way.usable();
  return frame;
}

Stretch stretch_into(const WideBvh& tree) {
  const bool is_middling = tree.unit > 0x1p-400 && tree.unit < 0x1p400;
  return is_middling ? Stretch{hardly_more / tree.unit, true} : Stretch{HUGE_VAL, false};
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
  return {(is_rigid ? factor : std::sqrt(squares)) * hardly_more, is_rigid};
}

}  // namespace toccata
