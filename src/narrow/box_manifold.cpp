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

double squared_way(const BoxContactCorner& p, const BoxContactCorner& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

bool are_the_same(const BoxContactCorner& p, const BoxContactCorner& q) {
  return p.x == q.x && p.y == q.y && p.gap == q.gap;
}

/// The corners that are left to be taken, by number.
struct Candidates {
  std::array<std::uint8_t, BoxContact::capacity> number;
  std::size_t count = 0;

  /// Removes the one of the greatest measure; of several the first.
  template <class Measure>
  std::uint8_t take_greatest(const Measure& measure) {
    std::size_t best = 0;
    double greatest = measure(number[0]);
    for (std::size_t k = 1; k < count; ++k) {
      const double here = measure(number[k]);
      if (!(here > greatest)) continue;
      greatest = here;
      best = k;
    }
    const std::uint8_t taken = number[best];
    --count;
    for (std::size_t k = best; k < count; ++k) number[k] = number[k + 1];
    return taken;
  }
};

/// Those that touch or nearly do, each place once.
Candidates candidates_of(const BoxContact& contact) {
  double span = 0;
  for (std::size_t i = 1; i < contact.count; ++i)
    span = std::max(span, squared_way(contact.corners[0], contact.corners[i]));
  const double gap = gap_of_resting * std::sqrt(span);
  Candidates candidates;
  for (std::size_t i = 0; i < contact.count; ++i) {
    const BoxContactCorner& before = contact.corners[i == 0 ? contact.count - 1 : i - 1];
    if (contact.corners[i].gap > gap || (i > 0 && are_the_same(contact.corners[i], before))) continue;
    candidates.number[candidates.count++] = static_cast<std::uint8_t>(i);
  }
  // The polygon may end where it began.
  if (candidates.count > 1 &&
      are_the_same(contact.corners[candidates.number[0]], contact.corners[candidates.number[candidates.count - 1]]))
    --candidates.count;
  return candidates;
}

/// Up to four.
struct Chosen {
  std::array<std::uint8_t, 4> number;
  std::size_t count = 0;
};

/// The deepest, the farthest from it, and the farthest to both sides of the line through these.
Chosen chosen_of(const BoxContact& contact) {
  Candidates candidates = candidates_of(contact);
  Chosen chosen;
  const auto take = [&](const auto& measure) { chosen.number[chosen.count++] = candidates.take_greatest(measure); };
  const auto& corners = contact.corners;
  if (candidates.count == 0) return chosen;
  take([&](std::uint8_t i) { return -corners[i].gap; });
  if (candidates.count == 0) return chosen;
  const BoxContactCorner& deepest = corners[chosen.number[0]];
  take([&](std::uint8_t i) { return squared_way(corners[i], deepest); });
  if (candidates.count == 0) return chosen;
  const BoxContactCorner& farthest = corners[chosen.number[1]];
  const auto aside = [&](std::uint8_t i) {
    return (farthest.x - deepest.x) * (corners[i].y - deepest.y) -
           (farthest.y - deepest.y) * (corners[i].x - deepest.x);
  };
  take(aside);
  if (candidates.count == 0) return chosen;
  // To the other side of the line, or beyond the third.
  const double turn = aside(chosen.number[2]) > 0 ? -1 : 1;
  take([&](std::uint8_t i) { return turn * aside(i); });
  return chosen;
}

/// Between the side that comes in and the one that leaves.
struct CornerFeatures {
  ConvexFeature on_reference;
  ConvexFeature on_incident;
};

CornerFeatures features_of(const BoxFacePair& faces, std::uint8_t in, std::uint8_t out, const HullTopology& topology) {
  using Kind = ConvexFeature::Kind;
  constexpr std::uint8_t of_reference = BoxContactCorner::of_reference;
  const Index half_edge_in = in % of_reference, half_edge_out = out % of_reference;
  if (in < of_reference && out < of_reference)
    return {{Kind::face, faces.reference.number()}, {Kind::vertex, topology.origin[half_edge_out]}};
  if (in >= of_reference && out >= of_reference) {
    const bool follows = topology.next(half_edge_in) == half_edge_out;
    return {{Kind::vertex, topology.origin[follows ? half_edge_out : half_edge_in]},
            {Kind::face, faces.incident.number()}};
  }
  const Index side = in >= of_reference ? half_edge_in : half_edge_out,
              edge = in >= of_reference ? half_edge_out : half_edge_in;
  return {{Kind::edge, edge_number(topology, side)}, {Kind::edge, edge_number(topology, edge)}};
}

ConvexFeature edge_of(const BoxView& box, int edge, const Vec3& direction, const HullTopology& topology) {
  const Index bit = 1U << edge, low = farthest_corner(box, direction) & ~bit;
  Index half_edge = topology.leaving[low];
  while (topology.target(half_edge) != (low | bit)) half_edge = topology.next(topology.twin[half_edge]);
  return {ConvexFeature::Kind::edge, edge_number(topology, half_edge)};
}

ManifoldPoint point_of_edges(const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis,
                             const HullTopology& topology) {
  const EdgePoints at = points_of_edges(a, b, axis);
  return {at.on_a + 0.5 * (at.on_b - at.on_a), axis.depth, edge_of(a, axis.edge_a, axis.direction, topology),
          edge_of(b, axis.edge_b, -axis.direction, topology)};
}

/// Of boxes that are not certainly apart; without points where no face lies over another.
void find_points(Manifold& result, const BoxView& a, const BoxView& b, const RigidBoxAxes& axes) {
  const ChosenBoxAxis axis = least_axis(a, b, axes, edge_share);
  const HullTopology topology = box_topology();
  result.normal = axis.direction;
  const BoxContact contact = contact_of_faces(a, b, axes, axis);
  const Chosen chosen = chosen_of(contact);
  if (chosen.count == 0) {
    if (axis.edge_a < 3 && axis.edge_b < 3)
      result.points[static_cast<std::size_t>(result.count++)] = point_of_edges(a, b, axis, topology);
    return;
  }
  const bool b_is_reference = contact.faces.b_is_reference;
  const BoxFacePlane plane(b_is_reference ? b : a, contact.faces.reference);
  const Vec3 half_way = (b_is_reference ? -0.5 : 0.5) * axis.direction;
  for (std::size_t k = 0; k < chosen.count; ++k) {
    const std::size_t i = chosen.number[k];
    const BoxContactCorner& p = contact.corners[i];
    const CornerFeatures features =
        features_of(contact.faces, contact.corners[i == 0 ? contact.count - 1 : i - 1].side, p.side, topology);
    ManifoldPoint& point = result.points[static_cast<std::size_t>(result.count++)];
    point.position = plane.at(p.x, p.y) + p.gap * half_way;
    point.depth = 0 - p.gap;  // never −0
    point.on_a = b_is_reference ? features.on_incident : features.on_reference;
    point.on_b = b_is_reference ? features.on_reference : features.on_incident;
  }
}

}  // namespace

BoxManifold manifold_of_rigid_boxes(const BoxView& a, const BoxView& b) {
  BoxManifold result;
  if (!is_rigid_and_plain(a) || !is_rigid_and_plain(b)) return result;
  RigidBoxAxes axes;
  result.nearness = nearness_of_rigid_boxes(a, b, axes);
  if (result.nearness != Nearness::apart) find_points(result.manifold, a, b, axes);
  return result;
}

}  // namespace toccata
