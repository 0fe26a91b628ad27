#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/convex/core_separation.hpp"
#include "narrow/convex/fast_expansion.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/precise_facet.hpp"

// What the quick expansion found is a guess. The numbers come from the vertices of the deepest facet alone, by one
// formula, and these are proved, with d for the facet's distance:
//
// - No depth is less than lower = d − w. Every facet of the surface has the origin behind it, by no less than that.
// Seen
//   from the origin, all triangles then turn the same way, so that the closed surface goes round the origin, and every
//   ray from there meets it no nearer than at that distance: in a point of D. (It need not be convex.)
// - d + w parts, along the rounded normal: a bound of the heights of all vertices says so.
//
// w is a fixed fraction of d and the radii, and far more than what the formula may be off by.
//
// The formula, with u = 2^-53. Let a facet be a face of one and a vertex of the other, or an edge of each. Its edges
// are then differences of vertices, e and f, off by u of each coordinate; n = e × f is off by at most 7u|e||f|; a
// corner p by u|p|; so n · p / |n| is off by at most u|p|(9 + 15|e||f| / |n|).
//
// For shallow shapes w is less than that. Then the facet's plane is computed with double-words, and proved to be one of
// D's, with the origin's foot p on it, d from the origin along n, and all points of the facet as near as r to p. What
// doubles do not tell of the other facets is told by p, as long as they lie no lower than d − δ along n. A ray from the
// origin at an angle of up to atan(r / d) with n meets D's facet, at d or beyond; another one that meets such a facet,
// meets it at (d − δ) √(1 + r² / d²) or beyond. That is no less than d when r² ≥ 2.2 δ d and δ ≤ d / 20.
namespace toccata {
namespace {

/// The plane of a facet of D, from vertices of the shapes.
struct FacetPlane {
  Vec3 start_a, start_b;  ///< whose difference is a corner
  Vec3 edge, other_edge;  ///< when it is made of an edge of each, first that of A
  Vec3 across;            ///< their cross product, unit, away from the origin
  double length = 0;      ///< of the product
  double distance = 0;
  double error = HUGE_VAL;  ///< of the distance

  void measure() {
    const Vec3 corner = start_a - start_b, n = cross(edge, other_edge);
    length = plain_length(n);
    const double offset = dot(n, corner);
    across = ((offset < 0 ? -1 : 1) / length) * n;
    distance = std::fabs(offset) / length;
    error = 0x1p-49 * plain_length(corner) * (1 + plain_length(edge) * plain_length(other_edge) / length);
  }
};

struct FacetCorners {
  std::array<Index, 3> a, b;
};

enum class FacetKind { face_of_a, face_of_b, edges, other };

/// Ascending, so that the formula does not depend on where the search came from; of edges the first two of each count.
FacetKind sort(FacetCorners& c) {
  std::sort(c.a.begin(), c.a.end());
  std::sort(c.b.begin(), c.b.end());
  if (c.b[0] == c.b[2]) return FacetKind::face_of_a;
  if (c.a[0] == c.a[2]) return FacetKind::face_of_b;
  const auto two = [](std::array<Index, 3>& of) {
    if (of[0] != of[1] && of[1] != of[2]) return false;
    of[1] = of[2];
    return true;
  };
  return two(c.a) && two(c.b) ? FacetKind::edges : FacetKind::other;
}

class FastSeparation {
 public:
  FastSeparation(const PosedPolytope& a, const PosedPolytope& b, double reach, double width)
      : a_(a), b_(b), reach_(reach), half_width_(0.5 * width) {}

  std::optional<CoreSeparation> run() {
    if (!expand_fast(a_, b_, surface_)) return {};
    const std::optional<Index> facet = facet_of_foot();
    if (!facet) return {};
    if (std::optional<CoreSeparation> found = run_in_doubles(*facet)) return found;
    return run_precisely(*facet);
  }

