#include "narrow/convex/face_clipping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace toccata {
namespace {

/// What lies outside of a plane is taken off.
struct SidePlane {
  Vec3 point;
  Vec3 outwards;
  Index half_edge;
  [[nodiscard]] double height(const Vec3& p) const { return dot(outwards, p - point); }
};

ContactPolygon incident_polygon(const ContactFace& incident, std::pmr::memory_resource& memory) {
  ContactPolygon polygon(&memory);
  if (incident.face == ContactFace::none) {
    polygon.push_back({incident.shape->vertex(incident.vertex), {}});
    return polygon;
  }
  const HullTopology topology = incident.shape->topology();
  for (Index h = incident.first(); h < incident.last(); ++h)
    polygon.push_back({incident.shape->vertex(topology.origin[h]), {false, h}});
  return polygon;
}

Vec3 between(const Vec3& p, double height_p, const Vec3& q, double height_q) {
  return p + (height_p / (height_p - height_q)) * (q - p);
}

void clip(ContactPolygon& polygon, ContactPolygon& result, const SidePlane& plane) {
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PolygonCorner &corner = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double here = plane.height(corner.position), there = plane.height(next.position);
    // A corner in the plane, with the next outside, is left along the plane.
    if (here <= 0)
      result.push_back({corner.position, here == 0 && there > 0 ? PolygonSide{true, plane.half_edge} : corner.side});
    if (here < 0 && there > 0)
      result.push_back({between(corner.position, here, next.position, there), {true, plane.half_edge}});
    if (here > 0 && there < 0) result.push_back({between(corner.position, here, next.position, there), corner.side});
  }
  std::swap(polygon, result);
}

}  // namespace

ContactPolygon clipped_incident(const ContactFace& reference, const ContactFace& incident, const Vec3& direction,
                                std::pmr::memory_resource& memory) {
  ContactPolygon polygon = incident_polygon(incident, memory), other(&memory);
  const HullTopology topology = reference.shape->topology();
  if (reference.last() - reference.first() == 2) {
    const Index h = reference.first();
    const Vec3 from = reference.shape->vertex(topology.origin[h]), to = reference.shape->vertex(topology.target(h));
    clip(polygon, other, {to, to - from, h});
    clip(polygon, other, {from, from - to, topology.twin[h]});
    return polygon;
  }
  const double mirrored = turn_of_faces(reference.shape->pose().linear);
  for (Index h = reference.first(); h < reference.last() && !polygon.empty(); ++h) {
    const Vec3 from = reference.shape->vertex(topology.origin[h]);
    const Vec3 along = reference.shape->vertex(topology.target(h)) - from;
    clip(polygon, other, {from, mirrored * cross(along, direction), h});
  }
  return polygon;
}

std::optional<Vec3> deepest_of_incident(const ContactFace& reference, const ContactFace& incident,
                                        const Vec3& direction) {
  std::array<std::byte, 4096> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const ContactPolygon polygon = clipped_incident(reference, incident, direction, memory);
  if (polygon.empty()) return {};
  const Vec3 origin = polygon.front().position;
  double least = 0, size = 0;
  for (const PolygonCorner& corner : polygon) {
    least = std::min(least, dot(corner.position - origin, direction));
    size = std::max(size, std::fabs(dot(corner.position - origin, corner.position - origin)));
  }
  Vec3 sum;
  double count = 0;
  for (const PolygonCorner& corner : polygon) {
    if (dot(corner.position - origin, direction) > least + 0x1p-44 * std::sqrt(size)) continue;
    sum = sum + (corner.position - origin);
    ++count;
  }
  return origin + (1 / count) * sum;
}

}  // namespace toccata
