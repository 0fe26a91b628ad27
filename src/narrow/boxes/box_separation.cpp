#include "narrow/boxes/box_separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "narrow/boxes/box_contact.hpp"
#include "narrow/boxes/next_axis.hpp"
#include "narrow/convex/aligned_cores.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/convex_separation.hpp"
#include "narrow/convex/precise_facet.hpp"

namespace toccata {
namespace {

double sum(const Vec3& v) { return (v.x + v.y) + v.z; }

/// Where |v|² = 1 + ε, 1 / |v| is 1 − ε / 2 but for less than ε², which is below 2^-70 under a pose as rigid as here.
Vec3 unit_of_nearly_unit(const Vec3& v) { return (1.5 - 0.5 * dot(v, v)) * v; }

Vec3 face_normal(const BoxView& box, std::size_t i) {
  return unit_of_nearly_unit(cross(box.axis(next_axis(i)), box.axis(next_axis(next_axis(i)))));
}

/// The direction from A to B, as the way along the edge across the face goes.
Vec3 direction_of_face(const BoxView& box, std::size_t i, double way) {
  const Vec3 normal = face_normal(box, i);
  return std::copysign(1, way) * std::copysign(1, dot(normal, box.axis(i))) * normal;
}

/// The direction from A to B.
Vec3 direction_of_edges(const BoxView& a, const BoxView& b, std::size_t i, std::size_t j) {
  const Vec3 normal = cross(a.axis(i), b.axis(j));
  const double inverse = 1 / std::sqrt(dot(normal, normal));
  return std::copysign(inverse, dot(normal, b.box->centre - a.box->centre)) * normal;
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
      if (!(chosen.edge_b == 3 && chosen.edge_a == i)) least = std::min(least, axes_.overlap_a[i] - axes_.error);
      if (!(chosen.edge_a == 3 && chosen.edge_b == i)) least = std::min(least, axes_.overlap_b[i] - axes_.error);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        // An edge pair's axis is no longer than 1.
        if (axes_.edge_overlap[i][j] - axes_.error >= (1 + rough_) * least) continue;
        if (chosen.edge_a == i && chosen.edge_b == j) continue;
        least = std::min(least, of_edges(i, j));
      }
    return least;
  }

 private:
  [[nodiscard]] double of_edges(std::size_t i, std::size_t j) const {
    const double angle = std::sqrt(axes_.squared_sine(i, j)) + 4 * rough_;
    const double direct = (axes_.edge_overlap[i][j] - axes_.error) / angle;
    if (angle > least_sine_of_edges) return direct;
    // As in rigid_box_axes.cpp: nearly parallel edges.
    const std::size_t k = next_axis(i), l = next_axis(k), m = next_axis(j), n = next_axis(m);
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
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = box.half_extent(i) * box.axis(i);
    const double along = dot(edge, inwards);
    if (!(std::fabs(along) > same)) return {};
    corner = along > 0 ? corner + edge : corner - edge;
  }
  return corner;
}

/// The middle of what lies deepest over the face.
std::optional<Vec3> deepest_over_face(const BoxView& a, const BoxView& b, const BoxContact& contact) {
  const BoxOverlay& overlay = contact.overlay;
  if (overlay.points == 0) return {};
  const BoxView &reference = contact.faces.b_is_reference ? b : a, &incident = contact.faces.b_is_reference ? a : b;
  const auto is_taken = [&](std::size_t i) { return (overlay.points >> i & 1U) != 0; };
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < BoxOverlay::capacity; ++i)
    if (is_taken(i)) least = std::min(least, overlay.gap[i]);
  const double same = 0x1p-40 * (sum(incident.box->half_extents) + std::fabs(least));
  double x = 0, y = 0, count = 0;
  for (std::size_t i = 0; i < BoxOverlay::capacity; ++i) {
    if (!is_taken(i) || overlay.gap[i] > least + same) continue;
    x += overlay.x[i];
    y += overlay.y[i];
    ++count;
  }
  return BoxFacePlane(reference, contact.faces.reference).at(x / count, y / count);
}

