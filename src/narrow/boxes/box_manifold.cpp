#include "narrow/boxes/box_manifold.hpp"

#include <array>
#include <utility>

#include "narrow/boxes/box_features.hpp"
#include "narrow/convex/contact_choices.hpp"

namespace toccata {
namespace {

/// What a face consists of: itself, its corners, and its sides, in the order of a BoxFace.
struct FaceFeatures {
  static constexpr std::size_t corner = 1, side = 5;
  std::array<ConvexFeature, 9> feature;
};

constexpr FaceFeatures features_of(Index face) {
  const Index z = face / 2, x = (z + 1) % 3, y = (z + 2) % 3, base = face % 2 << z;
  const std::array<Index, 4> corners = {base, base | 1U << x, base | 1U << x | 1U << y, base | 1U << y};
  FaceFeatures features{};
  features.feature[0] = {ConvexFeature::Kind::face, face};
  for (std::size_t k = 0; k < 4; ++k) {
    features.feature[FaceFeatures::corner + k] = {ConvexFeature::Kind::vertex, corners[k]};
    features.feature[FaceFeatures::side + k] = {ConvexFeature::Kind::edge,
                                                edge_between(corners[k], corners[(k + 1) % 4])};
  }
  return features;
}

constexpr std::array<FaceFeatures, 6> features_of_faces = {features_of(0), features_of(1), features_of(2),
                                                           features_of(3), features_of(4), features_of(5)};

/// The features of one place of an overlay.
using PlaceFeatures = std::array<ConvexFeature, 2>;  // on the reference face and on the incident one

// Without branches: nothing is harder to guess than which kind of corner comes next.
PlaceFeatures features_of(const BoxContact& contact, Index place) {
  constexpr std::array<Index, 4> on_reference = {0, FaceFeatures::side, FaceFeatures::side, FaceFeatures::corner};
  constexpr std::array<Index, 4> on_incident = {FaceFeatures::corner, FaceFeatures::side, FaceFeatures::side, 0};
  constexpr std::array<Index, 4> is_numbered_by_itself = {0, 0, 0, ~0U}, is_crossing = {0, ~0U, ~0U, 0};
  constexpr std::array<Index, 4> has_incident_number = {~0U, ~0U, ~0U, 0};
  const Index number = place & 3U, kind = place / 4;
  const Index reference =
      (number & is_numbered_by_itself[kind]) | (contact.overlay.crossed_side(place) & is_crossing[kind]);
  return {features_of_faces[contact.faces.reference.number()].feature[on_reference[kind] + reference],
          features_of_faces[contact.faces.incident.number()]
              .feature[on_incident[kind] + (number & has_incident_number[kind])]};
}

using EdgesOfCorner = std::array<Index, 3>;

/// [corner][axis]
constexpr std::array<EdgesOfCorner, 8> edges_of_corners = [] {
  std::array<EdgesOfCorner, 8> edges{};
  for (Index corner = 0; corner < 8; ++corner)
    for (Index axis = 0; axis < 3; ++axis) edges[corner][axis] = edge_between(corner, corner ^ 1U << axis);
  return edges;
}();

/// The edge that lies farthest along a direction, of those along an axis.
ConvexFeature farthest_edge(const BoxView& box, std::size_t axis, const Vec3& direction) {
  return {ConvexFeature::Kind::edge, edges_of_corners[farthest_corner(box, direction)][axis]};
}

}  // namespace

RigidBoxContact::RigidBoxContact(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes)
    : a_(a),
      b_(b),
      axis_(least_axis(a, b, axes, edge_share)),
      contact_(contact_of_faces(a, b, axes, axis_)),
      chosen_(chosen_places(contact_.overlay)) {}

ManifoldPoint RigidBoxContact::point_of_edges() const {
  const EdgePoints at = points_of_edges(a_, b_, axis_);
  return {at.on_a + 0.5 * (at.on_b - at.on_a), axis_.depth, farthest_edge(a_, axis_.edge_a, axis_.direction),
          farthest_edge(b_, axis_.edge_b, -axis_.direction)};
}

ManifoldPoint RigidBoxContact::point_of_faces(std::size_t k, const BoxFacePlane& plane, const Vec3& half_way,
                                              bool exchanged) const {
  if (k >= chosen_.count) return {};
  const BoxOverlay& overlay = contact_.overlay;
  const Index i = chosen_.place[k];
  const PlaceFeatures features = features_of(contact_, i);
  const std::size_t first = contact_.faces.b_is_reference != exchanged ? 1 : 0;  // is the incident face, or not
  const double depth = 0 - overlay.gap[i];                                       // never −0
  return {plane.at(overlay.x[i], overlay.y[i]) + overlay.gap[i] * half_way, depth, features[first],
          features[1 - first]};
}

Manifold RigidBoxContact::manifold(bool exchanged) const {
  const Vec3 normal = (exchanged ? -1.0 : 1.0) * axis_.direction;
  if (!is_of_faces()) {
    Manifold result{normal, {point_of_edges()}, 1};
    if (exchanged) std::swap(result.points[0].on_a, result.points[0].on_b);
    return result;
  }
  const bool b_is_reference = contact_.faces.b_is_reference;
  const BoxFacePlane plane(b_is_reference ? b_ : a_, contact_.faces.reference);
  const Vec3 half_way = (b_is_reference ? -0.5 : 0.5) * axis_.direction;
  const auto point = [&](std::size_t k) { return point_of_faces(k, plane, half_way, exchanged); };
  return {normal, {point(0), point(1), point(2), point(3)}, static_cast<int>(chosen_.count)};
}

}  // namespace toccata
