#include "narrow/box_parting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow/box_contact.hpp"
#include "narrow/canonical_order.hpp"
#include "narrow/convex_parting.hpp"

namespace toccata {
namespace {

/// Edges at a smaller angle make no axis: faces do as well.
constexpr double least_sine = 0x1p-12;

Vec3 column(const BoxView& box, int i) { return box.axes->column(i); }
double half(const BoxView& box, int i) { return box.box->half_extents[i]; }
double sum(const Vec3& v) { return (v.x + v.y) + v.z; }

Vec3 unit(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

/// Of the edges' angle.
double sine(const RigidBoxAxes& axes, std::size_t i, std::size_t j) {
  const double c = axes.cosines[next(i)][j], d = axes.cosines[next(next(i))][j];
  return std::sqrt(c * c + d * d);
}

Vec3 face_normal(const BoxView& box, int i) {
  const int k = i == 2 ? 0 : i + 1;
  return unit(cross(column(box, k), column(box, 3 - i - k)));
}

/// Half of how far a box reaches along a direction.
double reach(const BoxView& box, const Vec3& direction) {
  const Mat3& m = *box.axes;
  const Vec3& h = box.box->half_extents;
  const Vec3 along = (direction.x * m[0] + direction.y * m[1]) + direction.z * m[2];
  return (h.x * std::fabs(along.x) + h.y * std::fabs(along.y)) + h.z * std::fabs(along.z);
}

/// A lower bound of the overlap along every facet of the Minkowski difference, once it is sure of every axis that it is
/// positive; `sizes` is what the error was made of at least, so that error / sizes bounds what cosines are off by.
class LowerBound {
 public:
  LowerBound(const RigidBoxAxes& axes, const Vec3& half_extents_b, double sizes)
      : axes_(axes), half_extents_b_(half_extents_b), rough_(axes.error / sizes) {}

  /// The least of `start` and what all axes but the chosen one have.
  [[nodiscard]] double but_for(const ChosenBoxAxis& chosen, double start) const {
    double least = start;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(chosen.edge_b == 3 && static_cast<std::size_t>(chosen.edge_a) == i))
        least = std::min(least, axes_.overlap_a[i] - axes_.error);
      if (!(chosen.edge_a == 3 && static_cast<std::size_t>(chosen.edge_b) == i))
        least = std::min(least, axes_.overlap_b[i] - axes_.error);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        // An edge pair's axis is no longer than 1.
        if (axes_.edge_overlap[i][j] - axes_.error >= (1 + rough_) * least) continue;
        if (static_cast<std::size_t>(chosen.edge_a) == i && static_cast<std::size_t>(chosen.edge_b) == j) continue;
        least = std::min(least, of_edges(i, j));
      }
    return least;
  }

 private:
  [[nodiscard]] double of_edges(std::size_t i, std::size_t j) const {
    const double angle = sine(axes_, i, j) + 4 * rough_;
    const double direct = (axes_.edge_overlap[i][j] - axes_.error) / angle;
    if (angle > least_sine) return direct;
    // As in rigid_box_axes.cpp: nearly parallel edges.
    const std::size_t k = next(i), l = next(k), m = next(j), n = next(m);
    const double four =
        std::min({axes_.overlap_a[k], axes_.overlap_a[l], axes_.edge_overlap[i][m], axes_.edge_overlap[i][n]});
    return std::max(direct, (four - axes_.error) - half_extents_b_[static_cast<int>(j)] * angle);
  }

  const RigidBoxAxes& axes_;
  const Vec3& half_extents_b_;
  double rough_;
};

/// Of a face against whatever lies deepest over it.
bool find_points_of_face(CoreParting& parting, const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis) {
  const BoxContact contact = contact_of_faces(a, b, axis);
  if (contact.count == 0) return false;
  const BoxView &reference = contact.b_is_reference ? b : a, &incident = contact.b_is_reference ? a : b;
  double least = contact.points[0].gap;
  for (std::size_t i = 1; i < contact.count; ++i) least = std::min(least, contact.points[i].gap);
  const double same = 0x1p-40 * (sum(incident.box->half_extents) + std::fabs(least));
  BoxContactPoint deepest;
  double count = 0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const BoxContactPoint& p = contact.points[i];
    if (p.gap > least + same) continue;
    deepest.x += p.x;
    deepest.y += p.y;
    ++count;
  }
  const Vec3 on_reference = contact.middle + ((deepest.x / count) * column(reference, contact.axis[0]) +
                                              (deepest.y / count) * column(reference, contact.axis[1]));
  const Vec3 way = parting.upper * axis.direction;
  parting.on_a = contact.b_is_reference ? on_reference + way : on_reference;
  parting.on_b = contact.b_is_reference ? on_reference : on_reference - way;
  return true;
}

}  // namespace

Index farthest_corner(const BoxView& box, const Vec3& direction) {
  Index corner = 0;
  for (int i = 0; i < 3; ++i)
    if (dot(column(box, i), direction) > 0) corner |= 1U << i;
  return corner;
}

