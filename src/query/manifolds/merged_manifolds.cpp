#include "query/manifolds/merged_manifolds.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/contact/four_points.hpp"
#include "narrow/quadrics/contact/contact_patch.hpp"

namespace toccata {
namespace {

/// Normals that differ by less are one.
constexpr double same_direction = 0x1p-20;

/// Points are as deep as each other within this part of what they span: a body that rests keeps its corners.
constexpr double same_part_of_span = 0x1p-30;

struct SeenPoint {
  Vec3 at;
  double depth = 0;
  std::size_t number = 0;
};

}  // namespace

void MergedManifolds::add(const Manifold& manifold, Index element_a, Index element_b) {
  const auto has_normal = [&](const Group& group) {
    return largest_magnitude(group.normal - manifold.normal) < same_direction;
  };
  auto group = std::ranges::find_if(groups_, has_normal);
  if (group == groups_.end()) group = groups_.insert(groups_.end(), {manifold.normal, {}});
  for (int i = 0; i < manifold.count; ++i)
    group->points.push_back({manifold.points[static_cast<std::size_t>(i)], element_a, element_b});
  ++group->manifolds;
}

std::vector<MergedManifolds::Point> MergedManifolds::few_of(const Group& group) {
  if (group.manifolds == 1) return group.points;
  const ContactFrame frame(group.points.front().point.position, group.normal);
  std::vector<SeenPoint> seen;
  double span = 0;
  for (std::size_t i = 0; i < group.points.size(); ++i) {
    const ManifoldPoint& point = group.points[i].point;
    seen.push_back({frame.placed(point.position), point.depth, i});
    span = std::max(span, largest_magnitude(seen.back().at));
  }
  std::vector<Point> few;
  for (const SeenPoint& one : FourPoints(seen, same_part_of_span * span, span).taken())
    few.push_back(group.points[one.number]);
  return few;
}

ModelManifold MergedManifolds::told(const Group& group) {
  ModelManifold result;
  result.normal = group.normal;
  for (const Point& one : few_of(group)) {
    const auto at = static_cast<std::size_t>(result.count++);
    result.points[at] = one.point;
    result.elements_a[at] = one.element_a;
    result.elements_b[at] = one.element_b;
  }
  return result;
}

std::vector<ModelManifold> MergedManifolds::merged() const {
  std::vector<ModelManifold> result;
  for (const Group& group : groups_) result.push_back(told(group));
  return result;
}

}  // namespace toccata
