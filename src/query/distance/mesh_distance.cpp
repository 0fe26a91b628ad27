#include "query/distance/mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <tuple>

#include "math/constants.hpp"
#include "narrow/quadrics/distance/quadric_beyond.hpp"
#include "query/distance/near_view.hpp"
#include "query/inside/part_inside.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/meshes/world_search.hpp"
#include "query/nearest/nearest_elements.hpp"
#include "query/nearest/nearest_triangles.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

PosedPolytope convex(const PosedMesh& mesh, Index triangle) { return PosedPolytope(mesh.triangle(triangle)); }

// What the searches below ask of a triangle and a shape.

double radius_of(const PosedPolytope& shape) { return shape.radius(); }
double radius_of(const PosedQuadric&) { return 0; }

Distance distance(const PosedPolytope& triangle, const PosedQuadric& shape, SimplexCache*) {
  return toccata::distance(triangle, shape);
}

bool is_within(const PosedPolytope& triangle, const PosedPolytope& shape, double length, SimplexCache& kept) {
  return nearby(triangle, shape, WantedDistance::within(length), &kept).has_value();
}
bool is_within(const PosedPolytope& triangle, const PosedQuadric& shape, double length, SimplexCache&) {
  return nearby(shape, triangle, WantedDistance::within(length)).has_value();
}

/// The least of several distances, of which `nearest` has the least upper end.
Distance least_of(Distance nearest, double, const PosedPolytope&) {
  nearest.lower = lower_from(nearest.upper);
  return nearest;
}
/// `lower` is the least lower end. Where all intervals are narrow, so is what is left of them.
Distance least_of(Distance nearest, double lower, const PosedQuadric&) {
  nearest.lower = lower;
  if (nearest.upper - lower <= 1e-12 * nearest.upper)
    nearest.status = Status::exact;
  else if (nearest.status == Status::exact)
    nearest.status = lower > 0 ? Status::not_converged : Status::undecided;
  return nearest;
}

/// The nearest triangle to a convex shape, or the first that is found near enough.
template <class Shape>
class NearestToShape final : public NearQuestion {
 public:
  NearestToShape(const PosedMesh& mesh, const Shape& shape, const WantedDistance& wanted, SimplexCache& workspace)
      : mesh_(mesh), shape_(shape), workspace_(workspace), wanted_(wanted), limit_(search_limit(wanted)) {}

  /// The limit for the distance from the shape's core, which boxes are compared with.
  [[nodiscard]] double limit() const override {
    return is_enough() ? -1 : std::max(std::nextafter(limit_ + radius_of(shape_), infinity), least_limit);
  }

  void visit(std::span<const ItemPair> pairs) override {
    for (const ItemPair& pair : pairs) {
      if (is_enough()) return;
      if (beyond_ && beyond_->is_beyond(mesh_.triangle(pair.first).vertex, limit_)) continue;
      look_at(pair.first);
    }
  }

  [[nodiscard]] std::optional<Nearby> nearest() const {
    if (!best_) return {};
    return is_enough() ? Nearby{*best_} : Nearby{least_of(*best_, lower_, shape_), is_within_};
  }

 private:
  [[nodiscard]] bool is_enough() const { return best_ && best_->upper <= wanted_.enough; }

  void look_at(Index number) {
    const PosedPolytope triangle = convex(mesh_, number);
    if (wanted_.enough >= 0 && is_within(triangle, shape_, wanted_.enough, workspace_))
      return keep({.upper = wanted_.enough, .element_a = number});
    if (wanted_.is_yes_or_no()) return;
    Distance found = distance(triangle, shape_, &workspace_);
    found.element_a = number;
    if constexpr (std::same_as<Shape, PosedQuadric>) {
      if (!beyond_) beyond_.emplace(shape_);
      beyond_->look_along(found.on_a - found.on_b);
    }
    if (found.lower > limit_) return;
    is_within_ = is_within_ || found.upper <= wanted_.limit ||
                 (found.lower <= wanted_.limit && is_within(triangle, shape_, wanted_.limit, workspace_));
    keep(found);
  }

