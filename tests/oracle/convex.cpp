#include "oracle/convex.hpp"

#include <algorithm>
#include <stdexcept>

namespace toccata::oracle {
namespace {

/// A point of the Minkowski difference A − B, and where it comes from.
struct DifferencePoint {
  RationalPoint on_a;
  RationalPoint on_b;
  RationalPoint difference;
};

/// The point of A − B that lies farthest against a direction. Of A and of B alone, as A − B has far more vertices.
DifferencePoint farthest_against(const RationalPoint& direction, const ConvexSet& a, const ConvexSet& b) {
  const auto along = [&](const RationalPoint& v) { return dot(v, direction); };
  const RationalPoint& on_a = *std::ranges::min_element(a.vertices, {}, along);
  const RationalPoint& on_b = *std::ranges::max_element(b.vertices, {}, along);
  return {on_a, on_b, on_a - on_b};
}

/// Solves the n × n system by Gauss elimination; `rows` hold n coefficients and the right side. Empty when singular.
std::vector<Rational> solution(std::vector<std::vector<Rational>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && rows[pivot][column].is_zero()) ++pivot;
    if (pivot == n) return {};
    std::swap(rows[column], rows[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == column) continue;
      const Rational factor = rows[r][column] / rows[column][column];
      for (std::size_t c = column; c <= n; ++c) rows[r][c] -= factor * rows[column][c];
    }
  }
  std::vector<Rational> result;
  for (std::size_t r = 0; r < n; ++r) result.push_back(rows[r][n] / rows[r][r]);
  return result;
}

using Simplex = std::vector<DifferencePoint>;

/// The point nearest to the origin of the affine hull of the simplex, as weights of the vertices that add up to 1.
/// Empty when the simplex is not affinely independent.
std::vector<Rational> weights_of_nearest_in_affine_hull(const Simplex& simplex) {
  const RationalPoint& base = simplex[0].difference;
  std::vector<std::vector<Rational>> rows;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    const RationalPoint edge = simplex[i].difference - base;
    std::vector<Rational> row;
    for (std::size_t j = 1; j < simplex.size(); ++j) row.push_back(dot(edge, simplex[j].difference - base));
    row.push_back(-dot(edge, base));
    rows.push_back(std::move(row));
  }
  const std::vector<Rational> others = solution(std::move(rows));
  if (others.size() + 1 != simplex.size()) return {};
  std::vector<Rational> weights{Rational(1)};
  for (const Rational& weight : others) {
    weights[0] -= weight;
    weights.push_back(weight);
  }
  return weights;
}

DifferencePoint weighted(const Simplex& simplex, const std::vector<Rational>& weights) {
  DifferencePoint sum;
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    sum.on_a = sum.on_a + weights[i] * simplex[i].on_a;
    sum.on_b = sum.on_b + weights[i] * simplex[i].on_b;
  }
  sum.difference = sum.on_a - sum.on_b;
  return sum;
}

/// The certificate: `nearest` is a point of a convex hull, and no vertex of the hull lies nearer along it. Then every
/// point y of the hull has y · nearest ≥ |nearest|², hence |y| ≥ |nearest|.
bool is_nearest(const DifferencePoint& nearest, const std::vector<DifferencePoint>& vertices) {
  const RationalPoint& x = nearest.difference;
  return std::ranges::all_of(vertices, [&](const DifferencePoint& v) { return dot(v.difference - x, x) >= 0; });
}

struct Support {
  Simplex simplex;  ///< the nearest point lies in its relative interior
  DifferencePoint nearest;
};

/// The point nearest to the origin of the hull of at most four points, by trying every subset.
Support nearest_of_few(const Simplex& few) {
  for (unsigned subset = 1; subset < 1U << few.size(); ++subset) {
    Simplex simplex;
    for (std::size_t i = 0; i < few.size(); ++i)
      if ((subset >> i & 1U) != 0) simplex.push_back(few[i]);
    const std::vector<Rational> weights = weights_of_nearest_in_affine_hull(simplex);
    if (weights.empty() || !std::ranges::all_of(weights, [](const Rational& w) { return w > 0; })) continue;
    const DifferencePoint candidate = weighted(simplex, weights);
    if (is_nearest(candidate, few)) return {simplex, candidate};
  }
  throw std::logic_error("oracle: a hull without a nearest point");
}

