#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "query/contacts/cut_triangle.hpp"
#include "query/contacts/surface_within.hpp"

namespace toccata {

/// A plane piece of the surface of what two solids have in common, on a triangle with contacts.
struct PlanePiece {
  Vec3 area;            ///< twice its area along its normal, whichever way that points
  double weight = 0.5;  ///< a half, as every line through the common part passes its surface twice; 1 of touching faces
  Index contact = 0;    ///< near which it lies
};

/// A triangle of one solid cut along its contacts with the other: the pieces inside the other and, of the first solid,
/// those on which faces of both lie. Doubles; a point of each piece is asked about exactly.
class TriangleCutter {
 public:
  /// `turn` is −1 where the triangles' normals point into the solid.
  TriangleCutter(const VertexGraph& graph, double turn, const VertexGraph& other, double other_turn,
                 std::span<const Contact> contacts, ContactSide side)
      : graph_(graph), other_(other), same_turn_(turn * other_turn > 0), contacts_(contacts), side_(side) {}

  void add_pieces(const SurfaceWithin& within, const SurfaceWithin::TriangleInContact& one,
                  std::vector<PlanePiece>& pieces) const;

 private:
  [[nodiscard]] std::vector<Vec3> points_of(Index contact, const Triangle& own) const;
  /// None of what is neither inside nor on a face. `telling`: the triangle's corners that lie on the same side as what
  /// hangs on them.
  [[nodiscard]] std::optional<double> weight_of(const TrianglePart& part, const SurfaceWithin& within,
                                                const SurfaceWithin::TriangleInContact& one,
                                                const std::array<bool, 3>& telling) const;

  const VertexGraph& graph_;
  const VertexGraph& other_;
  bool same_turn_;
  std::span<const Contact> contacts_;
  ContactSide side_;
};

}  // namespace toccata