 private:
  std::optional<CoreSeparation> run_in_doubles(Index facet) {
    FacetCorners corners = corners_of(facet);
    const FacetKind kind = sort(corners);
    const FacetPlane plane = plane_of(corners, kind);
    const double width = half_width_ * (plane.distance + reach_);
    if (!(plane.error <= width)) return {};
    CoreSeparation separation;
    separation.kind = CoreSeparation::Kind::deep;
    separation.lower = plane.distance - width;
    separation.upper = plane.distance + width;
    separation.direction = plane.across;
    if (!(separation.lower > 0) || !parts(separation) || !surrounds(separation.lower)) return {};
    find_points(separation, corners, kind, plane);
    return separation;
  }

  [[nodiscard]] std::optional<CoreSeparation> run_precisely(Index facet) const {
    const FacetCorners corners = corners_of(facet);
    VertexPairs pairs;
    for (std::size_t k = 0; k < 3; ++k) pairs.append(corners.a[k], corners.b[k]);
    const std::optional<PreciseFacet> found = precise_facet(a_, b_, pairs);
    if (!found) return {};
    const bool is_nearest = is_certainly_nearest(a_, b_, *found) || surrounds(found->separation.lower, &*found);
    return is_nearest ? std::optional(found->separation) : std::nullopt;
  }

  [[nodiscard]] FacetCorners corners_of(Index f) const {
    FacetCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners.a[k] = surface_.on_a[surface_.facets.corner(f, k)];
      corners.b[k] = surface_.on_b[surface_.facets.corner(f, k)];
    }
    return corners;
  }

  /// The origin's foot on the plane of a facet lies in that triangle, but for rounding.
  [[nodiscard]] bool holds_foot(Index f) const {
    const Vec3 n = surface_.normal(f);
    const double squared = dot(n, n);
    const Vec3 foot = (surface_.offset[f] / squared) * n;
    const Vec3 p = corner(f, 0) - foot, q = corner(f, 1) - foot, r = corner(f, 2) - foot;
    const double least = std::min({dot(n, cross(p, q)), dot(n, cross(q, r)), dot(n, cross(r, p))});
    return least >= -0x1p-30 * squared;
  }

  /// The nearest, or one in its plane: of two faces over each other, many triangles are one facet of D.
  [[nodiscard]] std::optional<Index> facet_of_foot() const {
    const Index nearest = surface_.nearest;
    if (holds_foot(nearest)) return nearest;
    const Vec3 across = (1 / plain_length(surface_.normal(nearest))) * surface_.normal(nearest);
    for (Index f = 0; f < surface_.facets.count(); ++f) {
      if (surface_.facets.is_vacant(f)) continue;
      const Vec3 n = surface_.normal(f);
      if (dot(n, across) >= (1 - 0x1p-30) * plain_length(n) && holds_foot(f)) return f;
    }
    return {};
  }

  [[nodiscard]] FacetPlane plane_of(const FacetCorners& c, FacetKind kind) const {
    FacetPlane plane;
    plane.start_a = a_.vertex(c.a[0]);
    plane.start_b = b_.vertex(c.b[0]);
    const auto edge_of_a = [&](std::size_t k) { return a_.vertex(c.a[k]) - plane.start_a; };
    const auto edge_of_b = [&](std::size_t k) { return b_.vertex(c.b[k]) - plane.start_b; };
    if (kind == FacetKind::other) return plane;
    plane.edge = kind == FacetKind::face_of_b ? edge_of_b(1) : edge_of_a(1);
    plane.other_edge = kind == FacetKind::face_of_b   ? edge_of_b(2)
                       : kind == FacetKind::face_of_a ? edge_of_a(2)
                                                      : edge_of_b(1);
    plane.measure();
    return plane;
  }

  /// A move by `upper` along the direction, which is a unit vector up to 2^-50.
  [[nodiscard]] bool parts(const CoreSeparation& separation) const {
    const SupportKernels kernels = support_kernels();
    const double behind = SupportSearch(a_, kernels).lower_bound(-separation.direction),
                 ahead = SupportSearch(b_, kernels).lower_bound(separation.direction);
    const double rounding = 0x1p-50 * (std::fabs(behind) + std::fabs(ahead));
    return rounding - (behind + ahead) <= separation.upper - 0x1p-48 * separation.upper;
  }

