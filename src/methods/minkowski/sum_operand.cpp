#include "methods/minkowski/sum_operand.hpp"

#include <algorithm>

#include "math/vec3_measures.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {
namespace {

/// Vertices in the world are those of the hull itself, so that its faces are exact.
bool is_in_place(const PosedPolytope& shape) { return !shape.in_world() && shape.pose() == Pose{}; }

int dimension_of(const HullTopology& topology, Index vertices) {
  if (vertices < 3) return static_cast<int>(vertices) - 1;
  return topology.face_count() == 2 ? 2 : 3;
}

}  // namespace

SumOperand::SumOperand(const PosedPolytope& shape, bool negated) {
  const Index count = shape.vertex_count();
  points_.reserve(count);
  for (Index i = 0; i < count; ++i) points_.push_back(negated ? -shape.vertex(i) : shape.vertex(i));
  if (is_in_place(shape)) {
    source_.resize(count);
    for (Index i = 0; i < count; ++i) source_[i] = i;
    take_hull(shape.topology(), negated);
  } else {
    const ConvexHull hull(points_);
    for (Index i = 0; i < hull.vertex_count(); ++i) source_.push_back(hull.source_of(i));
    for (Index i = 0; i < hull.vertex_count(); ++i) points_[i] = hull.vertex(i);
    points_.resize(hull.vertex_count());
    take_hull(hull.topology(), false);
  }
  measure();
}

// A reflection at the origin turns every face round.
void SumOperand::take_hull(const HullTopology& topology, bool reversed) {
  const Index count = static_cast<Index>(topology.origin.size());
  dimension_ = dimension_of(topology, static_cast<Index>(points_.size()));
  const auto place = [&](Index h) {
    const Index f = topology.face[h];
    return reversed ? topology.face_start[f] + topology.face_start[f + 1] - 1 - h : h;
  };
  half_edges_.resize(count);
  for (Index h = 0; h < count; ++h) {
    const Index f = topology.face[h], at = place(h);
    const Index first = topology.face_start[f], last = topology.face_start[f + 1] - 1;
    const Index from = topology.origin[h], to = topology.target(h);
    half_edges_[at] = {.along = {},
                       .origin = reversed ? to : from,
                       .target = reversed ? from : to,
                       .next = at == last ? first : at + 1,
                       .previous = at == first ? last : at - 1,
                       .twin = place(topology.twin[h]),
                       .face = dimension_ < 2 ? no_index : f};
  }
  list_leaving();
  if (dimension_ < 2) return;
  faces_.resize(topology.face_count());
  for (Index f = 0; f < topology.face_count(); ++f) {
    faces_[f].first = topology.face_start[f];
    faces_[f].size = topology.face_start[f + 1] - topology.face_start[f];
  }
}

void SumOperand::list_leaving() {
  first_leaving_.assign(points_.size() + 1, 0);
  for (const HalfEdge& h : half_edges_) ++first_leaving_[h.origin];
  Index total = 0;
  for (Index& first : first_leaving_) total = first += total;
  leaving_.resize(half_edges_.size());
  for (Index h = static_cast<Index>(half_edges_.size()); h-- > 0;)
    leaving_[--first_leaving_[half_edges_[h].origin]] = h;
}

void SumOperand::measure() {
  for (HalfEdge& h : half_edges_) {
    h.along = points_[h.target] - points_[h.origin];
    reach_ = std::max(reach_, largest_magnitude(h.along));
  }
  for (Face& face : faces_) {
    // Far apart, for a normal with little error.
    face.corners = {half_edges_[face.first].origin, half_edges_[face.first + face.size / 3].origin,
                    half_edges_[face.first + 2 * face.size / 3].origin};
    const Vec3& p = points_[face.corners[0]];
    const FilteredCross n = filtered_cross(points_[face.corners[1]] - p, points_[face.corners[2]] - p);
    face.normal = n.value;
    face.magnitude = sum_of_magnitudes(n.magnitude);
  }
}

Sign SumOperand::exact_slope(Index face, const SumOperand& other, Index half_edge) const {
  const auto [u, v] = plane_of(face);
  return triple_product_sign(u, v, other.along(half_edge));
}

}  // namespace toccata
