#include "narrow/triangles/coplanar_intersection.hpp"

#include <algorithm>

#include "narrow/triangles/incidence.hpp"
#include "narrow/triangles/intersection_from_points.hpp"
#include "narrow/triangles/triangle_features.hpp"

namespace toccata {
namespace {

/// side[i][k]: on which side of edge k of one triangle vertex i of the other lies; positive is inside.
using EdgeSides = std::array<std::array<Sign, 3>, 3>;

EdgeSides edge_sides(const Triangle& of, const Triangle& against, int axis) {
  const Sign turn = orient_without(axis, against[0], against[1], against[2]);
  EdgeSides side{};
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      side[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
          turn * orient_without(axis, edge_start(against, k), edge_end(against, k), of[i]);
  return side;
}

/// An edge has the whole other triangle strictly outside.
bool some_edge_separates(const EdgeSides& side) {
  for (std::size_t k = 0; k < 3; ++k)
    if (side[0][k] == Sign::negative && side[1][k] == Sign::negative && side[2][k] == Sign::negative) return true;
  return false;
}

bool is_outside(const std::array<Sign, 3>& side) {
  return std::find(side.begin(), side.end(), Sign::negative) != side.end();
}

/// The feature on which a point that is not outside lies.
Feature feature_at(const std::array<Sign, 3>& side) {
  unsigned set = 7U;
  for (unsigned k = 0; k < 3; ++k)
    if (side[k] == Sign::zero) set &= vertex_set(edge_feature(static_cast<int>(k)));
  return feature_of_vertices(set);
}

bool opposite(Sign s, Sign t) { return s * t == Sign::negative; }

/// The extreme points of the common polygon, found by what feature_intersection.cpp proves: vertices of one inside the
/// other, and proper crossings of edges. At most six: each edge of b carries at most two of them, and so does each of
/// a.
Intersection intersection_from_sides(const EdgeSides& a_in_b, const EdgeSides& b_in_a) {
  std::array<IntersectionPoint, 6> points{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (!is_outside(a_in_b[i])) points[count++] = {vertex_feature(static_cast<int>(i)), feature_at(a_in_b[i])};
  for (std::size_t j = 0; j < 3; ++j) {
    if (is_outside(b_in_a[j])) continue;
    const Feature on_a = feature_at(b_in_a[j]);
    if (on_a.kind != FeatureKind::vertex) points[count++] = {on_a, vertex_feature(static_cast<int>(j))};
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (opposite(a_in_b[i][j], a_in_b[(i + 1) % 3][j]) && opposite(b_in_a[j][i], b_in_a[(j + 1) % 3][i]))
        points[count++] = {edge_feature(static_cast<int>(i)), edge_feature(static_cast<int>(j))};
  return intersection_from_points(std::span(points).first(count), {true, face_feature(), face_feature()});
}

}  // namespace

Intersection coplanar_intersection(const Triangle& a, const Triangle& b) {
  const int axis = axis_that_shows(a[0], a[1], a[2]).value();
  const EdgeSides b_in_a = edge_sides(b, a, axis);
  if (some_edge_separates(b_in_a)) return intersection_from_points({}, {true, face_feature(), face_feature()});
  return intersection_from_sides(edge_sides(a, b, axis), b_in_a);
}

bool coplanar_overlap(const Triangle& a, const Triangle& b) {
  const int axis = axis_that_shows(a[0], a[1], a[2]).value();
  return !some_edge_separates(edge_sides(b, a, axis)) && !some_edge_separates(edge_sides(a, b, axis));
}

}  // namespace toccata
