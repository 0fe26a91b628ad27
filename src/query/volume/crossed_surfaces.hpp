#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "math/bounded_number.hpp"
#include "query/contacts/surface_within.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/volume/perturbed_pair.hpp"

namespace toccata {

/// The triangles with area that meet the region, ascending.
[[nodiscard]] std::vector<Index> triangles_in_region(const PosedMesh& mesh, const Aabb& region);

/// What two boxes that overlap have in common.
[[nodiscard]] Aabb common_box(const Aabb& a, const Aabb& b);

/// The share of the way from `from` to `to`, on both sides of the plane or on it, at which the plane is.
[[nodiscard]] BoundedNumber share_at_plane(const Triangle& plane, const Vec3& from, const Vec3& to);

/// Two triangles that cross, and where.
struct CrossingPair {
  Index of_first = 0;
  Index of_second = 0;
  EdgesThrough through;
};

/// One of the two solids while the other's winding numbers are looked at on its surface.
class VolumeSurface {
 public:
  /// What touches or crosses the other is `in_contact`.
  VolumeSurface(const PosedMesh& mesh, const PosedMesh& other, VolumeSide side, std::vector<Index> in_contact);

  [[nodiscard]] const PosedMesh& mesh() const { return graph_.mesh(); }
  [[nodiscard]] VolumeSide side() const { return side_; }
  [[nodiscard]] Triangle triangle(Index number) const { return graph_.mesh().triangle(number); }
  [[nodiscard]] VertexGraph& graph() { return graph_; }
  /// The triangles with area that have contacts, ascending.
  [[nodiscard]] std::span<const Index> in_contact() const { return in_contact_; }

  /// The winding number of the other at a vertex, as the graph numbers it.
  [[nodiscard]] int winding_at(Index vertex);

  /// Triangles without contact, and the winding number of the other on each, where that is not 0. What is the same for
  /// all vertices that they join is asked once.
  [[nodiscard]] std::span<const std::pair<Index, int>> whole_triangles();

 private:
  [[nodiscard]] std::vector<std::pair<Index, int>> found_whole();

  VertexGraph graph_;
  const PosedMesh& other_;
  VolumeSide side_;
  std::vector<Index> in_contact_;
  std::map<Index, int> windings_;
  std::vector<std::pair<Index, int>> whole_;
  bool has_whole_ = false;
};

/// Two closed meshes after the first was moved as perturbed_pair.hpp says, and which of their triangles cross.
struct CrossedSurfaces {
  /// The contacts are all that the meshes have, whose boxes overlap.
  CrossedSurfaces(const PosedMesh& first, const PosedMesh& second, std::span<const Contact> contacts);

  VolumeSurface first;
  VolumeSurface second;
  std::vector<CrossingPair> pairs;
};

}  // namespace toccata