/// Cuts away what has n · d < 0 for some point d of A − B: by the d that a corner has farthest against it, until none.
std::vector<RationalPoint> separating_part(std::vector<RationalPoint> face, const ConvexSet& a, const ConvexSet& b) {
  for (std::size_t corner = 0; corner < face.size();) {
    const DifferencePoint farthest = farthest_against(face[corner], a, b);
    if (dot(face[corner], farthest.difference) >= 0) {
      ++corner;
      continue;
    }
    face = clipped(face, {-farthest.difference, 0});
    face.erase(std::unique(face.begin(), face.end()), face.end());
    corner = 0;
  }
  return face;
}

/// Normals n, not 0, with n · d ≥ 0 for every d in A − B: the cone they form, cut by the surface of the cube [−1, 1]³,
/// as the extreme points of its (at most six) polygons.
std::vector<RationalPoint> weakly_separating_normals(const ConvexSet& a, const ConvexSet& b) {
  std::vector<RationalPoint> result;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2) {
      std::vector<RationalPoint> face;
      for (const auto& [u, v] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
        face.push_back(axis == 0   ? RationalPoint{side, u, v}
                       : axis == 1 ? RationalPoint{v, side, u}
                                   : RationalPoint{u, v, side});
      const std::vector<RationalPoint> part = separating_part(std::move(face), a, b);
      result.insert(result.end(), part.begin(), part.end());
    }
  return result;
}

/// No plane separates the hulls, not even weakly. For two bodies: their interiors meet. For a body and a flat hull:
/// the hull meets the body's interior (R. T. Rockafellar, "Convex Analysis", 1970, §11).
bool interiors_meet(const ConvexSet& a, const ConvexSet& b) { return weakly_separating_normals(a, b).empty(); }

/// Every weakly separating plane contains both hulls (Rockafellar, theorem 11.3).
bool relative_interiors_meet(const ConvexSet& a, const ConvexSet& b) {
  return std::ranges::all_of(weakly_separating_normals(a, b), [&](const RationalPoint& n) {
    return dot(n, farthest_against(-n, a, b).difference).is_zero();
  });
}

std::vector<RationalPoint> joined(const ConvexSet& a, const ConvexSet& b) {
  std::vector<RationalPoint> result = a.vertices;
  result.insert(result.end(), b.vertices.begin(), b.vertices.end());
  return result;
}

/// The planes of the facets of a body's hull, as the half-spaces that hold it.
std::vector<HalfSpace> facets(const ConvexSet& body) {
  const auto& v = body.vertices;
  std::vector<HalfSpace> result;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j)
      for (std::size_t k = 0; k < v.size(); ++k) {
        const HalfSpace candidate = half_space(v[i], cross(v[j] - v[i], v[k] - v[i]));
        if (is_zero(candidate.normal)) continue;
        if (std::ranges::all_of(v, [&](const RationalPoint& p) { return height_above(candidate, p) <= 0; }))
          result.push_back(candidate);
      }
  return result;
}

/// The solid a is a subset of the solid b. A common radius may be taken off both (cancellation law of Minkowski sums of
/// compact convex sets).
bool is_subset(const ConvexSet& a, const ConvexSet& b) {
  if (a.radius <= b.radius) {
    const ConvexSet shrunk{b.vertices, b.radius - a.radius};
    return std::ranges::all_of(a.vertices, [&](const RationalPoint& p) { return side_of(p, shrunk) <= 0; });
  }
  // What is left of a is round, so b's core must be a body that holds it.
  const ConvexSet core{b.vertices, 0};
  if (!is_solid(core)) return false;
  const Rational radius_squared = (a.radius - b.radius) * (a.radius - b.radius);
  for (const HalfSpace& facet : facets(core))
    for (const RationalPoint& p : a.vertices) {
      const Rational height = height_above(facet, p);
      if (height > 0 || height * height < radius_squared * dot(facet.normal, facet.normal)) return false;
    }
  return true;
}

