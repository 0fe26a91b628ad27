#include "oracle/convex.hpp"

#include <algorithm>
#include <stdexcept>

#include "oracle/hull_boundary.hpp"

namespace toccata::oracle {
namespace {

/// A point of the Minkowski difference A − B, and where it comes from.
struct DifferencePoint {
  RationalPoint on_a;
  RationalPoint on_b;
  RationalPoint difference;
};

/// The point of A − B that lies farthest against a direction. It is found from A and from B alone, as A − B has far
/// more vertices.
DifferencePoint farthest_against(const RationalPoint& direction, const ConvexSet& a, const ConvexSet& b) {
  const auto along = [&](const RationalPoint& v) { return dot(v, direction); };
  const RationalPoint& on_a = *std::ranges::min_element(a.vertices, {}, along);
  const RationalPoint& on_b = *std::ranges::max_element(b.vertices, {}, along);
  return {on_a, on_b, on_a - on_b};
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

/// The faces of the cube [−1, 1]³.
std::vector<std::vector<RationalPoint>> cube_faces() {
  std::vector<std::vector<RationalPoint>> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2) {
      std::vector<RationalPoint>& face = faces.emplace_back();
      for (const auto& [u, v] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
        face.push_back(axis == 0   ? RationalPoint{side, u, v}
                       : axis == 1 ? RationalPoint{v, side, u}
                                   : RationalPoint{u, v, side});
    }
  return faces;
}

/// Normals n, not 0, with n · d ≥ 0 for every d in A − B: the cone they form, cut by the surface of the cube [−1, 1]³,
/// as the extreme points of its (at most six) polygons.
std::vector<RationalPoint> weakly_separating_normals(const ConvexSet& a, const ConvexSet& b) {
  std::vector<RationalPoint> result;
  for (const std::vector<RationalPoint>& face : cube_faces()) {
    const std::vector<RationalPoint> part = separating_part(face, a, b);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

/// No plane separates the hulls, not even weakly. For two bodies: their interiors meet. For a body and a flat hull:
/// the hull meets the body's interior (R. T. Rockafellar, "Convex Analysis", 1970, §11).
bool no_plane_separates(const ConvexSet& a, const ConvexSet& b, const Nearness& nearness) {
  if (nearness.squared_distance > 0) return false;
  return nearness.inseparable || std::ranges::all_of(cube_faces(), [&](const std::vector<RationalPoint>& face) {
           return separating_part(face, a, b).empty();
         });
}

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

/// In some direction, of a few, the set a reaches farther than b, so that it is no subset.
bool reaches_farther(const ConvexSet& a, const ConvexSet& b) {
  for (const RationalPoint& axis : {RationalPoint{1, 0, 0}, RationalPoint{0, 1, 0}, RationalPoint{0, 0, 1}})
    for (const RationalPoint& way : {axis, -axis}) {
      const auto along = [&](const RationalPoint& v) { return dot(v, way); };
      const auto reach = [&](const ConvexSet& set) {
        return along(*std::ranges::max_element(set.vertices, {}, along)) + set.radius;
      };
      if (reach(a) > reach(b)) return true;
    }
  return false;
}

/// The solid a is a subset of the solid b. A common radius may be taken off both (cancellation law of Minkowski sums of
/// compact convex sets).
bool is_subset(const ConvexSet& a, const ConvexSet& b) {
  if (reaches_farther(a, b)) return false;
  if (a.radius <= b.radius) {
    const ConvexSet shrunk{b.vertices, b.radius - a.radius};
    return std::ranges::all_of(a.vertices, [&](const RationalPoint& p) { return side_of(p, shrunk) <= 0; });
  }
  // What is left of a is round, so b's core must be a body that holds it.
  const std::vector<RationalPoint> four = spanning(b.vertices);
  if (four.size() < 4) return false;
  const Rational radius_squared = (a.radius - b.radius) * (a.radius - b.radius);
  for (const BoundaryTriangle& facet : boundary(b.vertices, four))
    for (const RationalPoint& p : a.vertices) {
      const Rational height = height_above(facet.behind, p);
      if (height > 0 || height * height < radius_squared * dot(facet.behind.normal, facet.behind.normal)) return false;
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

Separation::Separation(const ConvexSet& a, const ConvexSet& b)
    : squared_(squared_distance(a, b)), radii_(a.radius + b.radius) {}

int Separation::compare(const Rational& gap) const {
  const Rational reach = radii_ + gap;
  // Sets that meet have distance 0, however deep they overlap.
  if (overlap()) return gap.is_zero() ? 0 : -1;
  return Rational(squared_ - reach * reach).sign();
}

int compare_distance(const ConvexSet& a, const ConvexSet& b, const Rational& gap) {
  return Separation(a, b).compare(gap);
}

int compare_distance(const ConvexSet& a, const HalfSpace& b, const Rational& gap) {
  if (overlap(a, b)) return gap.is_zero() ? 0 : -1;
  return -reach_sign({a.vertices, a.radius + gap}, b, Way::below);
}

bool overlap(const ConvexSet& a, const ConvexSet& b) { return Separation(a, b).overlap(); }

bool overlap(const ConvexSet& a, const HalfSpace& b) { return reach_sign(a, b, Way::below) >= 0; }

bool overlap(const HalfSpace& a, const HalfSpace& b) { return relation(a, b).kind != RelationKind::apart; }

bool interiors_meet(const ConvexSet& a, const ConvexSet& b) {
  const Rational reach = a.radius + b.radius;
  const Nearness near = nearness(a, b);
  const bool deep = reach > 0 ? near.squared_distance < reach * reach : no_plane_separates(a, b, near);
  return deep && is_solid(a) && is_solid(b);
}

Relation relation(const ConvexSet& a, const ConvexSet& b) { return relation(a, is_solid(a), b, is_solid(b)); }

Relation relation(const ConvexSet& a, bool a_solid, const ConvexSet& b, bool b_solid) {
  if (!a_solid && !b_solid) return relation_of_surfaces(a, b);
  const Nearness near = nearness(a, b);
  const Rational &squared = near.squared_distance, reach = a.radius + b.radius;
  if (squared > reach * reach) return {};
  // A set with a radius meets another's interior as soon as the cores are nearer than the radii reach.
  const bool deep = reach > 0 ? squared < reach * reach : no_plane_separates(a, b, near);
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
  const Nearness near = nearness(point, set);
  if (set.radius > 0) return Rational(near.squared_distance - set.radius * set.radius).sign();
  if (near.squared_distance > 0) return 1;
  return is_solid(set) && no_plane_separates(point, set, near) ? -1 : 0;
}

}  // namespace toccata::oracle