  void keep(const Distance& found) {
    lower_ = std::min(lower_, found.lower);
    if (best_ && std::tie(best_->upper, best_->element_a) <= std::tie(found.upper, found.element_a)) return;
    best_ = found;
    limit_ = std::min(limit_, limit_from(found.upper));
  }

  const PosedMesh& mesh_;
  const Shape& shape_;
  SimplexCache& workspace_;
  WantedDistance wanted_;
  double limit_;
  std::optional<QuadricBeyond> beyond_;  ///< of a quadric, from the first distance on
  std::optional<Distance> best_;
  double lower_ = infinity;  ///< of all distances
  bool is_within_ = false;
};

Distance with_faces(Distance d, const PosedMesh& a) {
  d.face_a = a.model().mesh().face_of(d.element_a);
  return d;
}

Distance at_common_point(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

NearBvh near_bvh(const PosedMesh& mesh) {
  const Model& model = mesh.model();
  const WideBvh& tree = model.wide_bvh();
  return {model.oriented_boxes(), tree.items, &model.mesh(), tree.origin, tree.unit};
}

/// Shows the question the pair that was nearest before, and then all others that may matter.
void ask_near(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, NearQuestion& question) {
  const ItemPair warm{scratch.convex.element_a, scratch.convex.element_b};
  scratch.near->counts = {};
  if (warm.first < a.model().element_count() && warm.second < b.model().element_count()) question.visit({&warm, 1});
  if (question.limit() >= 0) {
    near_walk(a, b).run(*scratch.near, question);
  }
  scratch.counts = scratch.near->counts;
}

Distance at_triangle(const PosedMesh& a, Index triangle, Distance found) {
  found.element_a = triangle;
  return with_faces(found, a);
}

/// Where a shape meets some triangle.
template <class Shape>
std::optional<Distance> at_some_triangle(const PosedTriangles& a, const Shape& b, SearchScratch&) {
  const std::optional<Index> met = some_triangle_meeting(a.mesh, b);
  if (!met) return {};
  return at_triangle(a.mesh, *met, distance(convex(a.mesh, *met), b));
}

/// For a quadric, the first triangle for which the meeting is proved; what is undecided is found by the distances.
std::optional<Distance> at_some_triangle(const PosedTriangles& a, const PosedQuadric& b, SearchScratch& scratch) {
  for (const Index triangle : triangles_intersecting(a.mesh, b, scratch)) {
    const Distance found = distance(convex(a.mesh, triangle), b);
    if (!(found.upper > 0)) return at_triangle(a.mesh, triangle, found);
  }
  return {};
}

/// The same for one mesh and a shape.
template <class Shape>
void ask_near(const PosedMesh& a, const Shape& b, SearchScratch& scratch, NearQuestion& question) {
  const ItemPair warm{scratch.convex.element_a, 0};
  scratch.near->counts = {};
  if (warm.first < a.model().element_count()) question.visit({&warm, 1});
  if (question.limit() >= 0) {
    const ConvexNearBvh shape(b);
    const NearFrame frame = near_frame(a);
    const NearWalk walk(near_bvh(a), shape.tree(), near_view(frame, shape.frame), near_view(shape.frame, frame));
    walk.run(*scratch.near, question);
  }
  scratch.counts = scratch.near->counts;
}

template <class Shape>
std::optional<Nearby> outer_nearby(const PosedMesh& a, const Shape& b, const WantedDistance& wanted,
                                   SearchScratch& scratch) {
  NearestToShape question(a, b, wanted, scratch.convex);
  ask_near(a, b, scratch, question);
  std::optional<Nearby> nearest = question.nearest();
  if (!nearest) return {};
  scratch.convex.element_a = nearest->distance.element_a;
  nearest->distance = with_faces(nearest->distance, a);
  return nearest;
}

/// For a shape that meets no triangle: where it lies within the solid.
template <class Shape>
std::optional<Nearby> inner_nearby(const PosedTriangles& a, const Shape& b) {
  if (!a.solid || !is_interior(some_point_of(b), a.mesh)) return {};
  return Nearby{with_faces(at_common_point(some_point_of(b)), a.mesh)};
}

template <class Shape>
std::optional<Nearby> nearby_shape(const PosedTriangles& a, const Shape& b, const WantedDistance& wanted,
                                   SearchScratch& scratch) {
  scratch.counts = {};
  if (!wanted.is_yes_or_no()) {
    if (const auto common = at_some_triangle(a, b, scratch)) return Nearby{*common};
    if (const auto inner = inner_nearby(a, b)) return inner;
  }
  const std::optional<Nearby> found = outer_nearby(a.mesh, b, wanted, scratch);
  return found || !wanted.is_yes_or_no() ? found : inner_nearby(a, b);
}

/// The triangle with the corner that is lowest over the half-space, but for rounding.
Index lowest_triangle(const PosedMesh& a, const PosedHalfSpace& b) {
  Index lowest = 0;
  double least = infinity;
  for (Index i = 0; i < a.model().element_count(); ++i)
    for (const Vec3& corner : a.triangle(i).vertex) {
      const double height = dot(corner - b.point, b.normal);
      if (!(height < least)) continue;
      least = height;
      lowest = i;
    }
  return lowest;
}

/// Contains all that is within the distance of the half-space.
PosedHalfSpace widened(PosedHalfSpace b, double by) {
  const double largest = std::max({std::abs(b.normal.x), std::abs(b.normal.y), std::abs(b.normal.z)});
  const Vec3 normal{b.normal.x / largest, b.normal.y / largest, b.normal.z / largest};
  const double length = std::sqrt(dot(normal, normal));
  const double size = std::max({std::abs(b.point.x), std::abs(b.point.y), std::abs(b.point.z)});
  b.point = b.point + ((by + 1e-9 * (by + size)) / length) * normal;
  return b;
}

/// Calls `see` with all triangles that may be within the distance of the half-space, until it returns false.
template <class See>
void visit_triangles_within(const PosedMesh& a, const PosedHalfSpace& b, double distance, const See& see) {
  const PosedHalfSpace region = widened(b, distance);
  if (is_finite(region.point)) return visit_triangles_near(a, region, see);
  for (Index i = 0; i < a.model().element_count(); ++i)
    if (!see(i)) return;
}

bool is_within(const PosedMesh& a, const PosedHalfSpace& b, double length) {
  bool found = false;
  visit_triangles_within(a, b, length, [&](Index triangle) {
    found = nearby(convex(a, triangle), b, WantedDistance::within(length)).has_value();
    return !found;
  });
  return found;
}

Distance outer_distance(const PosedMesh& a, const PosedHalfSpace& b) {
  std::optional<Distance> best;
  const auto see = [&](Index triangle) {
    Distance found = distance(convex(a, triangle), b);
    found.element_a = triangle;
    if (!best || std::tie(found.upper, found.element_a) < std::tie(best->upper, best->element_a)) best = found;
    return true;
  };
  see(lowest_triangle(a, b));
  visit_triangles_within(a, b, best->upper, see);
  best->lower = lower_from(best->upper);
  return with_faces(*best, a);
}

}  // namespace

