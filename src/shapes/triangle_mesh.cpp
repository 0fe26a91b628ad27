#include "toccata/shapes/triangle_mesh.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void check_vertices(std::span<const Vec3> vertices) {
  if (vertices.size() > std::numeric_limits<Index>::max()) throw Error("a mesh has at most 4294967295 vertices");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!is_finite(vertices[i])) throw Error("vertex " + std::to_string(i) + " has a coordinate that is not finite");
}

void check_triangles(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count) {
  if (triangles.empty()) throw Error("a mesh needs at least one triangle");
  if (triangles.size() > std::numeric_limits<Index>::max()) throw Error("a mesh has at most 4294967295 triangles");
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const Index corner : triangles[t])
      if (corner >= vertex_count)
        throw Error("triangle " + std::to_string(t) + " names vertex " + std::to_string(corner) + ", but there are " +
                    std::to_string(vertex_count) + " vertices, counted from 0");
}

void check_faces(std::span<const Index> face_of_triangle, std::size_t triangle_count) {
  if (face_of_triangle.empty()) return;
  if (face_of_triangle.size() != triangle_count)
    throw Error("a mesh of " + std::to_string(triangle_count) + " triangles was given " +
                std::to_string(face_of_triangle.size()) + " face numbers; give one for each triangle, or none");
  for (std::size_t t = 1; t < triangle_count; ++t)
    if (face_of_triangle[t] < face_of_triangle[t - 1])
      throw Error("triangle " + std::to_string(t) + " has a lower face number than the triangle before it; order the " +
                  "triangles by face");
}

/// Copies by memcpy, as a stride need not keep numbers aligned.
template <class Number>
std::vector<Vec3> copied(const Number* first, const PositionBuffer& positions, double scale) {
  if (positions.stride < 3 * sizeof(Number))
    throw Error("positions have a stride of " + std::to_string(positions.stride) + " bytes, and three numbers take " +
                std::to_string(3 * sizeof(Number)));
  std::vector<Vec3> vertices(positions.count);
  const auto* bytes = reinterpret_cast<const std::byte*>(first);
  for (std::size_t i = 0; i < positions.count; ++i) {
    std::array<Number, 3> p;
    std::memcpy(p.data(), bytes + i * positions.stride, sizeof p);
    vertices[i] = {scale * p[0], scale * p[1], scale * p[2]};
  }
  return vertices;
}

template <class Number>
std::vector<std::array<Index, 3>> corners_by_triangle(const Number* first, std::size_t count) {
  if (count % 3 != 0)
    throw Error("triangle " + std::to_string(count / 3) + " has " + std::to_string(count % 3) + " corners: there are " +
                std::to_string(count) + " indices; give three a triangle");
  std::vector<std::array<Index, 3>> triangles(count / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) triangles[t] = {first[3 * t], first[3 * t + 1], first[3 * t + 2]};
  return triangles;
}

}  // namespace

TriangleMesh TriangleMesh::from_buffers(const PositionBuffer& positions, const IndexBuffer& indices, double scale) {
  if (!(scale > 0) || !std::isfinite(scale)) throw Error("the scale of a mesh has to be positive and finite");
  if (positions.floats == nullptr && positions.doubles == nullptr && positions.count > 0)
    throw Error("the pointer to " + std::to_string(positions.count) + " positions is null");
  if (indices.narrow == nullptr && indices.wide == nullptr && indices.count > 0)
    throw Error("the pointer to " + std::to_string(indices.count) + " indices is null");
  return {positions.floats != nullptr ? copied(positions.floats, positions, scale)
                                      : copied(positions.doubles, positions, scale),
          indices.narrow != nullptr ? corners_by_triangle(indices.narrow, indices.count)
                                    : corners_by_triangle(indices.wide, indices.count)};
}

TriangleMesh::TriangleMesh(std::vector<Vec3> vertices, std::vector<std::array<Index, 3>> triangles,
                           std::vector<Index> face_of_triangle)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)), face_of_triangle_(std::move(face_of_triangle)) {
  check_vertices(vertices_);
  check_triangles(triangles_, vertices_.size());
  check_faces(face_of_triangle_, triangles_.size());
  face_count_ = face_of_triangle_.empty() ? static_cast<Index>(triangles_.size()) : face_of_triangle_.back() + 1;
}

TriangleMesh TriangleMesh::with_vertices(std::vector<Vec3> vertices) const {
  if (vertices.size() != vertices_.size())
    throw Error("a mesh of " + std::to_string(vertices_.size()) + " vertices was given " +
                std::to_string(vertices.size()) + " others; give as many");
  check_vertices(vertices);
  TriangleMesh mesh;
  mesh.vertices_ = std::move(vertices);
  mesh.triangles_ = triangles_;
  mesh.face_of_triangle_ = face_of_triangle_;
  mesh.face_count_ = face_count_;
  return mesh;
}

}  // namespace toccata
