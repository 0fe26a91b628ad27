#include "query/casts/mesh_casts.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "narrow/quadrics/casts/quadric_cast_until.hpp"
#include "narrow/triangles/separating_normal.hpp"
#include "query/casts/swept_view.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/keep_least.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/relation/relation_locality.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

/// What is searched of a side, and an item of it.
const PosedMesh& searched(const PosedTriangles& side) { return side.mesh; }
template <class Shape>
const Shape& searched(const Shape& side) {
  return side;
}

const WideBvh* tree_of(const PosedMesh& mesh) { return &mesh.model().wide_bvh(); }
template <class Shape>
const WideBvh* tree_of(const Shape&) {
  return nullptr;
}

PosedPolytope item_of(const PosedMesh& mesh, Index triangle) { return PosedPolytope(mesh.triangle(triangle)); }
template <class Shape>
const Shape& item_of(const Shape& shape, Index) {
  return shape;
}

Index face_of(const PosedMesh& mesh, Index triangle) { return mesh.model().mesh().face_of(triangle); }
template <class Shape>
Index face_of(const Shape&, Index) {
  return 0;
}

template <class A, class B>
constexpr bool has_quadric_side = std::same_as<A, PosedQuadric> || std::same_as<B, PosedQuadric>;

/// The directions beside triangles of two meshes; those that were asked for lately are kept.
class TrianglesBeside final : public SweptItems {
 public:
  TrianglesBeside(const PosedMesh& a, const Vec3& motion, const PosedMesh& b) : a_(a), motion_(motion), b_(b) {}

  [[nodiscard]] std::span<const SweptDirection> directions_beside(std::size_t side, Index triangle) override {
    std::optional<Kept>& kept = kept_[(2 * triangle + side) % kept_.size()];
    if (!kept || kept->side != side || kept->triangle != triangle)
      kept.emplace(Kept{side, triangle, SweptView(a_, motion_, b_, side, triangle)});
    return kept->view.directions();
  }

 private:
  struct Kept {
    std::size_t side;
    Index triangle;
    SweptView view;
  };
  const PosedMesh& a_;
  const Vec3& motion_;
  const PosedMesh& b_;
  std::array<std::optional<Kept>, 32> kept_;
};

/// The first two items that meet; of meshes, their surfaces alone.
template <class A, class B>
class FirstMeeting {
 public:
  FirstMeeting(const A& a, const Vec3& motion, const B& b, double limit, SearchScratch& scratch)
      : a_(a), motion_(motion), b_(b), limit_(limit), scratch_(scratch) {}

  std::optional<ShapeHit> answer() {
    scratch_.counts = {};
    scratch_.casts.clear();
    const SweptView view(a_, motion_, b_);
    if constexpr (std::same_as<A, PosedMesh> && std::same_as<B, PosedMesh>) {
      TrianglesBeside beside(a_, motion_, b_);
      return answer_of(SweptWalk({tree_of(a_), tree_of(b_)}, view.directions(), &beside));
    } else {
      return answer_of(SweptWalk({tree_of(a_), tree_of(b_)}, view.directions()));
    }
  }

 private:
  std::optional<ShapeHit> answer_of(const SweptWalk& walk) {
    walk.run(scratch_.swept, limit_, [this](ItemPair items) {
      if constexpr (has_quadric_side<A, B>)
        look_at(items);
      else
        cast(items);
      return limit_;
    });
    cast_waiting(1);
    scratch_.counts = scratch_.swept.counts;
    return first_;
  }

  void cast(ItemPair items) {
    const auto found =
        cast_convex_until(item_of(a_, items.first), motion_, item_of(b_, items.second), limit_, scratch_.convex);
    if (!found) return;
    keep_first(first_, {*found, items.first, items.second, face_of(a_, items.first), face_of(b_, items.second)});
    limit_ = std::min(limit_, first_->upper + widest_cast);
  }

  /// Casts of quadrics cost much, and bounds of their times little: so items are cast in the order of these, and
  /// not before all that the walk has still to show come later.
  void look_at(ItemPair items) requires has_quadric_side<A, B> {
    const double time = free_until(item_of(a_, items.first), motion_, item_of(b_, items.second), limit_);
    std::vector<WaitingCast>& waiting = scratch_.casts;
    if (time <= limit_) {
      waiting.push_back({time, items});
      std::push_heap(waiting.begin(), waiting.end());
    }
    cast_waiting(scratch_.swept.waiting.empty() ? limit_ : scratch_.swept.waiting.front().time);
  }

