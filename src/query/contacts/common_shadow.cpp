#include "query/contacts/common_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {
namespace {

/// Less than that share of a triangle's size is rounding.
constexpr double least_share_of_size = 0x1p-36;

Vec3 middle_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + (1.0 / static_cast<double>(points.size())) * p;
  return sum;
}

/// Of what lies over a convex polygon in its plane, seen against the normal.
bool is_within(const Vec3& p, std::span<const Vec3> outline, const Vec3& normal) {
  bool is_left = false, is_right = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3& from = outline[i];
    const double side = dot(normal, cross(outline[(i + 1) % outline.size()] - from, p - from));
    is_left = is_left || side > 0;
    is_right = is_right || side < 0;
  }
  return !is_left || !is_right;
}

/// More than a point of the segment lies in the convex polygon.
bool runs_through(const Vec3& from, const Vec3& to, std::span<const Vec3> polygon, const Vec3& normal) {
  double first = 0, last = 1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 inwards = cross(normal, polygon[(i + 1) % polygon.size()] - polygon[i]);
    const double at_from = dot(inwards, from - polygon[i]), at_to = dot(inwards, to - polygon[i]);
    const double slack = least_share_of_size * plain_length(inwards) * plain_length(to - from);
    if (at_from < -slack && at_to < -slack) return false;
    if (at_from < 0 && at_to > 0) first = std::max(first, at_from / (at_from - at_to));
    if (at_from > 0 && at_to < 0) last = std::min(last, at_from / (at_from - at_to));
  }
  return last - first > least_share_of_size;
}

}  // namespace

Vec3 twice_area(std::span<const Vec3> points) {
  Vec3 sum;
  for (std::size_t i = 2; i < points.size(); ++i) sum = sum + cross(points[i - 1] - points[0], points[i] - points[0]);
  return sum;
}

std::vector<Vec3> TriangleCutter::points_of(Index contact, const Triangle& own) const {
  const Contact& c = contacts_[contact];
  const bool is_a = side_ == ContactSide::a;
  const Triangle other = other_.mesh().triangle(is_a ? c.triangle_b : c.triangle_a);
  const IntersectionPoints found = intersection_points(c.intersection, is_a ? own : other, is_a ? other : own);
  return {found.points.begin(), found.points.begin() + found.count};
}

/// Those polygons through which the segment runs, along the whole plane through it.
void TriangleCutter::cut(std::vector<Polygon>& polygons, const Vec3& from, const Vec3& to, const Vec3& normal) {
  const Vec3 across = plain_unit_or_zero(cross(normal, to - from));
  if (across == Vec3{}) return;
  const std::size_t count = polygons.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Polygon whole = polygons[k];
    std::vector<double> height;
    for (const Vec3& p : whole.points) height.push_back(dot(across, p - from));
    const auto [low, high] = std::minmax_element(height.begin(), height.end());
    const double slack = least_share_of_size * (*high - *low);
    if (*low >= -slack || *high <= slack || !runs_through(from, to, whole.points, normal)) continue;
    Polygon below, above;
    const auto put = [](Polygon& polygon, const Vec3& p, int corner) {
      polygon.points.push_back(p);
      polygon.corners.push_back(corner);
    };
    for (std::size_t i = 0; i < whole.points.size(); ++i) {
      const std::size_t j = (i + 1) % whole.points.size();
      if (height[i] <= 0) put(below, whole.points[i], whole.corners[i]);
      if (height[i] >= 0) put(above, whole.points[i], whole.corners[i]);
      if (height[i] * height[j] >= 0) continue;
      const double share = height[i] / (height[i] - height[j]);
      const Vec3 at = whole.points[i] + share * (whole.points[j] - whole.points[i]);
      put(below, at, -1);
      put(above, at, -1);
    }
    polygons[k] = std::move(below);
    polygons.push_back(std::move(above));
  }
}

std::optional<double> TriangleCutter::weight_of(const Polygon& polygon, const Vec3& normal, const SurfaceWithin& within,
                                                const SurfaceWithin::TriangleInContact& one,
                                                std::span<const Outline> faces) const {
  const Vec3 middle = middle_of(polygon.points);
  for (const Outline& face : faces) {
    if (!is_within(middle, face.points, normal)) continue;
    if (side_ == ContactSide::b) return {};
    return face.same_side ? 0.5 : 1;
  }
  for (const int corner : polygon.corners)
    if (corner >= 0 && !one.touched.vertices[static_cast<std::size_t>(corner)]) {
      const Index vertex = one.corners[static_cast<std::size_t>(corner)];
      return within.piece_of(vertex) == SurfaceWithin::none ? std::nullopt : std::optional(0.5);
    }
  return is_interior(middle, other_.mesh()) ? std::optional(0.5) : std::nullopt;
}

void TriangleCutter::add_pieces(const SurfaceWithin& within, const SurfaceWithin::TriangleInContact& one,
                                std::vector<PlanePiece>& pieces) const {
  const Triangle own = graph_.mesh().triangle(one.triangle);
  const Vec3 twice = cross(own[1] - own[0], own[2] - own[0]), normal = unit_or_zero(twice);
  if (normal == Vec3{}) return;
  std::vector<Polygon> polygons{{{own[0], own[1], own[2]}, {0, 1, 2}}};
  std::vector<Outline> faces;
  std::vector<std::pair<Vec3, Index>> middles;
  for (const Index contact : one.contacts) {
    const std::vector<Vec3> points = points_of(contact, own);
    middles.emplace_back(middle_of(points), contact);
    for (std::size_t i = 0; points.size() > 1 && i < (points.size() == 2 ? 1 : points.size()); ++i)
      cut(polygons, points[i], points[(i + 1) % points.size()], normal);
    if (points.size() < 3) continue;
    const Triangle other = other_.mesh().triangle(
        triangle_of(contacts_[contact], side_ == ContactSide::a ? ContactSide::b : ContactSide::a));
    const bool same = dot(normal, cross(other[1] - other[0], other[2] - other[0])) > 0;
    faces.push_back({points, same == same_turn_});
  }
  const double least = least_share_of_size * largest_magnitude(twice);
  for (const Polygon& polygon : polygons) {
    const Vec3 area = twice_area(polygon.points);
    if (!(largest_magnitude(area) > least)) continue;
    const std::optional<double> weight = weight_of(polygon, normal, within, one, faces);
    if (!weight) continue;
    const Vec3 middle = middle_of(polygon.points);
    const auto nearest = std::min_element(middles.begin(), middles.end(), [&](const auto& p, const auto& q) {
      return dot(p.first - middle, p.first - middle) < dot(q.first - middle, q.first - middle);
    });
    pieces.push_back({area, *weight, nearest->second});
  }
}

}  // namespace toccata
