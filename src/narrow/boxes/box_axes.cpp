#include "narrow/boxes/box_axes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/boxes/next_axis.hpp"
#include "narrow/convex/plain_topology.hpp"

// Let A' and B' be the parallelepipeds of the two frames, u_i and v_j their half edges, and D' their Minkowski
// difference. A facet of D' is parallel to a face of A' or of B', or to an edge of each; so these axes decide about A'
// and B'. D differs from D' by at most the two bends: where D' reaches farther than that along every axis, or falls
// back as much along one, A and B meet, or do not, too.
//
// Along L = x × y, with half edges x and y, what is computed is a sum of triple products (x × y) · z, one for each half
// edge and one for the way between the centres. Let u = 2^-53 and |x|₁ = |x.x| + |x.y| + |x.z|. A triple product is off
// by at most 8u |x|₁ |y|₁ |z|₁ (math/filter.hpp; underflow is absorbed by `smallest`), the way itself by 4u of all
// sizes together, and the sum adds 4u. So the overlap along L, times |L|, is off by |x|₁ |y|₁ · 16u (sizes + |way|₁),
// and by |L| ≤ |x|₁ |y|₁ times the bends, which are themselves off by 16u of the sizes: 32u in all make `error_`.
//
// Nearly parallel edges u_i and v_j make an axis whose direction is mere rounding. Seen along u_i, A' is a
// parallelogram and B' the parallelogram of the other two half edges, grown along the image of v_j, which has the
// length |L| / |u_i|. The least reach of the difference of two polygons is attained along a normal of an edge of one of
// them. Without that image, these are the other two faces at u_i and the edge pairs (u_i, v_k), k ≠ j; and taking it
// away changes no reach by more than its length. So the axis reaches as far as the least of those four, less |L| /
// |u_i|.
namespace toccata {
namespace {

constexpr double smallest = 0x1p-900;

using Halves = std::array<Vec3, 3>;

double reach(const Halves& half, const Vec3& axis) {
  return (std::fabs(dot(axis, half[0])) + std::fabs(dot(axis, half[1]))) + std::fabs(dot(axis, half[2]));
}

Halves face_normals(const Halves& half) {
  return {cross(half[1], half[2]), cross(half[2], half[0]), cross(half[0], half[1])};
}

Halves normal_scales(const Halves& half) {
  const double x = sum_of_magnitudes(half[0]), y = sum_of_magnitudes(half[1]), z = sum_of_magnitudes(half[2]);
  return {Vec3{y * z, 0, 0}, Vec3{z * x, 0, 0}, Vec3{x * y, 0, 0}};
}

}  // namespace

bool is_box(const PosedPolytope& shape) {
  return shape.topology().face_start.data() == box_topology().face_start.data();
}

BoxFrame box_frame(const PosedPolytope& box) {
  const Vec3 corner = box.vertex(0);
  const Vec3 x = box.vertex(1) - corner, y = box.vertex(2) - corner, z = box.vertex(4) - corner;
  const Vec3 xy = x + y;
  const auto beside = [&](Index i, const Vec3& edges) { return largest_magnitude((box.vertex(i) - corner) - edges); };
  BoxFrame frame{corner, {0.5 * x, 0.5 * y, 0.5 * z}, 0, 0};
  frame.size = (sum_of_magnitudes(frame.half[0]) + sum_of_magnitudes(frame.half[1])) + sum_of_magnitudes(frame.half[2]);
  const double beside_most = std::max({beside(3, xy), beside(5, x + z), beside(6, y + z), beside(7, xy + z)});
  frame.bent = 2 * beside_most;
  return frame;
}

BoxAxes::BoxAxes(const PosedPolytope& a, const PosedPolytope& b) : a_(box_frame(a)), b_(box_frame(b)) {
  const Vec3 from_corner_a = (a_.half[0] + a_.half[1]) + a_.half[2];
  const Vec3 from_corner_b = (b_.half[0] + b_.half[1]) + b_.half[2];
  way_ = (b_.corner - a_.corner) + (from_corner_b - from_corner_a);
  error_ = 0x1p-48 * ((a_.size + b_.size) + sum_of_magnitudes(way_)) + (a_.bent + b_.bent);
}

bool BoxAxes::boxes_of_boxes_are_apart() const {
  const auto apart_along = [&](int axis) {
    double reach = error_;
    for (std::size_t i = 0; i < 3; ++i) reach += std::fabs(a_.half[i][axis]) + std::fabs(b_.half[i][axis]);
    return std::fabs(way_[axis]) > reach;
  };
  return apart_along(0) || apart_along(1) || apart_along(2);
}

bool BoxAxes::is_of_plain_size() const {
  double least = infinity;
  for (const BoxFrame* box : {&a_, &b_})
    for (const Vec3& half : box->half) least = std::min(least, sum_of_magnitudes(half));
  return least > 0x1p-200 && (a_.size + b_.size) + sum_of_magnitudes(way_) < 0x1p200;
}

std::optional<bool> BoxAxes::meet() const {
  if (boxes_of_boxes_are_apart()) return false;
  if (!is_of_plain_size()) return {};
  const Halves &u = a_.half, &v = b_.half;
  const Halves normal_a = face_normals(u), normal_b = face_normals(v);
  const Halves scale_a = normal_scales(u), scale_b = normal_scales(v);
  const double volume_a = std::fabs(dot(normal_a[0], u[0])), volume_b = std::fabs(dot(normal_b[0], v[0]));
  // |normal_a[i] · v[j]| and |normal_b[j] · u[i]|: what reaches along the edge pairs consists of them too.
  std::array<std::array<double, 3>, 3> p, q;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      p[i][j] = std::fabs(dot(normal_a[i], v[j]));
      q[j][i] = std::fabs(dot(normal_b[j], u[i]));
    }
  bool sure = true;
  const auto apart = [&](double way, double both_reach, double scale) {
    const double gap = std::fabs(way) - both_reach, error = error_ * scale + smallest;
    sure = sure && gap < -error;
    return gap > error;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (apart(dot(normal_a[i], way_), volume_a + ((p[i][0] + p[i][1]) + p[i][2]), scale_a[i].x)) return false;
    if (apart(dot(normal_b[i], way_), volume_b + ((q[i][0] + q[i][1]) + q[i][2]), scale_b[i].x)) return false;
  }
  if (!sure) return {};
  unsigned undecided = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 beside = cross(way_, u[i]);
    const double size = sum_of_magnitudes(u[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = next_axis(i), l = next_axis(k), m = next_axis(j), n = next_axis(m);
      sure = true;
      if (apart(dot(beside, v[j]), (p[k][j] + p[l][j]) + (q[m][i] + q[n][i]), size * sum_of_magnitudes(v[j])))
        return false;
      undecided |= (sure ? 0U : 1U) << (3 * i + j);
    }
  }
  if (undecided == 0 || near_parallel_edges_do_not_matter(undecided)) return true;
  return {};
}

