#include <algorithm>
#include <cmath>

#include "narrow/box_contact.hpp"
#include "narrow/contact_faces.hpp"
#include "narrow/plain_topology.hpp"

namespace toccata {
namespace {

/// A gap of this part of the size of the contact still belongs to it, so that a resting box keeps its four points.
constexpr double gap_of_resting = 0x1p-10;

/// An edge pair has to be this much less deep than the best face: faces give more points.
constexpr double edge_share = 0.98;

using Points = std::span<BoxContactPoint>;

double squared_way(const BoxContactPoint& p, const BoxContactPoint& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

void drop_gaps(BoxContact& contact) {
  double span = 0;
  for (std::size_t i = 1; i < contact.count; ++i)
    span = std::max(span, squared_way(contact.points[0], contact.points[i]));
  const double gap = gap_of_resting * std::sqrt(span);
  const auto end = contact.points.begin() + static_cast<std::ptrdiff_t>(contact.count);
  const auto kept = std::remove_if(contact.points.begin(), end, [=](const BoxContactPoint& p) { return p.gap > gap; });
  contact.count = static_cast<std::size_t>(kept - contact.points.begin());
}

/// Of the points from `first` on, brings the one where the measure is greatest to the front.
template <class Measure>
void bring_greatest(Points points, std::size_t first, const Measure& measure) {
  std::size_t best = first;
  double greatest = measure(points[first]);
  for (std::size_t i = first + 1; i < points.size(); ++i) {
    const double here = measure(points[i]);
    if (!(here > greatest)) continue;
    greatest = here;
    best = i;
  }
  std::rotate(points.begin() + static_cast<std::ptrdiff_t>(first), points.begin() + static_cast<std::ptrdiff_t>(best),
              points.begin() + static_cast<std::ptrdiff_t>(best) + 1);
}

/// The deepest, the farthest from it, and the farthest to both sides of the line through these come first.
void order_by_importance(Points points) {
  if (points.size() < 2) return;
  bring_greatest(points, 0, [](const BoxContactPoint& p) { return -p.gap; });
  const BoxContactPoint deepest = points[0];
  bring_greatest(points, 1, [&](const BoxContactPoint& p) { return squared_way(p, deepest); });
  if (points.size() < 4) return;
  const BoxContactPoint farthest = points[1];
  const auto aside = [&](const BoxContactPoint& p) {
    return (farthest.x - deepest.x) * (p.y - deepest.y) - (farthest.y - deepest.y) * (p.x - deepest.x);
  };
  bring_greatest(points, 2, aside);
  // To the other side of the line, or beyond the third.
  const double turn = aside(points[2]) > 0 ? -1 : 1;
  bring_greatest(points, 3, [&](const BoxContactPoint& p) { return turn * aside(p); });
}

ConvexFeature edge_between(Index low, Index high) {
  const HullTopology topology = box_topology();
  Index half_edge = topology.leaving[low];
  while (topology.target(half_edge) != high) half_edge = topology.next(topology.twin[half_edge]);
  return {ConvexFeature::Kind::edge, edge_number(topology, half_edge)};
}

ConvexFeature edge_of(const BoxView& box, int edge, const Vec3& direction) {
  const Index bit = 1U << edge, low = farthest_corner(box, direction) & ~bit;
  return edge_between(low, low | bit);
}

ManifoldPoint point_of_edges(const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis) {
  const EdgePoints at = points_of_edges(a, b, axis);
  return {at.on_a + 0.5 * (at.on_b - at.on_a), axis.depth, edge_of(a, axis.edge_a, axis.direction),
          edge_of(b, axis.edge_b, -axis.direction)};
}

}  // namespace

Manifold manifold_of_rigid_boxes(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes) {
  const ChosenBoxAxis axis = least_axis(a, b, axes, edge_share);
  Manifold result;
  result.normal = axis.direction;
  BoxContact contact = contact_of_faces(a, b, axis);
  drop_gaps(contact);
  order_by_importance({contact.points.data(), contact.count});
  const BoxView& reference = contact.b_is_reference ? b : a;
  for (std::size_t i = 0; i < std::min(contact.count, std::size_t{4}); ++i) {
    const BoxContactPoint& p = contact.points[i];
    ManifoldPoint& point = result.points[i];
    point = {contact.position(p, reference, axis.direction), -p.gap, p.on_reference, p.on_incident};
    if (contact.b_is_reference) std::swap(point.on_a, point.on_b);
    ++result.count;
  }
  if (result.count == 0 && axis.edge_a < 3 && axis.edge_b < 3)
    result.points[static_cast<std::size_t>(result.count++)] = point_of_edges(a, b, axis);
  return result;
}

}  // namespace toccata
