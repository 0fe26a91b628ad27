#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "narrow/triangles/contact_faces.hpp"

namespace toccata {

/// A line that bounds a polygon: an edge of the incident face, or the side of the reference face that cut it.
struct PolygonSide {
  bool of_reference = false;
  Index half_edge = 0;
};

/// A corner of a polygon and the side that leaves it.
struct PolygonCorner {
  Vec3 position;
  PolygonSide side;
};

using ContactPolygon = std::pmr::vector<PolygonCorner>;

/// The incident face, a segment or a point too, as far as it lies between the side planes of the reference face, which
/// go along `direction`; of a reference segment, between the planes across its ends (I. E. Sutherland, G. W. Hodgman,
/// "Reentrant polygon clipping", 1974).
[[nodiscard]] ContactPolygon clipped_incident(const ContactFace& reference, const ContactFace& incident,
                                              const Vec3& direction, std::pmr::memory_resource& memory);

/// A point of the incident face that lies over the reference face as deep as any: the middle of those, but for
/// rounding. Nothing when they do not lie over each other.
[[nodiscard]] std::optional<Vec3> deepest_of_incident(const ContactFace& reference, const ContactFace& incident,
                                                      const Vec3& direction);

}  // namespace toccata
