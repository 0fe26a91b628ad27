#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// Positions where a program keeps them: x, y and z in a row, the next ones `stride` bytes after. Refers to them.
struct PositionBuffer {
  PositionBuffer(const float* first_x, std::size_t how_many, std::size_t bytes = 3 * sizeof(float))
      : floats(first_x), count(how_many), stride(bytes) {}
  PositionBuffer(const double* first_x, std::size_t how_many, std::size_t bytes = 3 * sizeof(double))
      : doubles(first_x), count(how_many), stride(bytes) {}

  const float* floats = nullptr;  ///< one of the two
  const double* doubles = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;
};

/// Corners of triangles, three a triangle, counted from 0: `{indices}` of a vector or span, or
/// `{first, count}`. Refers to them.
struct IndexBuffer {
  IndexBuffer(std::span<const std::uint16_t> indices) : narrow(indices.data()), count(indices.size()) {}
  IndexBuffer(std::span<const std::uint32_t> indices) : wide(indices.data()), count(indices.size()) {}
  IndexBuffer(const std::uint16_t* first, std::size_t how_many) : narrow(first), count(how_many) {}
  IndexBuffer(const std::uint32_t* first, std::size_t how_many) : wide(first), count(how_many) {}

  const std::uint16_t* narrow = nullptr;  ///< one of the two
  const std::uint32_t* wide = nullptr;
  std::size_t count = 0;
};

/// Vertices and triangles that do not change after construction. Every triangle belongs to a face: the polygon of the
/// file it was cut from, counted from 0 in the order of the file. Answers speak of these face numbers.
class TriangleMesh {
 public:
  /// Throws Error naming the element when a coordinate is not finite, an index is out of range, there is no triangle,
  /// or `face_of_triangle` is neither empty (triangle i is face i) nor as long as `triangles` and ascending.
  TriangleMesh(std::vector<Vec3> vertices, std::vector<std::array<Index, 3>> triangles,
               std::vector<Index> face_of_triangle = {});

  /// Copied from the buffers of another program, each coordinate multiplied by `scale`: 0.001 of millimetres makes
  /// metres. Throws Error as the constructor does, and when a buffer is null, the positions overlap (a stride of less
  /// than three numbers), the indices are no triples, or the scale is not positive and finite.
  static TriangleMesh from_buffers(const PositionBuffer& positions, const IndexBuffer& indices, double scale = 1);

  /// The same triangles and faces with other vertices, as many as before. Throws Error as the constructor does, and for
  /// another number of vertices.
  [[nodiscard]] TriangleMesh with_vertices(std::vector<Vec3> vertices) const;

  [[nodiscard]] std::span<const Vec3> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const std::array<Index, 3>> triangles() const { return triangles_; }
  [[nodiscard]] Index triangle_count() const { return static_cast<Index>(triangles_.size()); }
  [[nodiscard]] Index face_count() const { return face_count_; }
  [[nodiscard]] Index face_of(Index triangle) const {
    return face_of_triangle_.empty() ? triangle : face_of_triangle_[triangle];
  }

 private:
  TriangleMesh() = default;

  std::vector<Vec3> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> face_of_triangle_;
  Index face_count_ = 0;
};

/// Faces of any number of corners, as files hold them: face i has the corners [first[i], first[i + 1]).
struct PolygonMesh {
  std::vector<Vec3> vertices;
  std::vector<Index> corners;
  std::vector<Index> first{0};
};

/// A face of more corners is refused: cutting it takes time that grows with the square of their number.
inline constexpr Index most_face_corners = 65536;

/// Cuts every face into triangles by ear clipping in the coordinate plane in which the face is largest, with exact
/// signs (G. H. Meisters, "Polygons have ears", 1975). A face that has no proper ears (it crosses itself or has no
/// area) is fanned from its first corner. Faces of fewer than three or of more than
/// most_face_corners corners are an Error naming the face.
[[nodiscard]] TriangleMesh triangulate(const PolygonMesh& polygons);

/// The parts of a mesh: triangles that are connected through vertices, those of equal coordinates taken as one.
struct MeshParts {
  std::vector<Index> part_of_triangle;
  std::vector<Index> first_triangle;  ///< the least of each part, ascending
};

[[nodiscard]] MeshParts mesh_parts(const TriangleMesh& mesh);

}  // namespace toccata