/// Finds the points of a face against whatever lies deepest over it.
bool find_points_of_face(CoreSeparation& separation, const BoxView& a, const BoxView& b, const RigidBoxAxes& axes,
                         const ChosenBoxAxis& axis) {
  const Vec3 way = separation.upper * axis.direction;
  const bool is_of_a = axis.edge_b == 3;
  if (const std::optional<Vec3> corner =
          is_of_a ? deepest_corner(b, -axis.direction) : deepest_corner(a, axis.direction)) {
    separation.on_a = is_of_a ? *corner + way : *corner;
    separation.on_b = is_of_a ? *corner : *corner - way;
    return true;
  }
  const std::optional<Vec3> on_face = deepest_over_face(a, b, contact_of_faces(a, b, axes, axis));
  if (!on_face) return false;
  separation.on_a = is_of_a ? *on_face : *on_face + way;
  separation.on_b = is_of_a ? *on_face - way : *on_face;
  return true;
}

/// The corner of a face that lies nearest to a point, and its two neighbours there.
std::array<Index, 3> corners_of_face(const BoxView& box, std::size_t across, const Vec3& outwards, const Vec3& near) {
  const Index end = Index{1} << across, x = Index{1} << next_axis(across), y = Index{1} << next_axis(next_axis(across));
  const Vec3 from = near - box.box->centre;
  Index corner = dot(box.axis(across), outwards) > 0 ? end : 0;
  if (dot(box.axis(next_axis(across)), from) > 0) corner |= x;
  if (dot(box.axis(next_axis(next_axis(across))), from) > 0) corner |= y;
  return {corner, corner ^ x, corner ^ y};
}

/// The corners of the facet that belongs to an axis.
VertexPairs facet_corners(const PosedPolytope& a, const PosedPolytope& b, const ChosenBoxAxis& axis) {
  const BoxView view_a = view_of(a), view_b = view_of(b);
  const Index of_a = farthest_corner(view_a, axis.direction), of_b = farthest_corner(view_b, -axis.direction);
  VertexPairs pairs;
  if (axis.edge_b == 3) {
    for (const Index k : corners_of_face(view_a, axis.edge_a, axis.direction, b.vertex(of_b))) pairs.append(k, of_b);
  } else if (axis.edge_a == 3) {
    for (const Index k : corners_of_face(view_b, axis.edge_b, -axis.direction, a.vertex(of_a))) pairs.append(of_a, k);
  } else {
    pairs.append(of_a, of_b);
    pairs.append(of_a ^ Index{1} << axis.edge_a, of_b);
    pairs.append(of_a, of_b ^ Index{1} << axis.edge_b);
  }
  return pairs;
}

double least_half_extent(const BoxView& box) {
  const auto [x, y, z] = box.box->half_extents;
  return std::min({x, y, z});
}

/// No other axis has a facet as near. Facets whose normals are those of the axis but for the rounding of corners, less
/// than 2^-20, are no nearer because the disc around the foot is not so small (precise_facet.cpp).
bool others_are_deeper(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const ChosenBoxAxis& axis,
                       const PreciseFacet& facet) {
  const double depth = facet.separation.upper, slack = a.box->slack + b.box->slack;
  if (!(facet.inner_radius >= 0x1p-20 * depth)) return false;
  // Two edges that are nearly parallel may have a facet of any normal there, which is by this nearer.
  if (!(slack <= 0x1p-21 * depth)) return false;
  if (!(slack <= 0x1p-35 * std::min(least_half_extent(a), least_half_extent(b)))) return false;
  const double sizes = sum(a.box->half_extents) + sum(b.box->half_extents), enough = (1 + 0x1p-18) * depth;
  return LowerBound(axes, b.box->half_extents, sizes).but_for(axis, enough) >= enough;
}