Containment containment_of(bool a_in_b, bool b_in_a) {
  if (a_in_b && b_in_a) return Containment::equal;
  if (a_in_b) return Containment::a_in_b;
  return b_in_a ? Containment::b_in_a : Containment::none;
}

/// All of the surface lies in the interior of the solid.
bool is_inside(const ConvexSet& surface, const ConvexSet& solid) {
  return std::ranges::all_of(surface.vertices, [&](const RationalPoint& p) { return side_of(p, solid) < 0; });
}

Relation relation_of_surfaces(const ConvexSet& a, const ConvexSet& b) {
  if (!overlap(a, b)) return {};
  if (!are_coplanar(joined(a, b)) && relative_interiors_meet(a, b)) return {RelationKind::crossing};
  return {RelationKind::touching, Containment::none, true};
}

enum class Way { above = 1, below = -1 };

/// The sign of how far the grown set reaches above, or below, the plane of the half-space.
int reach_sign(const ConvexSet& set, const HalfSpace& h, Way way) {
  std::vector<Rational> reaches;
  for (const RationalPoint& p : set.vertices) reaches.push_back(static_cast<int>(way) * height_above(h, p));
  const Rational core = *std::ranges::max_element(reaches);
  // The sign of core + radius · |normal|, without the square root.
  const Rational radius_squared = set.radius * set.radius * dot(h.normal, h.normal);
  if (core >= 0) return core > 0 || radius_squared > 0 ? 1 : 0;
  return Rational(radius_squared - core * core).sign();
}

}  // namespace

Relation flipped(const Relation& relation) {
  Relation result = relation;
  if (relation.containment == Containment::a_in_b) result.containment = Containment::b_in_a;
  if (relation.containment == Containment::b_in_a) result.containment = Containment::a_in_b;
  return result;
}

ConvexSet point_set(const Vec3& p) { return {{exact(p)}, 0}; }
ConvexSet segment_set(const Vec3& p, const Vec3& q) { return {{exact(p), exact(q)}, 0}; }
ConvexSet triangle_set(const Vec3& p, const Vec3& q, const Vec3& r) { return {{exact(p), exact(q), exact(r)}, 0}; }
ConvexSet sphere_set(const Vec3& centre, double radius) { return rounded(point_set(centre), radius); }
ConvexSet capsule_set(const Vec3& p, const Vec3& q, double radius) { return rounded(segment_set(p, q), radius); }
ConvexSet rounded(ConvexSet core, double radius) { return {std::move(core.vertices), core.radius + exact(radius)}; }
HalfSpace half_space_set(const Vec3& point, const Vec3& normal) { return half_space(exact(point), exact(normal)); }

ConvexSet hull_set(std::span<const Vec3> vertices) {
  ConvexSet result;
  for (const Vec3& v : vertices) result.vertices.push_back(exact(v));
  return result;
}

ConvexSet box_set(std::span<const Vec3> eight_corners) {
  if (eight_corners.size() != 8) throw std::invalid_argument("a box has eight corners");
  return hull_set(eight_corners);
}

bool is_solid(const ConvexSet& set) { return set.radius > 0 || !are_coplanar(set.vertices); }

// Grows a simplex by the vertex that lies farthest against the nearest point found so far, and drops what that point
// does not need (P. Wolfe, "Finding the nearest point in a polytope", 1976). The distance falls strictly, so it ends.
// The certificate is that of is_nearest.
NearestPoints nearest_points(const ConvexSet& a, const ConvexSet& b) {
  const DifferencePoint first{a.vertices.at(0), b.vertices.at(0), a.vertices[0] - b.vertices[0]};
  Support support{{first}, first};
  while (true) {
    const RationalPoint& x = support.nearest.difference;
    const Rational squared_distance = dot(x, x);
    const DifferencePoint farthest = farthest_against(x, a, b);
    if (dot(farthest.difference, x) >= squared_distance)
      return {support.nearest.on_a, support.nearest.on_b, squared_distance};
    support.simplex.push_back(farthest);
    support = nearest_of_few(support.simplex);
    if (dot(support.nearest.difference, support.nearest.difference) >= squared_distance)
      throw std::logic_error("oracle: the distance did not fall");
  }
}