bool BoxAxes::near_parallel_edges_do_not_matter(unsigned undecided) const {
  const Halves &u = a_.half, &v = b_.half;
  const auto spare = [&](const Vec3& axis, double scale) {
    const double overlap = (reach(u, axis) + reach(v, axis)) - std::fabs(dot(axis, way_));
    return (overlap - (error_ * scale + smallest)) / (plain_length(axis) * (1 + 0x1p-40));
  };
  const Halves normal_a = face_normals(u), scale_a = normal_scales(u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if ((undecided >> (3 * i + j) & 1U) == 0) continue;
      const std::size_t k = next_axis(i), l = next_axis(k), m = next_axis(j), n = next_axis(m);
      if ((undecided >> (3 * i + m) & 1U) != 0 || (undecided >> (3 * i + n) & 1U) != 0) return false;
      const double least = std::min({spare(normal_a[k], scale_a[k].x), spare(normal_a[l], scale_a[l].x),
                                     spare(cross(u[i], v[m]), sum_of_magnitudes(u[i]) * sum_of_magnitudes(v[m])),
                                     spare(cross(u[i], v[n]), sum_of_magnitudes(u[i]) * sum_of_magnitudes(v[n]))});
      const double image =
          plain_length(cross(u[i], v[j])) + 0x1p-50 * sum_of_magnitudes(u[i]) * sum_of_magnitudes(v[j]);
      if (!(least > 2 * image / plain_length(u[i]))) return false;
    }
  return true;
}

BoxAxis BoxAxes::least(double edge_share) const {
  const Halves &u = a_.half, &v = b_.half;
  BoxAxis best;
  best.depth = infinity;
  const auto consider = [&](const Vec3& axis, double length, double share, int edge_a, int edge_b) {
    const double way = dot(axis, way_);
    const double depth = ((reach(u, axis) + reach(v, axis)) - std::fabs(way)) / length;
    if (!(depth < share * best.depth)) return;
    best = {edge_a, edge_b, (way < 0 ? -1 / length : 1 / length) * axis, depth};
  };
  const Halves normal_a = face_normals(u), normal_b = face_normals(v);
  for (std::size_t i = 0; i < 3; ++i) consider(normal_a[i], plain_length(normal_a[i]), 1, static_cast<int>(i), 3);
  for (std::size_t i = 0; i < 3; ++i) consider(normal_b[i], plain_length(normal_b[i]), 1, 3, static_cast<int>(i));
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 axis = cross(u[i], v[j]);
      const double length = plain_length(axis);
      // Edges that are nearly parallel: a face does as well.
      if (!(length > 0x1p-20 * plain_length(u[i]) * plain_length(v[j]))) continue;
      consider(axis, length, edge_share, static_cast<int>(i), static_cast<int>(j));
    }
  return best;
}

}  // namespace toccata
