#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

/// The vertices of a posed mesh as far as they are asked for, those of equal coordinates taken as one: numbered as they
/// come.
class VertexGraph {
 public:
  explicit VertexGraph(const PosedMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] const PosedMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t vertex_count() const { return positions_.size(); }
  [[nodiscard]] std::array<Index, 3> corners(Index triangle);

  /// In the world.
  [[nodiscard]] const Vec3& position(Index vertex) const { return positions_[vertex]; }

  /// Those that have it as a corner.
  [[nodiscard]] std::vector<Index> triangles_at(Index vertex) const;

 private:
  struct Hash {
    std::size_t operator()(const Vec3& v) const;
  };

  const PosedMesh& mesh_;
  std::vector<Vec3> positions_;
  std::unordered_map<Vec3, Index, Hash> numbers_;
};

/// The one of two models in contact whose triangles are meant.
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
  SurfaceWithin(VertexGraph& graph, const PosedMesh& solid, std::span<const Contact> contacts, ContactSide side);

  struct TriangleInContact {
    Index triangle = 0;
    std::array<Index, 3> corners{};  ///< as the graph numbers them
    std::vector<Index> contacts{};
    TouchedFeatures touched{};
  };

  /// Ascending.
  [[nodiscard]] std::span<const TriangleInContact> in_contact() const { return in_contact_; }
  [[nodiscard]] std::span<const InnerPiece> pieces() const { return pieces_; }

  static constexpr Index none = ~Index{0};
  /// The piece that a vertex belongs to; none where it is not inside.
  [[nodiscard]] Index piece_of(Index vertex) const {
    return vertex < piece_of_vertex_.size() ? piece_of_vertex_[vertex] : none;
  }

 private:
  void collect(std::span<const Contact> contacts, ContactSide side);
  [[nodiscard]] std::vector<Index> inner_corners(const PosedMesh& solid) const;
  [[nodiscard]] bool has_contact(Index triangle) const;
  void flood(Index from);
  [[nodiscard]] bool enter(Index vertex, Index piece);

  VertexGraph& graph_;
  std::vector<TriangleInContact> in_contact_;
  std::vector<Index> piece_of_vertex_;
  std::vector<InnerPiece> pieces_;
};

}  // namespace toccata