int compare_distance(const ConvexSet& a, const ConvexSet& b, const Rational& gap) {
  const Rational squared = nearest_points(a, b).squared_distance;
  const Rational reach = a.radius + b.radius + gap;
  // Sets that meet have distance 0, however deep they overlap.
  if (squared <= (a.radius + b.radius) * (a.radius + b.radius)) return gap.is_zero() ? 0 : -1;
  return Rational(squared - reach * reach).sign();
}

int compare_distance(const ConvexSet& a, const HalfSpace& b, const Rational& gap) {
  if (overlap(a, b)) return gap.is_zero() ? 0 : -1;
  return -reach_sign({a.vertices, a.radius + gap}, b, Way::below);
}

bool overlap(const ConvexSet& a, const ConvexSet& b) {
  const Rational reach = a.radius + b.radius;
  return nearest_points(a, b).squared_distance <= reach * reach;
}

bool overlap(const ConvexSet& a, const HalfSpace& b) { return reach_sign(a, b, Way::below) >= 0; }

bool overlap(const HalfSpace& a, const HalfSpace& b) { return relation(a, b).kind != RelationKind::apart; }

Relation relation(const ConvexSet& a, const ConvexSet& b) { return relation(a, is_solid(a), b, is_solid(b)); }

Relation relation(const ConvexSet& a, bool a_solid, const ConvexSet& b, bool b_solid) {
  if (!a_solid && !b_solid) return relation_of_surfaces(a, b);
  const Rational squared = nearest_points(a, b).squared_distance;
  const Rational reach = a.radius + b.radius;
  if (squared > reach * reach) return {};
  // A set with a radius meets another's interior as soon as the cores are nearer than the radii reach.
  const bool deep = reach > 0 ? squared < reach * reach : interiors_meet(a, b);
  const bool flattened = (a_solid && !is_solid(a)) || (b_solid && !is_solid(b));  // no interior is left to meet
  if (!deep || flattened) return {RelationKind::touching};
  if (a_solid && b_solid) return {RelationKind::overlapping, containment_of(is_subset(a, b), is_subset(b, a))};
  if (a_solid) return {RelationKind::crossing, is_inside(b, a) ? Containment::b_in_a : Containment::none};
  return {RelationKind::crossing, is_inside(a, b) ? Containment::a_in_b : Containment::none};
}

Relation relation(const ConvexSet& a, const HalfSpace& b) {
  const int below = reach_sign(a, b, Way::below);
  if (below < 0) return {};
  if (below == 0) return {RelationKind::touching};
  const int above = reach_sign(a, b, Way::above);
  if (is_solid(a)) return {RelationKind::overlapping, above <= 0 ? Containment::a_in_b : Containment::none};
  return {RelationKind::crossing, above < 0 ? Containment::a_in_b : Containment::none};
}

Relation relation(const HalfSpace& a, const HalfSpace& b) {
  const bool parallel = is_zero(cross(a.normal, b.normal));
  const Rational cosine_sign = dot(a.normal, b.normal);
  if (!parallel) return {RelationKind::overlapping};
  // Heights above b of a point on the boundary of a, in units of |b.normal|.
  const RationalPoint on_a = (a.offset / dot(a.normal, a.normal)) * a.normal;
  const Rational height = height_above(b, on_a);
  if (cosine_sign > 0) return {RelationKind::overlapping, containment_of(height <= 0, height >= 0)};
  if (height > 0) return {};
  return {height.is_zero() ? RelationKind::touching : RelationKind::overlapping};
}

int side_of(const RationalPoint& p, const ConvexSet& set) {
  const ConvexSet point{{p}, 0};
  const Rational squared = nearest_points(point, set).squared_distance;
  if (set.radius > 0) return Rational(squared - set.radius * set.radius).sign();
  if (squared > 0) return 1;
  return is_solid(set) && interiors_meet(point, set) ? -1 : 0;
}

}  // namespace toccata::oracle
