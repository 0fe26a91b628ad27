#include "narrow/box_parting.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "narrow/aligned_boxes.hpp"
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
double squared_sine(const RigidBoxAxes& axes, std::size_t i, std::size_t j) {
  const double c = axes.cosines[next(i)][j], d = axes.cosines[next(next(i))][j];
  return c * c + d * d;
}

Vec3 face_normal(const BoxView& box, int i) {
  const int k = i == 2 ? 0 : i + 1;
  return unit(cross(column(box, k), column(box, 3 - i - k)));
}

/// The number of the least, of equals the first.
int least_of(std::span<const double> values) {
  int best = 0;
  double least = values[0];
  for (std::size_t k = 1; k < values.size(); ++k) {
    const bool less = values[k] < least;
    best = less ? static_cast<int>(k) : best;
    least = less ? values[k] : least;
  }
  return best;
}

/// From A to B; where neither way is shorter, as the edge of A points, or against that of B.
Vec3 direction_of(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const ChosenBoxAxis& axis) {
  const auto turned = [](const Vec3& v, const Vec3& edge, double sign) { return dot(v, edge) * sign < 0 ? -v : v; };
  if (axis.edge_b == 3)
    return turned(face_normal(a, axis.edge_a), column(a, axis.edge_a),
                  axes.way_a[static_cast<std::size_t>(axis.edge_a)] < 0 ? -1 : 1);
  if (axis.edge_a == 3)
    return turned(face_normal(b, axis.edge_b), column(b, axis.edge_b),
                  axes.way_b[static_cast<std::size_t>(axis.edge_b)] > 0 ? 1 : -1);
  return turned(unit(cross(column(a, axis.edge_a), column(b, axis.edge_b))), b.box->centre - a.box->centre, 1);
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
    const double angle = std::sqrt(squared_sine(axes_, i, j)) + 4 * rough_;
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

/// The corner that lies deepest, where it is one.
std::optional<Vec3> deepest_corner(const BoxView& box, const Vec3& inwards) {
  const double same = 0x1p-30 * sum(box.box->half_extents);
  Vec3 corner = box.box->centre;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = half(box, i) * column(box, i);
    const double along = dot(edge, inwards);
    if (!(std::fabs(along) > same)) return {};
    corner = along > 0 ? corner + edge : corner - edge;
  }
  return corner;
}

/// The middle of what lies deepest over the face.
std::optional<Vec3> deepest_over_face(const BoxView& a, const BoxView& b, const BoxContact& contact) {
  if (contact.count == 0) return {};
  const BoxView &reference = contact.faces.b_is_reference ? b : a, &incident = contact.faces.b_is_reference ? a : b;
  double least = contact.corners[0].gap;
  for (std::size_t i = 1; i < contact.count; ++i) least = std::min(least, contact.corners[i].gap);
  const double same = 0x1p-40 * (sum(incident.box->half_extents) + std::fabs(least));
  double x = 0, y = 0, count = 0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    if (contact.corners[i].gap > least + same) continue;
    x += contact.corners[i].x;
    y += contact.corners[i].y;
    ++count;
  }
  return BoxFacePlane(reference, contact.faces.reference).at(x / count, y / count);
}

/// Of a face against whatever lies deepest over it.
bool find_points_of_face(CoreParting& parting, const BoxView& a, const BoxView& b, const RigidBoxAxes& axes,
                         const ChosenBoxAxis& axis) {
  const Vec3 way = parting.upper * axis.direction;
  const bool is_of_a = axis.edge_b == 3;
  if (const std::optional<Vec3> corner =
          is_of_a ? deepest_corner(b, -axis.direction) : deepest_corner(a, axis.direction)) {
    parting.on_a = is_of_a ? *corner + way : *corner;
    parting.on_b = is_of_a ? *corner : *corner - way;
    return true;
  }
  const std::optional<Vec3> on_face = deepest_over_face(a, b, contact_of_faces(a, b, axes, axis));
  if (!on_face) return false;
  parting.on_a = is_of_a ? *on_face : *on_face + way;
  parting.on_b = is_of_a ? *on_face - way : *on_face;
  return true;
}

}  // namespace

Index farthest_corner(const BoxView& box, const Vec3& direction) {
  Index corner = 0;
  for (int i = 0; i < 3; ++i)
    if (dot(column(box, i), direction) > 0) corner |= 1U << i;
  return corner;
}

// Signed squares of depths are compared, and the least found, without roots and branches.
ChosenBoxAxis least_axis(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, double edge_share) {
  std::array<double, 15> depth;
  for (std::size_t i = 0; i < 3; ++i) {
    depth[i] = axes.overlap_a[i];
    depth[3 + i] = axes.overlap_b[i];
  }
  const int face = least_of({depth.data(), 6});
  const double of_face = depth[static_cast<std::size_t>(face)];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double squared = squared_sine(axes, i, j), overlap = axes.edge_overlap[i][j];
      const double signed_square = overlap * std::fabs(overlap) / squared;
      depth[6 + 3 * i + j] = squared > least_sine * least_sine ? signed_square : HUGE_VAL;
    }
  const int edges = least_of({depth.data() + 6, 9});
  ChosenBoxAxis best;
  best.depth = of_face;
  best.edge_a = face < 3 ? face : 3;
  best.edge_b = face < 3 ? 3 : face - 3;
  // Where the difference is mere rounding, edges may lie across a face.
  const double limit = (of_face > 0 ? edge_share * of_face : of_face) - axes.error;
  const double of_edges = depth[static_cast<std::size_t>(6 + edges)];
  if (of_edges < limit * std::fabs(limit)) {
    best.edge_a = edges / 3;
    best.edge_b = edges % 3;
    best.depth = std::copysign(std::sqrt(std::fabs(of_edges)), of_edges);
    best.sine =
        std::sqrt(squared_sine(axes, static_cast<std::size_t>(best.edge_a), static_cast<std::size_t>(best.edge_b)));
  }
  best.direction = direction_of(a, b, axes, best);
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
    if (!find_points_of_face(parting, a, b, axes, axis)) return {};
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
  if (!core) return aligned_box_penetration(a, b);
  return grown(*core, a.radius(), b.radius());
}

}  // namespace toccata