/// Where corners' rounding is seen: by the facet of the least axis alone, with more digits.
std::optional<CoreSeparation> part_shallow_boxes(const PosedPolytope& a, const PosedPolytope& b,
                                                 const OverlappingBoxes& found) {
  if (found.nearness != Nearness::meet) return {};
  const std::optional<PreciseFacet> facet = precise_facet(a, b, facet_corners(a, b, found.least));
  if (!facet) return {};
  const bool is_nearest =
      is_certainly_nearest(a, b, *facet) || others_are_deeper(view_of(a), view_of(b), found.axes, found.least, *facet);
  return is_nearest ? std::optional(facet->separation) : std::nullopt;
}

/// The corner of the formula that is farthest along a direction.
Vec3 farthest_point(const BoxView& box, const Vec3& direction) {
  const Mat3& axes = *box.axes;
  const Vec3 along = direction.x * axes[0] + direction.y * axes[1] + direction.z * axes[2];
  const auto [x, y, z] = box.box->half_extents;
  return box.box->centre + axes * Vec3{std::copysign(x, along.x), std::copysign(y, along.y), std::copysign(z, along.z)};
}

/// The answer for boxes that an axis parts, which needs neither the nearest points nor the way between them.
CoreSeparation parted_along(const BoxView& a, const BoxView& b, Index axis) {
  const Vec3 way = b.box->centre - a.box->centre;
  CoreSeparation separation;
  if (axis >= 6)
    separation.direction = direction_of_edges(a, b, (axis - 6) / 3, (axis - 6) % 3);
  else if (axis >= 3)
    separation.direction = direction_of_face(b, axis - 3, dot(b.axis(axis - 3), way));
  else
    separation.direction = direction_of_face(a, axis, dot(a.axis(axis), way));
  separation.on_a = farthest_point(a, separation.direction);
  separation.on_b = farthest_point(b, -separation.direction);
  return separation;
}

}  // namespace

std::optional<bool> is_order_of_centres(const BoxView& a, const BoxView& b) {
  const Vec3 &p = a.box->centre, &q = b.box->centre;
  if (p == q) return {};
  return lexicographically_less(p, q);
}

Index farthest_corner(const BoxView& box, const Vec3& direction) {
  Index corner = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(box.axis(i), direction) > 0) corner |= 1U << i;
  return corner;
}

ChosenBoxAxis least_axis(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, double edge_share) {
  const std::size_t face = axes.least_face, i = axes.least_edges / 3, j = axes.least_edges % 3;
  const double of_face = face < 3 ? axes.overlap_a[face] : axes.overlap_b[face - 3];
  // Where the difference is mere rounding, edges may lie across a face. Signed squares are compared, without roots.
  const double limit = (of_face > 0 ? edge_share * of_face : of_face) - axes.error;
  const double overlap = axes.edge_overlap[i][j], squared = axes.squared_sine(i, j);
  ChosenBoxAxis best;
  if (squared > least_sine_of_edges * least_sine_of_edges &&
      overlap * std::fabs(overlap) < limit * std::fabs(limit) * squared) {
    best.edge_a = i;
    best.edge_b = j;
    best.sine = std::sqrt(squared);
    best.depth = overlap / best.sine;
    best.direction = direction_of_edges(a, b, i, j);
  } else {
    best.edge_a = face < 3 ? face : 3;
    best.edge_b = face < 3 ? 3 : face - 3;
    best.depth = of_face;
    best.direction =
        face < 3 ? direction_of_face(a, face, axes.way_a[face]) : direction_of_face(b, face - 3, axes.way_b[face - 3]);
  }
  return best;
}

EdgePoints points_of_edges(const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis) {
  const Vec3 u = a.axis(axis.edge_a), v = b.axis(axis.edge_b);
  const double half_a = a.half_extent(axis.edge_a), half_b = b.half_extent(axis.edge_b);
  Vec3 p = a.box->centre, q = b.box->centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 of_a = a.axis(k), of_b = b.axis(k);
    if (k != axis.edge_a) p = p + std::copysign(a.half_extent(k), dot(of_a, axis.direction)) * of_a;
    if (k != axis.edge_b) q = q - std::copysign(b.half_extent(k), dot(of_b, axis.direction)) * of_b;
  }
  const Vec3 w = q - p;
  const double uv = dot(u, v), uw = dot(u, w), vw = dot(v, w), inverse = 1 / (1 - uv * uv);
  const double s = std::clamp((uw - uv * vw) * inverse, -half_a, half_a);
  const double t = std::clamp((uv * uw - vw) * inverse, -half_b, half_b);
  return {p + s * u, q + t * v};
}