ChosenBoxAxis least_axis(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, double edge_share) {
  ChosenBoxAxis best;
  best.depth = axes.overlap_a[0];
  const auto consider = [&](double depth, int edge_a, int edge_b) {
    if (!(depth < best.depth)) return;
    best.depth = depth;
    best.edge_a = edge_a;
    best.edge_b = edge_b;
  };
  for (int i = 1; i < 3; ++i) consider(axes.overlap_a[static_cast<std::size_t>(i)], i, 3);
  for (int j = 0; j < 3; ++j) consider(axes.overlap_b[static_cast<std::size_t>(j)], 3, j);
  // Where the difference is mere rounding, edges may lie across a face.
  double limit = (best.depth > 0 ? edge_share * best.depth : best.depth) - axes.error;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // The axis is no longer than 1.
      if (!(axes.edge_overlap[i][j] < limit)) continue;
      const double angle = sine(axes, i, j), depth = axes.edge_overlap[i][j] / angle;
      if (!(angle > least_sine) || !(depth < limit)) continue;
      best = {static_cast<int>(i), static_cast<int>(j), {}, depth, angle};
      limit = depth;
    }
  if (best.edge_b == 3)
    best.direction = face_normal(a, best.edge_a);
  else if (best.edge_a == 3)
    best.direction = face_normal(b, best.edge_b);
  else
    best.direction = unit(cross(column(a, best.edge_a), column(b, best.edge_b)));
  if (dot(best.direction, b.box->centre - a.box->centre) < 0) best.direction = -best.direction;
  return best;
}

EdgePoints points_of_edges(const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis) {
  const Vec3 u = column(a, axis.edge_a), v = column(b, axis.edge_b);
  Vec3 p = a.box->centre, q = b.box->centre;
  for (int k = 0; k < 3; ++k) {
    const Vec3 of_a = column(a, k), of_b = column(b, k);
    if (k != axis.edge_a) p = p + std::copysign(half(a, k), dot(of_a, axis.direction)) * of_a;
    if (k != axis.edge_b) q = q - std::copysign(half(b, k), dot(of_b, axis.direction)) * of_b;
  }
  const Vec3 w = q - p;
  const double uv = dot(u, v), uw = dot(u, w), vw = dot(v, w), determinant = 1 - uv * uv;
  const double s = std::clamp((uw - uv * vw) / determinant, -half(a, axis.edge_a), half(a, axis.edge_a));
  const double t = std::clamp((uv * uw - vw) / determinant, -half(b, axis.edge_b), half(b, axis.edge_b));
  return {p + s * u, q + t * v};
}

std::optional<CoreParting> part_rigid_boxes(const BoxView& a, const BoxView& b, double reach_of_radii) {
  if (!is_rigid_and_plain(a) || !is_rigid_and_plain(b)) return {};
  RigidBoxAxes axes;
  if (nearness_of_rigid_boxes(a, b, axes) != Nearness::meet) return {};
  const ChosenBoxAxis axis = least_axis(a, b, axes, 1);
  const Vec3 d = b.box->centre - a.box->centre, &n = axis.direction;
  const double both = reach(a, n) + reach(b, n), way = dot(n, d), depth = both - way;
  const double sizes = sum(a.box->half_extents) + sum(b.box->half_extents);
  // Sums of products are off by 8u of all sizes at most, and so is the direction, over the edges' sine.
  const double rounding = 0x1p-50 * (1 + 1 / axis.sine) * (sizes + sum_of_magnitudes(d));
  const double error = rounding + (a.box->slack + b.box->slack);
  CoreParting parting;
  parting.kind = CoreParting::Kind::deep;
  parting.direction = n;
  parting.upper = (depth + error) * (1 + 0x1p-49);
  const LowerBound bound(axes, b.box->half_extents, sizes);
  parting.lower = bound.but_for(axis, depth - error) * (1 - 0x1p-49);
  if (!(parting.lower > 0) ||
      !(parting.upper - parting.lower <= relative_width_of_depth * (parting.upper + reach_of_radii)))
    return {};
  if (axis.edge_a == 3 || axis.edge_b == 3) {
    if (!find_points_of_face(parting, a, b, axis)) return {};
    return parting;
  }
  const EdgePoints points = points_of_edges(a, b, axis);
  const Vec3 move = parting.upper * n;
  parting.on_a = sum(a.box->half_extents) <= sum(b.box->half_extents) ? points.on_a : points.on_b + move;
  parting.on_b = parting.on_a - move;
  return parting;
}

std::optional<Penetration> penetration_of_boxes(const PosedConvex& a, const PosedConvex& b) {
  if (!is_rigid_and_plain(view_of(a)) || !is_rigid_and_plain(view_of(b))) return {};
  if (!is_canonical_order(a, b)) {
    const std::optional<Penetration> exchanged = penetration_of_boxes(b, a);
    return exchanged ? flipped(*exchanged) : exchanged;
  }
  const std::optional<CoreParting> core = part_rigid_boxes(view_of(a), view_of(b), a.radius() + b.radius());
  if (!core) return {};
  return grown(*core, a.radius(), b.radius());
}

}  // namespace toccata