  /// Every facet has the origin behind it, and no nearer than that; beside a precise one it may be a little nearer.
  [[nodiscard]] bool surrounds(double lower, const PreciseFacet* beside = nullptr) const {
    const FastSurface& s = surface_;
    double extent = 0;
    for (Index i = 0; i < s.points; ++i)
      extent = std::max({extent, std::fabs(s.x[i]), std::fabs(s.y[i]), std::fabs(s.z[i])});
    const double unit_error = 0x1p-46 * extent * extent, least = (1 + 0x1p-48) * lower * lower;
    for (Index f = 0; f < s.facets.count(); ++f) {
      if (s.facets.is_vacant(f)) continue;
      const Vec3 n = s.normal(f), p = corner(f, 0), q = corner(f, 1), r = corner(f, 2);
      const double error = unit_error * (sum_of_magnitudes(p - r) + sum_of_magnitudes(q - r)),
                   certain = s.offset[f] - error;
      if (certain > 0 && certain * certain >= least * dot(n, n)) continue;
      const bool is_beside = beside != nullptr && is_certainly_beside(f, *beside, extent);
      if (!(certain > 0) || !(is_beside || is_certainly_beyond(f, lower))) return false;
    }
    return true;
  }

  /// No ray meets the facet before the precise one does, or nearer to the origin than that is. A height along its
  /// direction is off by 2^-50 of the extent for the corner, for the direction and for the product each, at most.
  [[nodiscard]] bool is_certainly_beside(Index f, const PreciseFacet& precise, double extent) const {
    const Vec3& n = precise.separation.direction;
    const double lowest = std::min({dot(n, corner(f, 0)), dot(n, corner(f, 1)), dot(n, corner(f, 2))});
    const double depth = precise.separation.upper, below = (depth - lowest) + 0x1p-48 * extent;
    return below <= depth / 20 && precise.inner_radius * precise.inner_radius >= 2.25 * below * depth;
  }

  [[nodiscard]] Vec3 corner(Index f, std::size_t k) const { return surface_.point(surface_.facets.corner(f, k)); }

  /// Decides by the formula, for a facet that has the origin behind it.
  [[nodiscard]] bool is_certainly_beyond(Index f, double lower) const {
    FacetCorners corners = corners_of(f);
    const FacetKind kind = sort(corners);
    const FacetPlane plane = plane_of(corners, kind);
    return plane.distance - plane.error >= lower + 0x1p-50 * lower;
  }

  void find_points(CoreSeparation& separation, const FacetCorners& c, FacetKind kind, const FacetPlane& plane) const {
    const Vec3 way = plane.distance * plane.across;
    if (kind != FacetKind::edges) {
      for (std::size_t k = 0; k < 3; ++k) separation.pairs.append(c.a[k], c.b[k]);
      separation.on_a = kind == FacetKind::face_of_b ? plane.start_a : plane.start_b + way;
      separation.on_b = kind == FacetKind::face_of_b ? plane.start_a - way : plane.start_b;
      return;
    }
    for (std::size_t k = 0; k < 2; ++k) separation.pairs.append(c.a[k], c.b[k]);
    const Vec3 corner = plane.start_a - plane.start_b;
    const Vec3 n = (1 / plane.length) * cross(plane.edge, plane.other_edge);
    // Where two lines are nearest. The point on the shorter edge is off by less; it leads to the other.
    const auto along = [&](const Vec3& other) {
      return std::clamp(-dot(cross(corner, other), n) / plane.length, 0.0, 1.0);
    };
    if (dot(plane.edge, plane.edge) <= dot(plane.other_edge, plane.other_edge)) {
      separation.on_a = plane.start_a + along(plane.other_edge) * plane.edge;
      separation.on_b = separation.on_a - way;
    } else {
      separation.on_b = plane.start_b + along(plane.edge) * plane.other_edge;
      separation.on_a = separation.on_b + way;
    }
  }

  const PosedPolytope& a_;
  const PosedPolytope& b_;
  double reach_;
  double half_width_;  ///< of the bracket, relative
  FastSurface surface_;
};

}  // namespace

std::optional<CoreSeparation> part_cores_fast(const PosedPolytope& a, const PosedPolytope& b, double reach,
                                              double width) {
  return FastSeparation(a, b, reach, width).run();
}

}  // namespace toccata
