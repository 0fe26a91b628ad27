#include "narrow/convex/convex_containment.hpp"
#include "narrow/boxes/rigid_box_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "math/filter.hpp"
#include "math/vec3_measures.hpp"
#include "math/wide_integer.hpp"
#include "narrow/convex/core_distance.hpp"
#include "shapes/hull_walk.hpp"

// A common part of the radii may be taken off both A grown by r and B grown by s (cancellation law of Minkowski sums of
// compact convex sets). With r ≤ s, A lies in B grown by s − r: every vertex of A is that near to B, whose growth is
// convex. With r > s, A grown by r − s lies in B: no facet's plane is nearer to a vertex of A than that.
namespace toccata {
namespace {

/// The hull in the world: there rounding may have bent the shape's own faces.
ConvexHull world_hull(const PosedPolytope& shape) {
  std::vector<Vec3> vertices(shape.vertex_count());
  for (Index i = 0; i < shape.vertex_count(); ++i) vertices[i] = shape.vertex(i);
  return ConvexHull(vertices);
}

struct Bounds {
  Vec3 lower;
  Vec3 upper;
};

Bounds bounds_of(const PosedPolytope& shape) {
  Bounds bounds{shape.vertex(0), shape.vertex(0)};
  for (Index i = 1; i < shape.vertex_count(); ++i) {
    const Vec3 v = shape.vertex(i);
    for (int axis = 0; axis < 3; ++axis) {
      bounds.lower[axis] = std::min(bounds.lower[axis], v[axis]);
      bounds.upper[axis] = std::max(bounds.upper[axis], v[axis]);
    }
  }
  return bounds;
}

/// A shape with what both directions of the question need of it.
class SolidSide {
 public:
  explicit SolidSide(const PosedPolytope& shape) : shape_(&shape), bounds_(bounds_of(shape)) {}

  [[nodiscard]] const PosedPolytope& shape() const { return *shape_; }
  [[nodiscard]] double radius() const { return shape_->radius(); }
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }

  [[nodiscard]] const ConvexHull& core() {
    if (!core_) core_ = world_hull(*shape_);
    return *core_;
  }

 private:
  const PosedPolytope* shape_;
  Bounds bounds_;
  std::optional<ConvexHull> core_;
};

/// A reaches beyond B along an axis. Rounding is monotone, so of two rounded sums the greater is that of greater sums.
bool certainly_sticks_out(const SolidSide& a, const SolidSide& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.bounds().upper[axis] + a.radius() > b.bounds().upper[axis] + b.radius()) return true;
    if (a.bounds().lower[axis] - a.radius() < b.bounds().lower[axis] - b.radius()) return true;
  }
  return false;
}

/// Whether A lies within B, so deep that doubles prove it.
///
/// The corners of B are those of a convex polytope H, moved by at most some δ: H is the exact image of a hull under its
/// pose, and of a box what `RigidBox` tells of it. What has a ball of radius δ around it within H lies in the hull of
/// the moved corners, which reaches as far as H in every direction but for δ. So every vertex of A, grown by `more`,
/// has to be that deep behind all facets.
///
/// A facet's plane is known by three of its moved corners p, q, r. Let U be the sum of the magnitudes of the
/// coordinates of q − p and r − p, X that of v − p for a point v. With the corners of H in place of p, q, r each
/// coordinate of the normal (q − p) × (r − p) changes by less than 2.1 δ U, and its product with v − p by less than 2.4
/// δ U (X + U), for δ < U / 32: where δ is more, the test fails.
class DeepWithin {
 public:
  DeepWithin(const SolidSide& a, const SolidSide& b)
      : a_(a.shape()),
        b_(b.shape()),
        middle_(0.5 * a.bounds().lower + 0.5 * a.bounds().upper),
        slack_(slack_of(b_)),
        more_(a.radius() > b.radius() ? a.radius() - b.radius() : 0) {
    for (Index i = 0; i < a_.vertex_count(); ++i)
      around_middle_ = std::max(around_middle_, dot(a_.vertex(i) - middle_, a_.vertex(i) - middle_));
    around_middle_ = std::sqrt(around_middle_ + filter::floor);
    // Of so few that rounding moves it by no more than 4 slacks: a wrong side by so little is within `height_of`'s
    // error.
    const Index step = b_.vertex_count() / 64 + 1, some = (b_.vertex_count() + step - 1) / step;
    for (Index i = 0; i < b_.vertex_count(); i += step) inside_ = inside_ + (1.0 / some) * b_.vertex(i);
  }

  [[nodiscard]] bool is_certain() const {
    const HullTopology t = b_.topology();
    if (t.face_count() < 4) return false;
    for (Index face = 0; face < t.face_count(); ++face)
      if (!is_behind(Plane(b_, &t.origin[t.face_start[face]]))) return false;
    return true;
  }