NearWalk near_walk(const PosedMesh& a, const PosedMesh& b) {
  const NearFrame frame_a = near_frame(a), frame_b = near_frame(b);
  return {near_bvh(a), near_bvh(b), near_view(frame_a, frame_b), near_view(frame_b, frame_a)};
}

std::optional<Distance> at_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  const std::optional<ItemPair> met = some_surface_contact(a, b, scratch);
  if (!met) return {};
  Distance found = distance(convex(a, met->first), convex(b, met->second));
  found.element_a = met->first;
  found.element_b = met->second;
  return found;
}

std::optional<Nearby> surfaces_nearby(const PosedMesh& a, const PosedMesh& b, const WantedDistance& wanted,
                                      SearchScratch& scratch) {
  // Where every distance is wanted: whether they meet is told in a small part of the time that the distance takes.
  scratch.counts = {};
  if (wanted.enough < 0)
    if (const auto met = at_contact(a, b, scratch)) return Nearby{*met};
  const WalkCounts looked = scratch.counts;
  NearestTriangles question(a, b, scratch, wanted);
  ask_near(a, b, scratch, question);
  scratch.counts.volume_tests += looked.volume_tests;
  scratch.counts.items += looked.items;
  if (!question.found_any()) return {};
  const Distance nearest = question.nearest();
  scratch.convex.element_a = nearest.element_a;
  scratch.convex.element_b = nearest.element_b;
  return Nearby{nearest, nearest.upper <= wanted.limit || question.any_within(wanted.limit)};
}

