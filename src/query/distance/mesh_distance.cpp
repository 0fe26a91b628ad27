#include "query/distance/mesh_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <tuple>
#include <type_traits>

#include "math/constants.hpp"
#include "narrow/exact/within.hpp"
#include "narrow/quadrics/distance/quadric_beyond.hpp"
#include "narrow/quadrics/distance/quadric_within.hpp"
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

/// Or may be.
bool is_within(const Distance& known, const PosedPolytope& triangle, const PosedQuadric& shape, double tolerance) {
  return known.upper <= tolerance || (known.lower <= tolerance && toccata::is_within(shape, triangle, tolerance));
}
bool is_within(const PosedPolytope& triangle, const PosedQuadric& shape, double tolerance, SimplexCache*) {
  return toccata::is_within(shape, triangle, tolerance);
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

/// Of shapes of which every triangle is looked at closely.
struct NeverBeyond {
  explicit NeverBeyond(const PosedPolytope&) {}
  void look_along(const Vec3&) {}
  [[nodiscard]] bool is_beyond(const std::array<Vec3, 3>&, double) const { return false; }
};

template <class Shape>
using Beyond = std::conditional_t<std::same_as<Shape, PosedQuadric>, QuadricBeyond, NeverBeyond>;

/// The nearest triangle to a convex shape; what is farther than the cutoff is not wanted.
template <class Shape>
class NearestToShape final : public NearQuestion {
 public:
  NearestToShape(const PosedMesh& mesh, const Shape& shape, double cutoff, SimplexCache& workspace)
      : mesh_(mesh),
        shape_(shape),
        workspace_(workspace),
        cutoff_(cutoff),
        limit_(limit_from(cutoff)),
        beyond_(shape) {}

  /// Of the shape's core, which boxes are compared with.
  [[nodiscard]] double limit() const override {
    return std::max(std::nextafter(limit_ + radius_of(shape_), infinity), least_limit);
  }

  void visit(std::span<const ItemPair> pairs) override {
    for (const ItemPair& pair : pairs) {
      if (beyond_.is_beyond(mesh_.triangle(pair.first).vertex, limit_)) continue;
      const PosedPolytope triangle = convex(mesh_, pair.first);
      Distance found = distance(triangle, shape_, &workspace_);
      found.element_a = pair.first;
      beyond_.look_along(found.on_a - found.on_b);
      if (found.lower > limit_) continue;
      within_ = within_ || is_within(found, triangle, shape_, cutoff_);
      lower_ = std::min(lower_, found.lower);
      if (best_ && std::tie(best_->upper, best_->element_a) <= std::tie(found.upper, found.element_a)) continue;
      best_ = found;
      limit_ = std::min(limit_, limit_from(found.upper));
    }
  }

  [[nodiscard]] std::optional<Nearby> nearest() const {
    if (!best_) return {};
    return Nearby{least_of(*best_, lower_, shape_), within_};
  }

 private:
  const PosedMesh& mesh_;
  const Shape& shape_;
  SimplexCache& workspace_;
  double cutoff_;
  double limit_;
  Beyond<Shape> beyond_;
  std::optional<Distance> best_;
  double lower_ = infinity;  ///< of all distances
  bool within_ = false;
};

/// Ends when a triangle is found that is at most `tolerance` from the shape.
template <class Shape>
class CloseToShape final : public NearQuestion {
 public:
  CloseToShape(const PosedMesh& mesh, const Shape& shape, double tolerance, SimplexCache& workspace)
      : mesh_(mesh), shape_(shape), tolerance_(tolerance), workspace_(workspace) {}

  [[nodiscard]] double limit() const override {
    return found_ ? -1 : std::max(std::nextafter(tolerance_ + radius_of(shape_), infinity), least_limit);
  }

  void visit(std::span<const ItemPair> pairs) override {
    found_ = found_ || std::any_of(pairs.begin(), pairs.end(), [&](const ItemPair& pair) {
               workspace_.element_a = pair.first;
               return is_within(convex(mesh_, pair.first), shape_, tolerance_, &workspace_);
             });
  }

  [[nodiscard]] bool found() const { return found_; }

 private:
  const PosedMesh& mesh_;
  const Shape& shape_;
  double tolerance_;
  SimplexCache& workspace_;
  bool found_ = false;
};

Distance with_faces(Distance d, const PosedMesh& a) {
  d.face_a = a.model().mesh().face_of(d.element_a);
  return d;
}

Distance at_common_point(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

/// Shows the question the pair that was nearest before, and then all others that may matter.
void ask_near(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, NearQuestion& question) {
  const ItemPair warm{scratch.convex.element_a, scratch.convex.element_b};
  scratch.near.counts = {};
  if (warm.first < a.model().element_count() && warm.second < b.model().element_count()) question.visit({&warm, 1});
  if (question.limit() >= 0) {
    near_walk(a, b).run(scratch.near, question);
  }
  scratch.counts = scratch.near.counts;
}

bool surfaces_in_region(const PosedMesh& a, const PosedMesh& b, double tolerance, SearchScratch& scratch) {
  CloseTriangles question(a, b, scratch, tolerance);
  ask_near(a, b, scratch, question);
  if (!question.found()) return false;
  scratch.convex.element_a = question.pair().first;
  scratch.convex.element_b = question.pair().second;
  return true;
}

/// Where a shape meets triangles or lies inside the solid.
template <class Shape>
std::optional<Distance> at_least_triangle(const PosedTriangles& a, const Shape& b, SearchScratch& scratch) {
  const auto intersection = triangles_intersecting(a.mesh, b, scratch);
  if (intersection.empty()) return {};
  Distance found = distance(convex(a.mesh, intersection.front()), b);
  found.element_a = intersection.front();
  return with_faces(found, a.mesh);
}

/// Where it is proved; what is undecided is found by the distances.
std::optional<Distance> at_least_triangle(const PosedTriangles& a, const PosedQuadric& b, SearchScratch& scratch) {
  for (const Index triangle : triangles_intersecting(a.mesh, b, scratch)) {
    Distance found = toccata::distance(convex(a.mesh, triangle), b);
    if (found.upper > 0) continue;
    found.element_a = triangle;
    return with_faces(found, a.mesh);
  }
  return {};
}

/// The same for one mesh and a shape.
template <class Shape>
void ask_near(const PosedMesh& a, const Shape& b, SearchScratch& scratch, NearQuestion& question) {
  const ItemPair warm{scratch.convex.element_a, 0};
  scratch.near.counts = {};
  if (warm.first < a.model().element_count()) question.visit({&warm, 1});
  if (question.limit() >= 0) {
    const ConvexNearBvh shape(b);
    const NearFrame frame = near_frame(a);
    const NearWalk walk({a.model().oriented_boxes(), a.model().wide_bvh().items}, shape.tree(),
                        near_view(frame, shape.frame), near_view(shape.frame, frame));
    walk.run(scratch.near, question);
  }
  scratch.counts = scratch.near.counts;
}

template <class Shape>
std::optional<Nearby> outer_nearby(const PosedMesh& a, const Shape& b, double cutoff, SearchScratch& scratch) {
  NearestToShape question(a, b, cutoff, scratch.convex);
  ask_near(a, b, scratch, question);
  std::optional<Nearby> nearest = question.nearest();
  if (!nearest) return {};
  scratch.convex.element_a = nearest->distance.element_a;
  nearest->distance = with_faces(nearest->distance, a);
  return nearest;
}

template <class Shape>
std::optional<Nearby> nearby_shape(const PosedTriangles& a, const Shape& b, double cutoff, SearchScratch& scratch) {
  scratch.counts = {};
  if (const auto common = at_least_triangle(a, b, scratch)) return Nearby{*common, true};
  if (a.solid && is_interior(some_point_of(b), a.mesh))
    return Nearby{with_faces(at_common_point(some_point_of(b)), a.mesh), true};
  return outer_nearby(a.mesh, b, cutoff, scratch);
}

template <class Shape>
bool is_shape_within(const PosedTriangles& a, const Shape& b, double tolerance, SearchScratch& scratch) {
  CloseToShape question(a.mesh, b, tolerance, scratch.convex);
  ask_near(a.mesh, b, scratch, question);
  return question.found() || (a.solid && is_interior(some_point_of(b), a.mesh));
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

Distance outer_distance(const PosedMesh& a, const PosedHalfSpace& b) {
  std::optional<Distance> best;
  const auto see = [&](Index triangle) {
    Distance found = distance(convex(a, triangle), b);
    found.element_a = triangle;
    if (!best || std::tie(found.upper, found.element_a) < std::tie(best->upper, best->element_a)) best = found;
    return true;
  };
  see(lowest_triangle(a, b));
  const PosedHalfSpace region = widened(b, best->upper);
  if (is_finite(region.point))
    visit_triangles_near(a, region, see);
  else
    for (Index i = 0; i < a.model().element_count(); ++i) see(i);
  best->lower = lower_from(best->upper);
  return with_faces(*best, a);
}

}  // namespace

NearWalk near_walk(const PosedMesh& a, const PosedMesh& b) {
  const NearFrame frame_a = near_frame(a), frame_b = near_frame(b);
  return {{a.model().oriented_boxes(), a.model().wide_bvh().items},
          {b.model().oriented_boxes(), b.model().wide_bvh().items},
          near_view(frame_a, frame_b),
          near_view(frame_b, frame_a)};
}

Distance at_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  const Contact contact = *first_surface_contact(a, b, scratch);
  Distance found = distance(convex(a, contact.triangle_a), convex(b, contact.triangle_b));
  found.element_a = contact.triangle_a;
  found.element_b = contact.triangle_b;
  return found;
}

std::optional<Nearby> surfaces_nearby(const PosedMesh& a, const PosedMesh& b, double cutoff, SearchScratch& scratch) {
  NearestTriangles question(a, b, scratch, cutoff);
  ask_near(a, b, scratch, question);
  if (question.found_meeting()) return Nearby{at_contact(a, b, scratch), true};
  if (!question.found_any()) return {};
  const Distance nearest = question.nearest();
  scratch.convex.element_a = nearest.element_a;
  scratch.convex.element_b = nearest.element_b;
  return Nearby{nearest, nearest.upper <= cutoff || question.any_within(cutoff)};
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

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedTriangles& b, double cutoff, SearchScratch& scratch) {
  std::optional<Nearby> found = surfaces_nearby(a.mesh, b.mesh, cutoff, scratch);
  if (!found || found->distance.upper > 0)
    if (const auto part = inner_part(a, b)) found = Nearby{at_inner_part(*part, a.mesh, b.mesh), true};
  if (found) found->distance = with_faces(found->distance, a.mesh, b.mesh);
  return found;
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedPolytope& b, double cutoff, SearchScratch& scratch) {
  return nearby_shape(a, b, cutoff, scratch);
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedQuadric& b, double cutoff, SearchScratch& scratch) {
  return nearby_shape(a, b, cutoff, scratch);
}

std::optional<Nearby> nearby(const PosedTriangles& a, const PosedHalfSpace& b, double cutoff, SearchScratch& scratch) {
  if (cutoff < infinity && !is_within(a, b, limit_from(cutoff), scratch)) return {};
  const Distance found = distance(a, b, scratch);
  return Nearby{found, found.upper <= cutoff};  // the least double not below the exact one
}

bool is_within(const PosedTriangles& a, const PosedTriangles& b, double tolerance, SearchScratch& scratch) {
  return surfaces_in_region(a.mesh, b.mesh, tolerance, scratch) || inner_part(a, b);
}

bool is_within(const PosedTriangles& a, const PosedPolytope& b, double tolerance, SearchScratch& scratch) {
  return is_shape_within(a, b, tolerance, scratch);
}

bool is_within(const PosedTriangles& a, const PosedQuadric& b, double tolerance, SearchScratch& scratch) {
  return is_shape_within(a, b, tolerance, scratch);
}

bool is_within(const PosedTriangles& a, const PosedHalfSpace& b, double tolerance, SearchScratch& scratch) {
  scratch.counts = {};
  bool found = false;
  const auto see = [&](Index triangle) {
    found = is_within(distance(convex(a.mesh, triangle), b), convex(a.mesh, triangle), b, tolerance);
    return !found;
  };
  const PosedHalfSpace region = widened(b, tolerance);
  if (is_finite(region.point))
    visit_triangles_near(a.mesh, region, see);
  else
    for (Index i = 0; i < a.mesh.model().element_count() && !found; ++i) see(i);
  return found;
}

Distance distance(const PosedTriangles& a, const PosedTriangles& b, SearchScratch& scratch) {
  return nearby(a, b, infinity, scratch)->distance;
}

Distance distance(const PosedTriangles& a, const PosedPolytope& b, SearchScratch& scratch) {
  return nearby(a, b, infinity, scratch)->distance;
}

Distance distance(const PosedTriangles& a, const PosedQuadric& b, SearchScratch& scratch) {
  return nearby(a, b, infinity, scratch)->distance;
}

Distance distance(const PosedTriangles& a, const PosedHalfSpace& b, SearchScratch& scratch) {
  scratch.counts = {};
  if (const auto common = at_least_triangle(a, b, scratch)) return *common;
  return outer_distance(a.mesh, b);
}

}  // namespace toccata