 private:
  struct Plane {
    Plane(const PosedPolytope& shape, const Index* corners) : point(shape.vertex(corners[0])) {
      const Vec3 u = shape.vertex(corners[1]) - point, w = shape.vertex(corners[2]) - point;
      normal = filtered_cross(u, w);
      size = sum_of_magnitudes(u) + sum_of_magnitudes(w);
    }

    Vec3 point;
    FilteredCross normal;
    double size = 0;  ///< U
  };

  static double slack_of(const PosedPolytope& shape) {
    if (shape.stored_extent() == 0) return shape.as_box().slack;
    const Mat3& linear = shape.pose().linear;
    double stretch = 0;
    for (int row = 0; row < 3; ++row) stretch = std::max(stretch, sum_of_magnitudes(linear[row]));
    // Each coordinate meets six roundings of at most 2^-53 of the magnitudes; three make a length.
    return 0x1p-49 * (stretch * shape.stored_extent() + largest_magnitude(shape.pose().offset)) + filter::floor;
  }

  /// The height of a point above the plane, with all that it may be off by.
  [[nodiscard]] Filtered height_of(const Plane& plane, const Vec3& point) const {
    const Vec3 from = point - plane.point;
    Filtered height = filtered_triple_product(plane.normal, from);
    height.error += 8 * slack_ * plane.size * (plane.size + sum_of_magnitudes(from));
    return height;
  }

  [[nodiscard]] bool is_behind(const Plane& plane) const {
    const double squared = dot(plane.normal.value, plane.normal.value);
    if (!(squared > 0x1p-900)) return false;  // squares have underflowed
    const double most = std::sqrt(squared) + (0x1p-48 * plane.size + 8 * slack_) * plane.size;
    const Filtered inside = height_of(plane, inside_);
    if (!inside.is_positive() && !inside.is_negative()) return false;
    const double outward = inside.is_positive() ? -1 : 1;
    // All that follows is rounded a few times, and a filter's error is less than a hundredth short of its value's.
    const auto is_deep = [&](const Vec3& point, double reach) {
      const Filtered height = height_of(plane, point);
      return -outward * height.value > 1.01 * (height.error + (reach + slack_) * most);
    };
    if (is_deep(middle_, around_middle_ + more_)) return true;
    constexpr Index few = 8;  // of more vertices for every facet the hull of B's corners is cheaper
    if (a_.vertex_count() > few) return false;
    for (Index i = 0; i < a_.vertex_count(); ++i)
      if (!is_deep(a_.vertex(i), more_)) return false;
    return true;
  }

  const PosedPolytope& a_;
  const PosedPolytope& b_;
  Vec3 middle_;               ///< of A
  double around_middle_ = 0;  ///< no vertex of A is farther from it, but for rounding
  Vec3 inside_;               ///< of B: the mean of some corners
  double slack_;              ///< δ, a length
  double more_;
};

struct Decided {
  bool yes = false;
  bool by_exact = false;
};

using PlanePoints = std::array<Vec3, 3>;

/// The sign of (distance of the point from the plane) − (x − y), where x > y; exactly.
Sign exact_depth_order(const PlanePoints& plane, const Vec3& point, double x, double y) {
  const std::array<Vec3, 6> all{plane[0], plane[1], plane[2], point, Vec3{x, 0, 0}, Vec3{y, 0, 0}};
  const int exponent = common_exponent(all);
  const IntegerVector origin = scaled_wide(plane[0], exponent);
  const IntegerVector normal =
      cross(scaled_wide(plane[1], exponent) - origin, scaled_wide(plane[2], exponent) - origin);
  const WideInteger height = dot(normal, scaled_wide(point, exponent) - origin);
  const WideInteger depth = scaled_wide(x, exponent) - scaled_wide(y, exponent);
  const int order = WideInteger(height * height).compare(depth * depth * dot(normal, normal));
  return static_cast<Sign>(order < 0 ? -1 : order > 0 ? 1 : 0);
}

/// The point is at least x − y away from the plane. In doubles first: the height is off by at most its filter's bound,
/// each part of the normal likewise, and the few operations after that by less than 2^-48 of their values.
Decided is_that_deep(const PlanePoints& plane, const Vec3& point, double x, double y) {
  const FilteredCross normal = filtered_cross(plane[1] - plane[0], plane[2] - plane[0]);
  const Filtered height = filtered_triple_product(normal, point - plane[0]);
  const double length = std::sqrt(dot(normal.value, normal.value));
  const double off = 0x1p-49 * ((normal.magnitude.x + normal.magnitude.y) + normal.magnitude.z);
  const double least = (x - y) * (length - off), most = (x - y) * (length + off);
  if (least > 0x1p-900 && std::isfinite(most)) {
    if (std::fabs(height.value) - height.error > (1 + 0x1p-48) * most) return {true, false};
    if (std::fabs(height.value) + height.error < (1 - 0x1p-48) * least) return {false, false};
  }
  return {exact_depth_order(plane, point, x, y) != Sign::negative, true};
}

