#include "query/penetration/convex_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "query/meshes/world_search.hpp"

namespace toccata {
namespace {

/// The side normal · x <= offset, x from the point around which it grows; the offset is positive.
struct GrowthCut {
  Vec3 normal;
  double offset;
};

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = dot(along, along);
  return length > 0 ? a + std::clamp(-dot(a, along) / length, 0.0, 1.0) * along : a;
}

/// The point of a triangle that is nearest to the origin, rounded.
Vec3 nearest_to_origin(const std::array<Vec3, 3>& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const bool inside =
      dot(cross(t[0], t[1]), normal) >= 0 && dot(cross(t[1], t[2]), normal) >= 0 && dot(cross(t[2], t[0]), normal) >= 0;
  if (const double squared = dot(normal, normal); inside && squared > 0) return (dot(t[0], normal) / squared) * normal;
  Vec3 best = nearest_on_segment(t[0], t[1]);
  for (const Vec3& other : {nearest_on_segment(t[1], t[2]), nearest_on_segment(t[2], t[0])})
    if (dot(other, other) < dot(best, best)) best = other;
  return best;
}

/// The first cuts are as far out as can be; later ones nearer in, so that each cuts off more.
constexpr std::size_t most_full_cuts = 192, most_near_full_cuts = 288, most_cuts = 400;

[[nodiscard]] double share_left(std::size_t cuts_before) {
  return cuts_before < most_full_cuts ? 1 : cuts_before < most_near_full_cuts ? 0.95 : 0.5;
}

/// The plane of the triangle, where it leaves a good part of the way to it.
std::optional<GrowthCut> own_plane(const Obstacle& obstacle) {
  constexpr double least_share = 0.01;
  const auto& t = obstacle.corner;
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double length = std::sqrt(dot(normal, normal)), height = dot(normal, t[0]);
  if (!(length > 0) || !(std::abs(height) > least_share * length * std::sqrt(obstacle.squared))) return std::nullopt;
  const double sign = height < 0 ? -1 : 1;
  return GrowthCut{(sign / length) * normal, std::abs(height) / length};
}

GrowthCut cut_before(const Obstacle& obstacle, double share, CutBy by) {
  if (by == CutBy::own_plane && share == 1)
    if (const std::optional<GrowthCut> own = own_plane(obstacle)) return *own;
  const double distance = std::sqrt(obstacle.squared);
  return {(1 / distance) * obstacle.nearest, share * distance};
}

bool is_cut_off(const Obstacle& obstacle, const GrowthCut& cut) {
  constexpr double rounding = 0x1p-40;
  return std::all_of(obstacle.corner.begin(), obstacle.corner.end(),
                     [&](const Vec3& corner) { return dot(cut.normal, corner) >= cut.offset * (1 - rounding); });
}

std::vector<GrowthCut> cube_cuts(double reach) {
  return {{{1, 0, 0}, reach},  {{-1, 0, 0}, reach}, {{0, 1, 0}, reach},
          {{0, -1, 0}, reach}, {{0, 0, 1}, reach},  {{0, 0, -1}, reach}};
}

/// None where they would be too many, or too near.
std::vector<GrowthCut> cuts_around(std::vector<Obstacle> obstacles, double reach, CutBy by) {
  std::vector<GrowthCut> cuts = cube_cuts(reach);
  while (!obstacles.empty()) {
    const Obstacle nearest = obstacles.front();
    if (cuts.size() >= most_cuts || !(nearest.squared > 0x1p-100 * reach * reach)) return {};
    const GrowthCut cut = cut_before(nearest, share_left(cuts.size()), by);
    cuts.push_back(cut);
    // The nearest goes in any case; what is left moves up once.
    std::erase_if(obstacles, [&](const Obstacle& obstacle) {
      return &obstacle == &obstacles.front() || is_cut_off(obstacle, cut);
    });
  }
  return cuts;
}

bool is_left(const Vec3& corner, const std::vector<GrowthCut>& cuts) {
  constexpr double rounding = 0x1p-20;
  return is_finite(corner) && std::all_of(cuts.begin(), cuts.end(), [&](const GrowthCut& cut) {
           return dot(cut.normal, corner) <= cut.offset * (1 + rounding);
         });
}

/// Where the planes meet: a face of the hull of normal / offset is a corner of what they enclose. A corner that
/// rounding has thrown out is left out.
std::vector<Vec3> corners_within(const std::vector<GrowthCut>& cuts) {
  std::vector<Vec3> polar, corners;
  for (const GrowthCut& cut : cuts) polar.push_back((1 / cut.offset) * cut.normal);
  const ConvexHull hull{polar};
  if (hull.dimension() < 3) return {};
  const HullTopology topology = hull.topology();
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Index first = topology.face_start[face];
    const Vec3 a = hull.vertex(topology.origin[first]), b = hull.vertex(topology.origin[first + 1]),
               c = hull.vertex(topology.origin[topology.face_start[face + 1] - 1]);
    const Vec3 normal = cross(b - a, c - a);
    const Vec3 corner = (1 / dot(normal, a)) * normal;
    if (is_left(corner, cuts)) corners.push_back(corner);
  }
  return corners;
}

}  // namespace

Surroundings surroundings_of(const PosedMesh& mesh, const Vec3& point, double reach) {
  const Vec3 half{reach, reach, reach};
  Surroundings around{point, reach, {}};
  visit_triangles_near(mesh, {point - half, point + half}, [&](Index i) {
    const Triangle t = mesh.triangle(i);
    Obstacle obstacle{{t[0] - point, t[1] - point, t[2] - point}, {}, 0};
    obstacle.nearest = nearest_to_origin(obstacle.corner);
    obstacle.squared = dot(obstacle.nearest, obstacle.nearest);
    around.obstacles.push_back(obstacle);
    return true;
  });
  std::stable_sort(around.obstacles.begin(), around.obstacles.end(),
                   [](const Obstacle& s, const Obstacle& t) { return s.squared < t.squared; });
  return around;
}

std::optional<ConvexHull> grow_convex(const Surroundings& around, CutBy cut) {
  const std::vector<GrowthCut> cuts = cuts_around(around.obstacles, around.reach, cut);
  if (cuts.empty()) return std::nullopt;
  std::vector<Vec3> corners = corners_within(cuts);
  if (corners.size() < 4) return std::nullopt;
  for (Vec3& corner : corners) corner = corner + around.point;
  ConvexHull hull{corners};
  return hull.dimension() == 3 ? std::optional(std::move(hull)) : std::nullopt;
}

}  // namespace toccata
