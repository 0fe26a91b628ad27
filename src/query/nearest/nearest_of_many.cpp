#include <algorithm>
#include <array>
#include <cstdint>

#include "core/prefetch.hpp"
#include "query/nearest/surface_target.hpp"

namespace toccata {
namespace {

constexpr std::size_t points_at_once = 64;

/// The corners of so many points' triangles are on their way from memory while one is worked on.
constexpr std::size_t points_ahead = 4;

/// What the bounds in floats leave of a point's triangles.
struct Left {
  std::array<Index, TriangleBlock::lanes> triangles;
  std::uint32_t count = 0;
  std::uint32_t point = 0;

  [[nodiscard]] std::span<const Index> all() const { return std::span(triangles).first(count); }
};

void prefetch_corners(const TriangleMesh& mesh, const Left& left) {
  for (const Index triangle : left.all())
    for (const Index corner : mesh.triangles()[triangle]) prefetch(mesh.vertices()[corner]);
}

}  // namespace

void SurfaceTarget::find_nearest(std::span<const Vec3> points, double max_distance,
                                 std::span<std::optional<SurfacePoint>> found, SearchScratch& scratch) const {
  for (std::size_t first = 0; first < points.size(); first += points_at_once) {
    const std::size_t count = std::min(points_at_once, points.size() - first);
    find_some(points.subspan(first, count), max_distance, found.subspan(first, count), scratch);
  }
}

/// Three passes, so that what one asks of memory comes while others are worked on: the walks, of which some wait
/// together; then the corners of the few triangles left; then these.
void SurfaceTarget::find_some(std::span<const Vec3> points, double max_distance,
                              std::span<std::optional<SurfacePoint>> found, SearchScratch& scratch) const {
  std::array<NearStart, points_at_once> starts;
  std::array<Left, points_at_once> left;
  const auto finish = [&](std::size_t point, const auto& see) {
    NearestElements nearest(1, max_distance, scratch.surface_points);
    see(nearest);
    found[point] = nearest.first();
  };
  const float limit = limit_in_tree(a_little_above(max_distance));
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WidePoint at = in_tree(points[i]);
    found[i] = {};
    if (is_for_leaves(at)) {
      starts[count] = {at, limit};
      left[count++] = {{}, 0, static_cast<std::uint32_t>(i)};
    } else {
      finish(i, [&](NearestElements& nearest) { see_near(points[i], nearest, scratch); });
    }
  }
  const auto keep_left = [&](std::size_t i, NearTriangles& near) {
    const std::span<const Index> some = near.those_left();
    if (some.size() > TriangleBlock::lanes) {
      const std::size_t point = left[i].point;
      return finish(point, [&](NearestElements& nearest) { see_left(points[point], some, nearest, scratch); });
    }
    for (const Index triangle : some) {
      prefetch(mesh_.triangles()[triangle]);
      left[i].triangles[left[i].count++] = triangle;
    }
  };
  find_near_each(tree_, *leaves_, std::span(starts).first(count), scratch.near_triangles, keep_left);
  for (std::size_t i = 0; i < std::min(points_ahead, count); ++i) prefetch_corners(mesh_, left[i]);
  for (std::size_t i = 0; i < count; ++i) {
    if (i + points_ahead < count) prefetch_corners(mesh_, left[i + points_ahead]);
    if (left[i].count > 0)
      finish(left[i].point, [&](NearestElements& nearest) { see(points[left[i].point], left[i].all(), nearest); });
  }
}

}  // namespace toccata
