#pragma once

#include "narrow/boxes/box_contact.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// Two boxes in contact, before it is written down.
class RigidBoxContact {
 public:
  /// In the order that is computed, both rigid and plain, and not certainly apart. The views have to outlive it.
  RigidBoxContact(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes);

  /// If not, somebody else has to find some.
  [[nodiscard]] bool has_points() const { return is_of_faces() || is_of_edges(axis_); }

  /// The manifold of the boxes, or of the second and the first. Precondition: they meet, and it has points.
  [[nodiscard]] Manifold manifold(bool exchanged) const;

 private:
  [[nodiscard]] bool is_of_faces() const { return chosen_.count > 0; }
  /// The k-th of four; without content where there are fewer.
  [[nodiscard]] ManifoldPoint point_of_faces(std::size_t k, const BoxFacePlane& plane, const Vec3& half_way,
                                             bool exchanged) const;
  [[nodiscard]] ManifoldPoint point_of_edges() const;

  BoxView a_, b_;
  ChosenBoxAxis axis_;
  BoxContact contact_;
  ChosenPlaces chosen_;
};

}  // namespace toccata
