#include "query/contacts/self_intersection.hpp"

#include <algorithm>
#include <array>

#include "narrow/triangles/plane_sides.hpp"

// Let S be the vertices that a and b share, as points. S lies in the meeting, which is convex; so the meeting is the
// hull of S exactly when its extreme points are all in S.

namespace toccata {
namespace {

/// Which vertices of each triangle have a twin in the other; bit i for vertex i.
struct SharedVertices {
  unsigned of_a = 0;
  unsigned of_b = 0;

  [[nodiscard]] bool none() const { return of_a == 0; }
  [[nodiscard]] bool all() const { return of_a == 7U && of_b == 7U; }
};

SharedVertices shared_vertices(const Triangle& a, const Triangle& b) {
  SharedVertices shared;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (a.vertex[i] == b.vertex[j]) {
        shared.of_a |= 1U << i;
        shared.of_b |= 1U << j;
      }
  return shared;
}

/// All vertices of `t` that are not in the set lie strictly on one side of the plane of `plane`, as far as plain
/// arithmetic can tell. Then that plane exists, and `t` has only the hull of the set in it, if the set lies in it.
bool stands_on(const Triangle& plane, const Triangle& t, unsigned set) {
  const PlaneSides sides = likely_sides(plane, t);
  Sign side = Sign::zero;
  for (unsigned i = 0; i < 3; ++i) {
    if ((set >> i & 1U) != 0) continue;
    if (sides.of[i] == Sign::zero || sides.of[i] == -side) return false;
    side = sides.of[i];
  }
  return side != Sign::zero;
}

/// True only where the triangles meet in the hull of the shared vertices and nowhere else: most neighbours in meshes.
bool plainly_proper(const Triangle& a, const Triangle& b, const SharedVertices& shared) {
  return !shared.none() && (stands_on(a, b, shared.of_b) || stands_on(b, a, shared.of_a));
}

/// The extreme point p of a segment is a shared vertex. Where both features are edges it is none: it could be one only
/// as the middle vertex of two triangles without area, and of what two segments on one line have in common, the ends
/// are ends of one of them.
bool is_shared(const IntersectionPoint& p, const SharedVertices& shared) {
  const auto has = [](unsigned set, const Feature& f) {
    return f.kind == FeatureKind::vertex && (set >> f.index & 1U) != 0;
  };
  return has(shared.of_a, p.on_a) || has(shared.of_b, p.on_b);
}

/// `m` is the meeting, and they share a vertex.
bool is_hull_of_shared(const Intersection& m, const SharedVertices& shared) {
  if (m.kind == IntersectionKind::point) return true;
  return m.kind == IntersectionKind::segment && is_shared(m.points[0], shared) && is_shared(m.points[1], shared);
}

}  // namespace

Intersection self_intersection(const Triangle& a, const Triangle& b) {
  const SharedVertices shared = shared_vertices(a, b);
  if (shared.none()) return intersect(a, b);
  if (!shared.all() && plainly_proper(a, b, shared)) return {};
  const Intersection common = intersect(a, b);
  return !shared.all() && is_hull_of_shared(common, shared) ? Intersection{} : common;
}

bool self_meet(const Triangle& a, const Triangle& b) {
  const SharedVertices shared = shared_vertices(a, b);
  if (shared.none()) return overlap(a, b);
  if (shared.all()) return true;
  return !plainly_proper(a, b, shared) && !is_hull_of_shared(intersect(a, b), shared);
}

}  // namespace toccata