  /// Casts the items that may meet until the time.
  void cast_waiting(double time) {
    std::vector<WaitingCast>& waiting = scratch_.casts;
    while (!waiting.empty() && waiting.front().time <= std::min(time, limit_)) {
      std::pop_heap(waiting.begin(), waiting.end());
      const ItemPair items = waiting.back().items;
      waiting.pop_back();
      cast(items);
    }
  }

  const A& a_;
  const Vec3& motion_;
  const B& b_;
  double limit_;
  SearchScratch& scratch_;
  std::optional<ShapeHit> first_;
};

ShapeHit at_start(const Vec3& point) {
  ShapeHit hit;
  hit.point = point;
  return hit;
}

// Two items that meet, of surfaces that meet at the start.

template <class Shape>
std::optional<ItemPair> items_at_start(const PosedMesh& a, const Shape& b, SearchScratch&) {
  const std::optional<Index> triangle = some_triangle_meeting(a, b);
  return triangle ? std::optional(ItemPair{*triangle, 0}) : std::nullopt;
}
template <class Shape>
std::optional<ItemPair> items_at_start(const Shape& a, const PosedMesh& b, SearchScratch&) {
  const std::optional<Index> triangle = some_triangle_meeting(b, a);
  return triangle ? std::optional(ItemPair{0, *triangle}) : std::nullopt;
}

std::optional<ShapeHit> surfaces_at_start(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  std::optional<ShapeHit> met;
  visit_surface_contacts(a, b, scratch, [&](const Contact& contact) {
    const Triangle of_a = a.triangle(contact.element_a), of_b = b.triangle(contact.element_b);
    met = at_start(intersection_points(contact.intersection, of_a, of_b).points[0]);
    met->normal = separating_normal(of_a, of_b);
    if (met->normal == Vec3{}) met->normal = start_normal(PosedPolytope(of_a), PosedPolytope(of_b));
    std::tie(met->element_a, met->element_b) = std::tie(contact.element_a, contact.element_b);
    std::tie(met->face_a, met->face_b) = std::tie(contact.face_a, contact.face_b);
    return false;
  });
  return met;
}

/// A cast that does not move asks the two alone.
template <class A, class B>
std::optional<ShapeHit> surfaces_at_start(const A& a, const B& b, SearchScratch& scratch) {
  const auto items = items_at_start(a, b, scratch);
  if (!items) return {};
  const auto found = cast_convex_until(item_of(a, items->first), {}, item_of(b, items->second), 1, scratch.convex);
  if (!found) return {};
  return ShapeHit{*found, items->first, items->second, face_of(a, items->first), face_of(b, items->second)};
}

// The hit of sides whose surfaces do not meet at the start: one is a solid that holds the other, or a part of it.

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

}  // namespace

void keep_first(std::optional<ShapeHit>& first, const ShapeHit& found) {
  keep_least(first, found, [](const ShapeHit& hit) { return std::tie(hit.upper, hit.element_a, hit.element_b); });
}

template <class A, class B>
requires std::same_as<A, PosedTriangles> || std::same_as<B, PosedTriangles> std::optional<ShapeHit> cast_until(
    const A& a, const Vec3& motion, const B& b, double limit, SearchScratch& scratch) {
  if (const auto met = surfaces_at_start(searched(a), searched(b), scratch)) return met;
  if (const auto held = held_at_start(a, b)) return held;
  if (motion == Vec3{}) return {};
  return FirstMeeting(searched(a), motion, searched(b), limit, scratch).answer();
}

template std::optional<ShapeHit> cast_until(const PosedTriangles&, const Vec3&, const PosedTriangles&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedTriangles&, const Vec3&, const PosedPolytope&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedPolytope&, const Vec3&, const PosedTriangles&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedTriangles&, const Vec3&, const PosedQuadric&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedQuadric&, const Vec3&, const PosedTriangles&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedTriangles&, const Vec3&, const PosedHalfSpace&, double,
                                            SearchScratch&);
template std::optional<ShapeHit> cast_until(const PosedHalfSpace&, const Vec3&, const PosedTriangles&, double,
                                            SearchScratch&);

}  // namespace toccata