std::optional<CoreSeparation> part_rigid_boxes(const BoxView& a, const BoxView& b, double reach_of_radii,
                                               OverlappingBoxes& found) {
  if (!is_rigid_and_plain(a) || !is_rigid_and_plain(b)) return {};
  const RigidBoxAxes& axes = found.axes;
  found.nearness = nearness_of_rigid_boxes(a, b, found.axes);
  if (found.nearness == Nearness::apart && reach_of_radii == 0) return parted_along(a, b, axes.separating_axis);
  if (found.nearness != Nearness::meet) return {};
  const ChosenBoxAxis& axis = found.least = least_axis(a, b, axes, 1);
  const Vec3 d = b.box->centre - a.box->centre, &n = axis.direction;
  const double both = reach(a, n) + reach(b, n), way = dot(n, d), depth = both - way;
  const double sizes = sum(a.box->half_extents) + sum(b.box->half_extents);
  // Sums of products are off by 8u of all sizes at most, and so is the direction, over the edges' sine.
  const double rounding = 0x1p-50 * (1 + 1 / axis.sine) * (sizes + sum_of_magnitudes(d));
  const double error = rounding + (a.box->slack + b.box->slack);
  CoreSeparation separation;
  separation.kind = CoreSeparation::Kind::deep;
  separation.direction = n;
  separation.upper = (depth + error) * (1 + 0x1p-49);
  const double widest = relative_width_of_depth * (separation.upper + reach_of_radii);
  if (!(2 * error <= widest)) return {};
  const LowerBound bound(axes, b.box->half_extents, sizes);
  separation.lower = bound.but_for(axis, depth - error) * (1 - 0x1p-49);
  if (!(separation.lower > 0) || !(separation.upper - separation.lower <= widest)) return {};
  if (!is_of_edges(axis)) {
    if (!find_points_of_face(separation, a, b, axes, axis)) return {};
    return separation;
  }
  const EdgePoints points = points_of_edges(a, b, axis);
  const Vec3 move = separation.upper * n;
  separation.on_a = sum(a.box->half_extents) <= sum(b.box->half_extents) ? points.on_a : points.on_b + move;
  separation.on_b = separation.on_a - move;
  return separation;
}

std::optional<Penetration> penetration_of_close_boxes(const PosedPolytope& a, const PosedPolytope& b,
                                                      const OverlappingBoxes& found) {
  if (const std::optional<ConvexSeparation> aligned = part_aligned_cores(a, b)) return aligned->penetration;
  const std::optional<CoreSeparation> core = part_shallow_boxes(a, b, found);
  return core ? std::optional(offset_outward(*core, a.radius(), b.radius())) : std::nullopt;
}

std::optional<Penetration> penetration_of_boxes(const PosedPolytope& a, const PosedPolytope& b) {
  if (!is_rigid_and_plain(view_of(a)) || !is_rigid_and_plain(view_of(b))) return {};
  const std::optional<bool> by_centre = is_order_of_centres(view_of(a), view_of(b));
  if (!(by_centre ? *by_centre : is_canonical_order(a, b))) {
    const std::optional<Penetration> exchanged = penetration_of_boxes(b, a);
    return exchanged ? flipped(*exchanged) : exchanged;
  }
  OverlappingBoxes found;
  if (const auto core = part_rigid_boxes(view_of(a), view_of(b), a.radius() + b.radius(), found))
    return offset_outward(*core, a.radius(), b.radius());
  return penetration_of_close_boxes(a, b, found);
}

}  // namespace toccata
