#include "query/contacts/common_shadow.hpp"

#include <algorithm>
#include <utility>

#include "math/vec3_measures.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {
namespace {

/// A part of the triangle's size, more than what pieces are cut by: nearer to a contact it is rounding on which side of
/// it a corner lies, and the contact may have cut nothing off there.
constexpr double beside_contact = 0x1p-32;

bool is_beside_segment(const Vec3& p, const ContactSegment& segment, double distance) {
  const Vec3 way = segment.to - segment.from;
  const double squared = dot(way, way);
  const double share = squared > 0 ? std::clamp(dot(p - segment.from, way) / squared, 0.0, 1.0) : 0;
  const Vec3 apart = p - (segment.from + share * way);
  return dot(apart, apart) <= distance * distance;
}

std::array<bool, 3> telling_corners(const Triangle& own, const std::array<bool, 3>& touched,
                                    std::span<const ContactSegment> segments) {
  const double size = largest_magnitude(own[1] - own[0]) + largest_magnitude(own[2] - own[0]);
  std::array<bool, 3> telling{};
  for (int k = 0; k < 3; ++k) {
    const auto is_beside = [&](const ContactSegment& segment) {
      return is_beside_segment(own[k], segment, beside_contact * size);
    };
    const auto corner = static_cast<std::size_t>(k);
    telling[corner] = !touched[corner] && std::ranges::none_of(segments, is_beside);
  }
  return telling;
}

}  // namespace

std::vector<Vec3> TriangleCutter::points_of(Index contact, const Triangle& own) const {
  const Contact& c = contacts_[contact];
  const bool is_a = side_ == ContactSide::a;
  const Triangle other = other_.mesh().triangle(is_a ? c.element_b : c.element_a);
  const IntersectionPoints found = intersection_points(c.intersection, is_a ? own : other, is_a ? other : own);
  return {found.points.begin(), found.points.begin() + found.count};
}

std::optional<double> TriangleCutter::weight_of(const TrianglePart& part, const SurfaceWithin& within,
                                                const SurfaceWithin::TriangleInContact& one,
                                                const std::array<bool, 3>& telling) const {
  if (part.face != nullptr) {
    if (side_ == ContactSide::b) return {};
    return part.face->same_side ? 0.5 : 1;
  }
  for (const int corner : part.corners)
    if (corner >= 0 && telling[static_cast<std::size_t>(corner)]) {
      const Index vertex = one.corners[static_cast<std::size_t>(corner)];
      return within.piece_of(vertex) == SurfaceWithin::none ? std::nullopt : std::optional(0.5);
    }
  return is_interior(middle_of(part.points), other_.mesh()) ? std::optional(0.5) : std::nullopt;
}

void TriangleCutter::add_pieces(const SurfaceWithin& within, const SurfaceWithin::TriangleInContact& one,
                                std::vector<PlanePiece>& pieces) const {
  const Triangle own = graph_.mesh().triangle(one.triangle);
  const Vec3 normal = unit_or_zero(cross(own[1] - own[0], own[2] - own[0]));
  if (normal == Vec3{}) return;
  std::vector<ContactSegment> segments;
  std::vector<FaceOnTriangle> faces;
  for (const Index contact : one.contacts) {
    std::vector<Vec3> points = points_of(contact, own);
    const std::size_t count = points.size() > 2 ? points.size() : 1;
    for (std::size_t i = 0; i < count; ++i) segments.push_back({points[i], points[(i + 1) % points.size()], contact});
    if (points.size() < 3) continue;
    const Triangle other = other_.mesh().triangle(
        triangle_of(contacts_[contact], side_ == ContactSide::a ? ContactSide::b : ContactSide::a));
    const bool same = dot(normal, cross(other[1] - other[0], other[2] - other[0])) > 0;
    faces.push_back({std::move(points), same == same_turn_});
  }
  const std::array<bool, 3> telling = telling_corners(own, one.touched.vertices, segments);
  for (const TrianglePart& part : cut_triangle(own, std::move(segments), faces))
    if (const std::optional<double> weight = weight_of(part, within, one, telling))
      pieces.push_back({twice_area_of(part.points), *weight, part.contact});
}

}  // namespace toccata
