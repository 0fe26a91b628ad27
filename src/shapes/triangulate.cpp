#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "shapes/ear_clipping.hpp"
#include "shapes/triangulated.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {
namespace {

/// The coordinate plane in which a face is largest, and which way it turns there.
struct Projection {
  int dropped_axis = 2;
  bool clockwise = false;
};

void check_structure(const PolygonMesh& polygons) {
  const auto& first = polygons.first;
  if (first.empty() || first.front() != 0 || first.back() != polygons.corners.size())
    throw Error("the list of first corners must start with 0 and end with the number of corners");
  for (std::size_t f = 0; f + 1 < first.size(); ++f) {
    if (first[f + 1] < first[f] || first[f + 1] - first[f] < 3)
      throw Error("face " + std::to_string(f) + " has fewer than three corners");
    if (first[f + 1] - first[f] > most_face_corners)
      throw Error("face " + std::to_string(f) + " has " + std::to_string(first[f + 1] - first[f]) +
                  " corners, and at most " + std::to_string(most_face_corners) +
                  " are taken: cut it into smaller ones");
    for (Index c = first[f]; c < first[f + 1]; ++c)
      if (polygons.corners[c] >= polygons.vertices.size())
        throw Error("face " + std::to_string(f) + " names vertex " + std::to_string(polygons.corners[c]) +
                    ", but there are " + std::to_string(polygons.vertices.size()) + " vertices, counted from 0");
  }
}

void check_finite(const PolygonMesh& polygons) {
  for (std::size_t i = 0; i < polygons.vertices.size(); ++i)
    if (!is_finite(polygons.vertices[i]))
      throw Error("vertex " + std::to_string(i) + " has a coordinate that is not finite");
}

double largest_coordinate(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

/// Brings the points to a size near 1 by a power of two, so that products neither overflow nor vanish.
void normalise(std::vector<Vec3>& points) {
  const double largest = largest_coordinate(points);
  if (largest == 0) return;
  const int exponent = -std::ilogb(largest) - 1;
  for (Vec3& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

/// Twice the area vector (M. E. Newell's sum), of the polygon scaled to a size near 1: only its direction is used.
Vec3 area_vector(std::vector<Vec3> corners) {
  normalise(corners);
  const Vec3 origin = corners.front();
  for (Vec3& p : corners) p = p - origin;
  normalise(corners);
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum = sum + cross(corners[i], corners[i + 1]);
  return sum;
}

Projection largest_projection(const std::vector<Vec3>& corners) {
  const Vec3 area = area_vector(corners);
  int axis = 2;
  for (const int other : {1, 0})
    if (std::abs(area[other]) > std::abs(area[axis])) axis = other;
  return {axis, area[axis] < 0};
}

std::vector<CornerTriangle> fan(Index count) {
  std::vector<CornerTriangle> triangles;
  for (Index i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

std::vector<CornerTriangle> cut(const std::vector<Vec3>& corners) {
  const Projection projection = largest_projection(corners);
  std::vector<Vec2> flat;
  flat.reserve(corners.size());
  for (const Vec3& p : corners) flat.push_back(drop_axis(p, projection.dropped_axis));
  // Exchanging the coordinates mirrors the polygon, so the corners keep their order and the triangles their turn.
  if (projection.clockwise)
    for (Vec2& p : flat) p = {p.y, p.x};
  std::vector<CornerTriangle> triangles = clip_ears(flat);
  return triangles.empty() ? fan(static_cast<Index>(corners.size())) : triangles;
}

}  // namespace

namespace {

struct FaceTriangles {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> face_of_triangle;
};

FaceTriangles triangles_of(const PolygonMesh& polygons) {
  check_finite(polygons);
  check_structure(polygons);
  const std::size_t face_count = polygons.first.size() - 1;
  const std::size_t triangle_count = polygons.corners.size() - 2 * face_count;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> face_of_triangle;
  triangles.reserve(triangle_count);
  if (triangle_count != face_count) face_of_triangle.reserve(triangle_count);
  std::vector<Vec3> corners;
  for (std::size_t f = 0; f < face_count; ++f) {
    const std::span<const Index> face =
        std::span(polygons.corners).subspan(polygons.first[f], polygons.first[f + 1] - polygons.first[f]);
    if (face.size() == 3) {
      triangles.push_back({face[0], face[1], face[2]});
    } else {
      corners.clear();
      for (const Index v : face) corners.push_back(polygons.vertices[v]);
      for (const CornerTriangle& t : cut(corners)) triangles.push_back({face[t[0]], face[t[1]], face[t[2]]});
    }
    if (triangle_count != face_count) face_of_triangle.resize(triangles.size(), static_cast<Index>(f));
  }
  return {std::move(triangles), std::move(face_of_triangle)};
}

}  // namespace

TriangleMesh triangulate(const PolygonMesh& polygons) {
  auto [triangles, faces] = triangles_of(polygons);
  return {polygons.vertices, std::move(triangles), std::move(faces)};
}

TriangleMesh triangulated(PolygonMesh polygons) {
  auto [triangles, faces] = triangles_of(polygons);
  return {std::move(polygons.vertices), std::move(triangles), std::move(faces)};
}

}  // namespace toccata