std::optional<PartInside> inner_part(const PosedTriangles& a, const PosedTriangles& b) {
  if (!overlap(a.mesh.box(), b.mesh.box())) return {};
  if (b.solid)
    if (const auto triangle = part_inside(a.mesh, b.mesh)) return PartInside{true, *triangle};
  if (a.solid)
    if (const auto triangle = part_inside(b.mesh, a.mesh)) return PartInside{false, *triangle};
  return {};
}

Distance at_inner_part(const PartInside& part, const PosedMesh& a, const PosedMesh& b) {
  Distance found = at_common_point((part.of_a ? a : b).triangle(part.triangle)[0]);
  (part.of_a ? found.element_a : found.element_b) = part.triangle;
  return found;
}

Distance with_faces(Distance d, const PosedMesh& a, const PosedMesh& b) {
  d.face_b = b.model().mesh().face_of(d.element_b);
  return with_faces(d, a);
}

bool meshes_overlap(const PosedMesh& a, bool a_solid, const PosedMesh& b, bool b_solid, SearchScratch& scratch) {
  return overlap(a.box(), b.box()) &&
         (surfaces_meet(a, b, scratch) || (b_solid && part_inside(a, b)) || (a_solid && part_inside(b, a)));
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedTriangles& b, const WantedDistance& wanted,
                             SearchScratch& scratch) {
  if (wanted.is_yes_or_no() && wanted.limit == 0)
    return meshes_overlap(a.mesh, a.solid, b.mesh, b.solid, scratch) ? std::optional(Nearby{}) : std::nullopt;
  std::optional<Nearby> found = surfaces_nearby(a.mesh, b.mesh, wanted, scratch);
  if (!found || found->distance.upper > std::max(wanted.enough, 0.0))
    if (const auto part = inner_part(a, b)) found = Nearby{at_inner_part(*part, a.mesh, b.mesh)};
  if (found) found->distance = with_faces(found->distance, a.mesh, b.mesh);
  return found;
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedPolytope& b, const WantedDistance& wanted,
                             SearchScratch& scratch) {
  return nearby_shape(a, b, wanted, scratch);
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedQuadric& b, const WantedDistance& wanted,
                             SearchScratch& scratch) {
  return nearby_shape(a, b, wanted, scratch);
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedHalfSpace& b, const WantedDistance& wanted,
                             SearchScratch& scratch) {
  scratch.counts = {};
  return nearby_by(
      wanted, Quicker::comparison,
      [&](double length) { return length == 0 ? overlap(a, b) : is_within(a.mesh, b, length); },
      [&] {
        const auto common = at_some_triangle(a, b, scratch);
        return common ? *common : outer_distance(a.mesh, b);
      });
}

}  // namespace toccata
