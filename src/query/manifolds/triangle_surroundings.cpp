#include "query/manifolds/triangle_surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/triangles/contact_faces.hpp"
#include "query/contacts/region_depth.hpp"

namespace toccata {
namespace {

/// What rises less, as a slope, is level.
constexpr double level_slope = 0x1p-20;

/// How steeply a point lies above another, along a unit direction: the sine.
double slope_to(const Vec3& from, const Vec3& to, const Vec3& direction) {
  return dot(unit_or_zero(to - from), direction);
}

}  // namespace

TriangleSurroundings::TriangleSurroundings(const PosedTriangles& surface, Index triangle)
    : surface_(surface),
      fans_(&surface.mesh.model().vertex_fans()),
      number_(triangle),
      mirrored_(surface.solid ? turn_of_faces(surface.mesh.pose().linear) : 1),
      corners_(surface.mesh.triangle(triangle)),
      normal_(normal_of(triangle)) {}

Vec3 TriangleSurroundings::normal_of(Index triangle) const {
  return mirrored_ * fans().turn(triangle) * normal_of_any_size(other(triangle));
}

template <class See>
void TriangleSurroundings::visit_beyond(std::size_t edge, const See& see) const {
  const auto& own = fans().corners(number_);
  const Index from = own[edge], to = own[(edge + 1) % 3];
  for (const Index triangle : fans().triangles_at(from)) {
    if (triangle == number_) continue;
    const auto& corners = fans().corners(triangle);
    if (std::ranges::find(corners, to) == corners.end()) continue;
    for (std::size_t k = 0; k < 3; ++k)
      if (corners[k] != from && corners[k] != to) see(triangle, other(triangle)[static_cast<int>(k)]);
  }
}

bool TriangleSurroundings::is_highest_edge(std::size_t edge, const Vec3& direction) const {
  const Vec3& at = corners_[static_cast<int>(edge)];
  bool is_highest = true;
  // Where both faces fall away from an edge of a solid, they do so outwards if the direction is along the sum of their
  // normals.
  double outwards = dot(normal_, direction);
  visit_beyond(edge, [&](Index triangle, const Vec3& corner) {
    is_highest = is_highest && slope_to(at, corner, direction) <= level_slope;
    if (surface_.solid) outwards += dot(normal_of(triangle), direction);
  });
  return is_highest && (!surface_.solid || outwards > 0);
}

bool TriangleSurroundings::is_highest_vertex(std::size_t corner, const Vec3& direction) const {
  const Index vertex = fans().corners(number_)[corner];
  const Vec3& at = corners_[static_cast<int>(corner)];
  // The vector area of the fan, as far as a plane across the direction cuts it off, leads outwards.
  Vec3 area;
  for (const Index triangle : fans().triangles_at(vertex)) {
    const auto& corners = fans().corners(triangle);
    const auto k = static_cast<int>(std::ranges::find(corners, vertex) - corners.begin());
    const Triangle posed = other(triangle);
    const Vec3 first = unit_or_zero(posed[(k + 1) % 3] - at), second = unit_or_zero(posed[(k + 2) % 3] - at);
    const double fall_first = -dot(first, direction), fall_second = -dot(second, direction);
    if (fall_first < -level_slope || fall_second < -level_slope) return false;
    area = area + mirrored_ * fans().turn(triangle) / std::max(fall_first, level_slope) /
                      std::max(fall_second, level_slope) * cross(first, second);
  }
  return !surface_.solid || dot(area, direction) > 0;
}

bool TriangleSurroundings::allows(const Vec3& direction) const {
  std::array<double, 3> height;
  for (std::size_t k = 0; k < 3; ++k) height[k] = dot(corners_[static_cast<int>(k)] - corners_[0], direction);
  const auto top = static_cast<std::size_t>(std::ranges::max_element(height) - height.begin());
  std::array<bool, 3> is_level{};
  for (std::size_t k = 0; k < 3; ++k)
    is_level[k] =
        k == top || slope_to(corners_[static_cast<int>(top)], corners_[static_cast<int>(k)], direction) >= -level_slope;
  if (is_level[0] && is_level[1] && is_level[2]) return !surface_.solid || dot(normal_, direction) > 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (is_level[k] && is_level[(k + 1) % 3]) return is_highest_edge(k, direction);
  return is_highest_vertex(top, direction);
}

void TriangleSurroundings::visit_normals_of_side(const Vec3& normal, FunctionRef<void(const Vec3&)> see) const {
  if (normal == Vec3{}) return;
  see(normal);
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Vec3& at = corners_[static_cast<int>(edge)];
    const Vec3& opposite = corners_[static_cast<int>((edge + 2) % 3)];
    visit_beyond(edge, [&](Index triangle, const Vec3& corner) {
      if (slope_to(at, corner, normal) >= -level_slope) return;
      const Vec3 beyond = normal_of_any_size(other(triangle));
      if (beyond != Vec3{}) see(dot(beyond, opposite - at) > 0 ? -beyond : beyond);
    });
  }
}

void TriangleSurroundings::visit_normals(FunctionRef<void(const Vec3&)> see) const {
  visit_normals_of_side(normal_, see);
  if (!surface_.solid) visit_normals_of_side(-normal_, see);
}

bool TriangleSurroundings::is_ridge(std::size_t edge) const {
  const Vec3& at = corners_[static_cast<int>(edge)];
  bool is_end = true, folds = false;
  visit_beyond(edge, [&](Index, const Vec3& corner) {
    is_end = false;
    const double slope = slope_to(at, corner, normal_);
    folds = folds || slope < -level_slope || (!surface_.solid && slope > level_slope);
  });
  return is_end || folds;
}

bool TriangleSurroundings::is_peak(std::size_t corner) const {
  const Index vertex = fans().corners(number_)[corner];
  const Vec3& at = corners_[static_cast<int>(corner)];
  for (const Index triangle : fans().triangles_at(vertex)) {
    const Triangle posed = other(triangle);
    for (int k = 0; k < 3; ++k) {
      const double slope = slope_to(at, posed[k], normal_);
      if (slope < -level_slope || (!surface_.solid && slope > level_slope)) return true;
    }
  }
  return false;
}

bool TriangleSurroundings::is_flat() const {
  for (std::size_t i = 0; i < 3; ++i)
    if (is_peak(i) || is_ridge(i)) return false;
  return true;
}

void TriangleSurroundings::visit_ridges(FunctionRef<void(const PosedPart&)> see) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from = corners_[static_cast<int>(i)], &to = corners_[static_cast<int>((i + 1) % 3)];
    if (is_ridge(i)) see({PosedShape(std::in_place_type<PosedPolytope>, Segment{from, to}), ShapeKind::segment});
    if (is_peak(i)) see({PosedShape(std::in_place_type<PosedPolytope>, Point{from}), ShapeKind::point});
  }
}

}  // namespace toccata
