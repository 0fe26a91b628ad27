#include "query/casts/mesh_casts.hpp"

#include <algorithm>
#include <tuple>

#include "narrow/convex/cast_until.hpp"
#include "query/casts/swept_view.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/relation/relation_locality.hpp"
#include "toccata/narrow/smooth_casts.hpp"

namespace toccata {
namespace {

/// What is searched of a side, and an item of it.
const PosedMesh& searched(const PosedTriangles& side) { return side.mesh; }
template <class Shape>
const Shape& searched(const Shape& side) {
  return side;
}

const WideTree* tree_of(const PosedMesh& mesh) { return &mesh.model().wide_tree(); }
template <class Shape>
const WideTree* tree_of(const Shape&) {
  return nullptr;
}

PosedConvex item_of(const PosedMesh& mesh, Index triangle) { return PosedConvex(mesh.triangle(triangle)); }
template <class Shape>
const Shape& item_of(const Shape& shape, Index) {
  return shape;
}

Index face_of(const PosedMesh& mesh, Index triangle) { return mesh.model().mesh().face_of(triangle); }
template <class Shape>
Index face_of(const Shape&, Index) {
  return 0;
}

std::optional<Cast> cast_items(const PosedConvex& a, const Vec3& motion, const PosedConvex& b, double limit,
                               SearchScratch& scratch) {
  return cast_shape_until(a, motion, b, limit, scratch.convex);
}
std::optional<Cast> cast_items(const PosedConvex& a, const Vec3& motion, const PosedSmooth& b, double, SearchScratch&) {
  return cast_shape(a, motion, b);
}
std::optional<Cast> cast_items(const PosedSmooth& a, const Vec3& motion, const PosedConvex& b, double, SearchScratch&) {
  return cast_shape(a, motion, b);
}
std::optional<Cast> cast_items(const PosedConvex& a, const Vec3& motion, const PosedHalfSpace& b, double,
                               SearchScratch&) {
  return cast_shape(a, motion, b);
}
std::optional<Cast> cast_items(const PosedHalfSpace& a, const Vec3& motion, const PosedConvex& b, double,
                               SearchScratch&) {
  return seen_from_target(cast_shape(b, -motion, a), motion);
}

/// The first two items that meet; of meshes, their surfaces alone.
template <class A, class B>
std::optional<ShapeHit> cast_surfaces(const A& a, const Vec3& motion, const B& b, double limit,
                                      SearchScratch& scratch) {
  scratch.counts = {};
  const SweptView view(a, motion, b);
  std::optional<ShapeHit> first;
  const SweptWalk walk({tree_of(a), tree_of(b)}, view.directions());
  walk.run(scratch.swept, limit, [&](ItemPair items) {
    const auto found = cast_items(item_of(a, items.first), motion, item_of(b, items.second), limit, scratch);
    if (!found || !found->hit) return limit;
    keep_first(first, {*found, items.first, items.second, face_of(a, items.first), face_of(b, items.second)});
    return limit = std::min(limit, first->upper + widest_cast);
  });
  scratch.counts = scratch.swept.counts;
  return first;
}

ShapeHit at_start(const Vec3& point) {
  ShapeHit hit;
  hit.hit = true;
  hit.point = point;
  return hit;
}

// Of sides whose surfaces do not meet at the start: a solid that holds the other, or a part of it.

std::optional<ShapeHit> held_at_start(const PosedTriangles& a, const PosedTriangles& b) {
  const auto part = inner_part(a, b);
  if (!part) return {};
  const Distance found = with_faces(at_inner_part(*part, a.mesh, b.mesh), a.mesh, b.mesh);
  ShapeHit hit = at_start(found.on_b);
  (part->of_a ? hit.element_a : hit.element_b) = part->triangle;
  (part->of_a ? hit.face_a : hit.face_b) = part->of_a ? found.face_a : found.face_b;
  return hit;
}

template <class Shape>
std::optional<ShapeHit> held_at_start(const PosedTriangles& a, const Shape& b) {
  const Vec3 point = some_point_of(b);
  const bool is_held = a.solid && overlap(a.mesh.box(), Aabb{point, point}) && is_interior(point, a.mesh);
  return is_held ? std::optional(at_start(point)) : std::nullopt;
}
template <class Shape>
std::optional<ShapeHit> held_at_start(const Shape& a, const PosedTriangles& b) {
  return held_at_start(b, a);
}

std::optional<ShapeHit> held_at_start(const PosedTriangles&, const PosedHalfSpace&) { return {}; }
std::optional<ShapeHit> held_at_start(const PosedHalfSpace&, const PosedTriangles&) { return {}; }

template <class A, class B>
std::optional<ShapeHit> cast_sides(const A& a, const Vec3& motion, const B& b, double limit, SearchScratch& scratch) {
  const auto first = cast_surfaces(searched(a), motion, searched(b), limit, scratch);
  if (first && first->upper == 0) return first;
  const auto held = held_at_start(a, b);
  return held ? held : first;
}

}  // namespace

Cast seen_from_target(const Cast& cast, const Vec3& motion) {
  Cast result = cast;
  result.normal = -cast.normal;
  if (cast.hit) result.point = cast.point + cast.upper * motion;
  return result;
}

void keep_first(std::optional<ShapeHit>& first, const ShapeHit& found) {
  const auto rank = [](const ShapeHit& hit) { return std::tie(hit.upper, hit.element_a, hit.element_b); };
  const double lower = first ? std::min(first->lower, found.lower) : found.lower;
  if (!first || rank(found) < rank(*first)) first = found;
  first->lower = lower;
}

std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedTriangles& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedConvex& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedConvex& a, const Vec3& motion, const PosedTriangles& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedSmooth& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedSmooth& a, const Vec3& motion, const PosedTriangles& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedHalfSpace& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}
std::optional<ShapeHit> cast_until(const PosedHalfSpace& a, const Vec3& motion, const PosedTriangles& b, double limit,
                                   SearchScratch& scratch) {
  return cast_sides(a, motion, b, limit, scratch);
}

}  // namespace toccata
