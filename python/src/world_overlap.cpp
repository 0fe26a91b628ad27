#include "world_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <toccata/query/overlap.hpp>

#include "workspace.hpp"

namespace toccata::python {
namespace {

bool bodies_overlap(const WorldBodies& bodies, Index i, Index j) {
  const InstanceView a = bodies.at(i), b = bodies.at(j);
  return overlap(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, kept_workspace());
}

/// The axis along which the boxes begin farthest apart.
int longest_axis(std::span<const Aabb> boxes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  int longest = 0;
  double length = -1;
  for (int axis = 0; axis < 3; ++axis) {
    double least = infinity, greatest = -infinity;
    for (const Aabb& box : boxes) {
      if (!std::isfinite(box.lower[axis])) continue;
      least = std::min(least, box.lower[axis]);
      greatest = std::max(greatest, box.lower[axis]);
    }
    if (greatest - least > length) {
      length = greatest - least;
      longest = axis;
    }
  }
  return longest;
}

struct Beginning {
  double at;
  Index body;
};

}  // namespace

bool any_overlap_of_few(const World& world) {
  const WorldBodies bodies{&world, world.revision()};
  const std::span<const Aabb> boxes = world.boxes();
  const int axis = longest_axis(boxes);
  std::vector<Beginning> sorted;
  sorted.reserve(boxes.size());
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i])) sorted.push_back({boxes[i].lower[axis], i});
  std::ranges::sort(sorted, {}, &Beginning::at);
  for (auto first = sorted.begin(); first != sorted.end(); ++first) {
    const Aabb& box = boxes[first->body];
    for (auto second = first + 1; second != sorted.end() && second->at <= box.upper[axis]; ++second)
      if (overlap(box, boxes[second->body]) && bodies_overlap(bodies, first->body, second->body)) return true;
  }
  return false;
}

bool any_overlap(const ObjectQueries<WorldBodies>& queries) {
  const BoxBvh& boxes = queries.boxes();
  bool found = false;
  for (Index i = 0; i < boxes.size() && !found; ++i) {
    if (is_empty(boxes.box(i))) continue;
    boxes.visit_overlapping(boxes.box(i), [&](Index j) {
      found = j > i && bodies_overlap(queries.objects(), i, j);
      return !found;
    });
  }
  return found;
}

}  // namespace toccata::python
