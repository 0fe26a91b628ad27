#pragma once

#include <array>
#include <span>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "shapes/welded_mesh.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

/// A mesh as a graph: from its vertices, those of equal coordinates taken as one, to its triangles.
class VertexGraph {
 public:
  explicit VertexGraph(const PosedMesh& mesh);

  [[nodiscard]] const PosedMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t vertex_count() const { return welded_.distinct_vertices; }
  [[nodiscard]] std::size_t triangle_count() const { return welded_.triangles.size(); }
  [[nodiscard]] const std::array<Index, 3>& corners(Index triangle) const { return welded_.triangles[triangle]; }

  /// In the world.
  [[nodiscard]] Vec3 position(Index vertex) const { return mesh_.vertex(representative_[vertex]); }
  [[nodiscard]] std::span<const Index> triangles_at(Index vertex) const {
    return {around_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

 private:
  const PosedMesh& mesh_;
  WeldedTriangles welded_;
  std::vector<Index> representative_;  ///< a vertex of the mesh for each distinct one
  std::vector<std::size_t> first_;     ///< of each vertex, in `around_`
  std::vector<Index> around_;          ///< triangles
};

/// Of two models in contact, the one whose triangles are meant.
enum class ContactSide { a, b };

[[nodiscard]] Index triangle_of(const Contact& contact, ContactSide side);

/// The feature of that triangle.
[[nodiscard]] const Feature& feature_of(const IntersectionPoint& point, ContactSide side);

/// Which parts of a triangle its contacts touch.
struct TouchedFeatures {
  std::array<bool, 3> vertices{};
  std::array<bool, 3> edges{};  ///< from its vertex i to the next, with its ends

  void add(const Contact& contact, ContactSide side);
};

/// A piece of the surface that lies within the solid, without the triangles that have contacts.
struct InnerPiece {
  std::vector<Vec3> vertices;
  std::vector<Index> triangles;
};

/// What of a mesh lies inside a solid and hangs on triangles in contact with it. Between contacts a surface does not
/// change sides: so one vertex of each stretch is asked about, exactly.
class SurfaceWithin {
 public:
  /// The contacts are all those of the two.
  SurfaceWithin(const VertexGraph& graph, const PosedMesh& solid, std::span<const Contact> contacts, ContactSide side);

  struct TriangleInContact {
    Index triangle = 0;
    std::vector<Index> contacts;
    TouchedFeatures touched{};
  };

  /// Ascending.
  [[nodiscard]] std::span<const TriangleInContact> in_contact() const { return in_contact_; }
  [[nodiscard]] std::span<const InnerPiece> pieces() const { return pieces_; }

  static constexpr Index none = ~Index{0};
  /// The piece that a vertex belongs to; none where it is not inside.
  [[nodiscard]] Index piece_of(Index vertex) const { return piece_of_vertex_[vertex]; }

 private:
  void collect(std::span<const Contact> contacts, ContactSide side);
  [[nodiscard]] std::vector<Index> inner_corners(const PosedMesh& solid) const;
  void flood(Index from, const std::vector<char>& has_contact);

  const VertexGraph& graph_;
  std::vector<TriangleInContact> in_contact_;
  std::vector<Index> piece_of_vertex_;
  std::vector<InnerPiece> pieces_;
};

}  // namespace toccata