enum class SharedBoundary { allowed, excluded };

/// For every facet of B: the vertex of A that is highest above it lies behind it, and if r > s by at least r − s.
Decided is_behind_facets(SolidSide& a, SolidSide& b, SharedBoundary boundary) {
  const ConvexHull &hull_a = a.core(), &hull_b = b.core();
  const HullTopology t = hull_b.topology();
  std::vector<Index> highest(t.face_count(), 0);
  bool by_exact = false;
  for (const FaceVisit& visit : faces_by_neighbours(t)) {
    const auto corner = [&](Index i) { return hull_b.vertex(t.origin[t.face_start[visit.face] + i]); };
    const PlanePoints plane{corner(0), corner(1), corner(2)};
    const Index vertex = highest_vertex(hull_a, plane[0], plane[1], plane[2], highest[visit.before]);
    highest[visit.face] = vertex;
    const Sign side = orient3d(plane[0], plane[1], plane[2], hull_a.vertex(vertex));
    if (side == Sign::positive || (side == Sign::zero && boundary == SharedBoundary::excluded))
      return {false, by_exact};
    if (!(a.radius() > b.radius())) continue;
    const Decided deep = is_that_deep(plane, hull_a.vertex(vertex), a.radius(), b.radius());
    by_exact = by_exact || deep.by_exact;
    if (!deep.yes) return {false, by_exact};
  }
  return {true, by_exact};
}

/// Every vertex of A has at most the distance s − r ≥ 0 from the core of B, or less.
Decided is_near_core(const SolidSide& a, const SolidSide& b, SharedBoundary boundary) {
  VertexPairs start;
  bool by_exact = false;
  for (Index i = 0; i < a.shape().vertex_count(); ++i) {
    const PosedPolytope vertex{Point(a.shape().vertex(i))};
    start.a = {};  // the point's only vertex; those of B are where the last search ended
    const CoreDistanceOrder order = compare_core_distance(vertex, b.shape(), b.radius(), -a.radius(), start);
    start = order.simplex;
    by_exact = by_exact || order.by_exact;
    if (order.sign == Sign::positive || (order.sign == Sign::zero && boundary == SharedBoundary::excluded))
      return {false, by_exact};
  }
  return {true, by_exact};
}

Decided is_within(SolidSide& a, SolidSide& b, SharedBoundary boundary) {
  if (certainly_sticks_out(a, b)) return {};
  if (DeepWithin(a, b).is_certain()) return {true, false};
  if (a.radius() < b.radius()) return is_near_core(a, b, boundary);
  if (b.core().dimension() == 3) return is_behind_facets(a, b, boundary);
  return a.radius() == b.radius() ? is_near_core(a, b, boundary) : Decided{};
}

}  // namespace

ContainmentAnswer containment_of_solids(const PosedPolytope& a, const PosedPolytope& b) {
  SolidSide side_a(a), side_b(b);
  const Decided a_in_b = is_within(side_a, side_b, SharedBoundary::allowed);
  const Decided b_in_a = is_within(side_b, side_a, SharedBoundary::allowed);
  const bool by_exact = a_in_b.by_exact || b_in_a.by_exact;
  if (a_in_b.yes) return {b_in_a.yes ? Containment::equal : Containment::a_in_b, by_exact};
  return {b_in_a.yes ? Containment::b_in_a : Containment::none, by_exact};
}

ContainmentAnswer containment_in_interior(const PosedPolytope& a, const PosedPolytope& b) {
  SolidSide side_a(a), side_b(b);
  const Decided within = is_within(side_a, side_b, SharedBoundary::excluded);
  return {within.yes ? Containment::a_in_b : Containment::none, within.by_exact};
}

bool has_interior(const PosedPolytope& shape) {
  if (shape.radius() > 0) return true;
  if (shape.vertex_count() < 4) return false;
  if (is_rigid_and_plain(view_of(shape))) return true;
  // These are the corners 0, 1, 2 and 4 of a box, and any four of a hull, which nearly always are enough.
  const Vec3 a = shape.vertex(0), b = shape.vertex(1), c = shape.vertex(2), d = shape.vertex(shape.vertex_count() / 2);
  const Filtered volume = filtered_orient3d(a, b, c, d);
  return volume.is_positive() || volume.is_negative() || world_hull(shape).dimension() == 3;
}

}  // namespace toccata
