#include "query/surface_target.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/world_vertex.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Bounds: docs/methods/nearest-point.md.
namespace toccata {
namespace {

double greatest_of(const Vec3& v) { return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z)); }

void put(TriangleBlock& block, std::size_t lane, const Triangle& triangle) {
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      block.corner[corner][static_cast<std::size_t>(axis)][lane] = triangle.vertex[corner][axis];
}

}  // namespace

SurfaceTarget::SurfaceTarget(const PosedMesh& mesh, Index first_element, Index first_face)
    : posed_(mesh),
      mesh_(mesh.model().mesh()),
      tree_(mesh.model().wide_tree()),
      way_(mesh),
      stretch_(greatest_stretch(way_.back())),
      first_element_(first_element),
      first_face_(first_face) {}

void SurfaceTarget::see_near(const Vec3& point, NearestElements& nearest, SearchScratch& scratch) const {
  const WidePoint in_tree{way_.place(point - posed_.pose().offset), 2 * way_.off(greatest_of(point))};
  if (!way_.usable() || !is_finite(in_tree.at) || !std::isfinite(in_tree.pad) || !std::isfinite(stretch_))
    return see_all(point, nearest);
  NearestCandidates candidates(nearest, scratch.near_elements);
  find(point, in_tree, candidates, scratch.counts);
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

void SurfaceTarget::find(const Vec3& point, const WidePoint& in_tree, NearestCandidates& candidates,
                         WalkCounts& counts) const {
  const auto limit = [&] { return candidates.limit() * stretch_; };
  const Vec3* vertices = mesh_.vertices().data();
  TriangleBlock block;
  PointBounds bounds;
  counts.volume_tests += walk_point(tree_, in_tree, limit(), [&](std::span<const Index> places) {
    for (std::size_t lane = 0; lane < places.size(); ++lane) {
      const auto& corner = mesh_.triangles()[tree_.items[places[lane]]];
      put(block, lane, {{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}});
    }
    block.count = places.size();
    bound(point, posed_.pose(), block, bounds);
    for (std::size_t lane = 0; lane < places.size(); ++lane)
      candidates.see(tree_.items[places[lane]], bounds.lower[lane], bounds.upper[lane]);
    counts.items += places.size();
    return limit();
  });
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
      const Distance exact = distance(PosedConvex(Point{point}), PosedConvex(world_triangle(triangle)));
      upper = exact.upper;
      on_surface = exact.on_b;
      status = exact.status;
    }
    if (upper > nearest.limit()) continue;
    nearest.see({true, lower_from(upper), upper, on_surface, first_element_ + triangle,
                 first_face_ + mesh_.face_of(triangle), status});
  }
}

Triangle SurfaceTarget::world_triangle(Index number) const {
  const auto& corner = mesh_.triangles()[number];
  const Vec3* vertices = mesh_.vertices().data();
  const Pose& pose = posed_.pose();
  return {{world_vertex(pose, vertices[corner[0]]), world_vertex(pose, vertices[corner[1]]),
           world_vertex(pose, vertices[corner[2]])}};
}

}  // namespace toccata
