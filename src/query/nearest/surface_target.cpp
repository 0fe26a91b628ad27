#include "query/nearest/surface_target.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "math/world_vertex.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Bounds: docs/methods/nearest-point.md.
namespace toccata {
namespace {

void put(TriangleBlock& block, std::size_t lane, const Triangle& triangle) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      block.corner[corner][static_cast<std::size_t>(axis)][lane] = triangle.vertex[corner][axis];
}

}  // namespace

SurfaceTarget::SurfaceTarget(const PosedMesh& mesh, Index first_element, Index first_face, std::size_t points)
    : pose_(mesh.pose()),
      mesh_(mesh.model().mesh()),
      tree_(mesh.model().wide_bvh()),
      way_(mesh),
      stretch_(stretch_of(way_.back())),
      leaves_(stretch_.is_equal ? mesh.model().leaf_triangles_for(points) : nullptr),
      first_element_(first_element),
      first_face_(first_face) {}

SurfaceTarget::SurfaceTarget(const Model& standing, std::size_t points)
    : mesh_(standing.mesh()),
      tree_(standing.wide_bvh()),
      way_(tree_),
      stretch_(stretch_into(tree_)),
      leaves_(stretch_.is_equal ? standing.leaf_triangles_for(points) : nullptr),
      first_element_(0),
      first_face_(0) {}

WidePoint SurfaceTarget::in_tree(const Vec3& point) const {
  return {way_.place(point - pose_.offset), 2 * way_.off(largest_magnitude(point))};
}

bool SurfaceTarget::is_usable(const WidePoint& in_tree) const {
  return way_.usable() && is_finite(in_tree.at) && std::isfinite(in_tree.pad) && std::isfinite(stretch_.greatest);
}

bool SurfaceTarget::is_for_leaves(const WidePoint& in_tree) const {
  return leaves_ != nullptr && is_usable(in_tree) && largest_magnitude(in_tree.at) < greatest_near_coordinate;
}

/// Not less.
float SurfaceTarget::limit_in_tree(double limit) const {
  const double in_units = limit * stretch_.greatest;
  return in_units < 0x1p100 ? static_cast<float>(in_units) * (1 + 0x1p-20F) + 0x1p-100F : HUGE_VALF;
}

void SurfaceTarget::see_near(const Vec3& point, NearestElements& nearest, SearchScratch& scratch) const {
  const WidePoint at = in_tree(point);
  if (is_for_leaves(at))
    see_at_leaves(point, at, nearest, scratch);
  else if (is_usable(at))
    see_by_walk(point, at, nearest, scratch);
  else
    see_all(point, nearest);
}

void SurfaceTarget::see_at_leaves(const Vec3& point, const WidePoint& in_tree, NearestElements& nearest,
                                  SearchScratch& scratch) const {
  NearTriangles near(nearest.k(), limit_in_tree(nearest.limit()), scratch.near_triangles[0]);
  const PointCounts counts = find_near(tree_, *leaves_, in_tree, near);
  scratch.counts.volume_tests += counts.boxes;
  scratch.counts.items += counts.triangles;
  see_left(point, near.those_left(), nearest, scratch);
}

/// What is left by the bounds in floats.
void SurfaceTarget::see_left(const Vec3& point, std::span<const Index> left, NearestElements& nearest,
                             SearchScratch& scratch) const {
  if (left.size() <= TriangleBlock::lanes) {
    if (!left.empty()) see(point, left, nearest);
    return;
  }
  NearestCandidates candidates(nearest, scratch.near_elements);
  for (; !left.empty(); left = left.subspan(std::min(TriangleBlock::lanes, left.size())))
    bound_few(point, left.first(std::min(TriangleBlock::lanes, left.size())), candidates);
  see_candidates(point, candidates, nearest);
}

void SurfaceTarget::see_by_walk(const Vec3& point, const WidePoint& in_tree, NearestElements& nearest,
                                SearchScratch& scratch) const {
  NearestCandidates candidates(nearest, scratch.near_elements);
  const auto limit = [&] { return candidates.limit() * stretch_.greatest; };
  scratch.counts.volume_tests += walk_point(tree_, in_tree, limit(), [&](std::span<const Index> places) {
    std::array<Index, TriangleBlock::lanes> triangles;
    for (std::size_t lane = 0; lane < places.size(); ++lane) triangles[lane] = tree_.items[places[lane]];
    bound_few(point, std::span(triangles).first(places.size()), candidates);
    scratch.counts.items += places.size();
    return limit();
  });
  see_candidates(point, candidates, nearest);
}

/// At most as many as fit a block.
void SurfaceTarget::bound_few(const Vec3& point, std::span<const Index> triangles,
                              NearestCandidates& candidates) const {
  const Vec3* vertices = mesh_.vertices().data();
  TriangleBlock block;
  PointBounds bounds;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    const auto& corner = mesh_.triangles()[triangles[lane]];
    put(block, lane, {{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}});
  }
  block.count = triangles.size();
  bound(point, pose_, block, bounds);
  for (std::size_t lane = 0; lane < triangles.size(); ++lane)
    candidates.see(triangles[lane], bounds.lower[lane], bounds.upper[lane]);
}

void SurfaceTarget::see_candidates(const Vec3& point, const NearestCandidates& candidates,
                                   NearestElements& nearest) const {
  std::array<Index, TriangleBlock::lanes> few;
  std::size_t count = 0;
  candidates.for_each([&](Index triangle) {
    few[count++] = triangle;
    if (count < few.size()) return;
    see(point, few, nearest);
    count = 0;
  });
  if (count > 0) see(point, std::span(few).first(count), nearest);
}

void SurfaceTarget::see_all(const Vec3& point, NearestElements& nearest) const {
  const std::span<const Index> items = tree_.items;
  for (std::size_t i = 0; i < items.size(); i += TriangleBlock::lanes)
    see(point, items.subspan(i, std::min(TriangleBlock::lanes, items.size() - i)), nearest);
}

void SurfaceTarget::see(const Vec3& point, std::span<const Index> triangles, NearestElements& nearest) const {
  TriangleBlock block;
  PointDistances distances;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) put(block, lane, world_triangle(triangles[lane]));
  block.count = triangles.size();
  measure(point, block, distances);
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    if (distances.lower[lane] > nearest.limit()) continue;
    const Index triangle = triangles[lane];
    double upper = distances.upper[lane];
    Vec3 on_surface = distances.point(lane);
    Status status = Status::exact;
    if (!(upper >= 0)) {
      const Distance exact = distance(PosedPolytope(Point{point}), PosedPolytope(world_triangle(triangle)));
      upper = exact.upper;
      on_surface = exact.on_b;
      status = exact.status;
    }
    if (upper > nearest.limit()) continue;
    nearest.see({lower_from(upper), upper, on_surface, first_element_ + triangle, first_face_ + mesh_.face_of(triangle),
                 status});
  }
}

Triangle SurfaceTarget::world_triangle(Index number) const {
  const auto& corner = mesh_.triangles()[number];
  const Vec3* vertices = mesh_.vertices().data();
  return {{world_vertex(pose_, vertices[corner[0]]), world_vertex(pose_, vertices[corner[1]]),
           world_vertex(pose_, vertices[corner[2]])}};
}

}  // namespace toccata
