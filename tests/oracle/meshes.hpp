#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "oracle/convex.hpp"
#include "oracle/triangles.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::oracle {

/// The world triangles of a mesh; if solid, together with all points of winding number other than 0.
struct MeshSet {
  std::vector<RationalTriangle> triangles;
  bool solid = false;
};

/// Oracle of `is_closed`: every edge is used equally in both directions, vertices of equal file coordinates taken as
/// one.
bool is_closed(const TriangleMesh& mesh);

/// Throws std::invalid_argument where the truth page says error: a world vertex that is not finite, and for a solid an
/// open mesh or a singular pose.
MeshSet surface_set(const TriangleMesh& mesh, const Pose& pose);
MeshSet solid_set(const TriangleMesh& mesh, const Pose& pose);

/// A height field of `columns` × `rows` world vertices, vertex (i, j) at [j · columns + i]: a surface, each cell split
/// along (i, j)–(i + 1, j + 1).
MeshSet height_field_set(std::span<const Vec3> vertices, std::size_t columns, std::size_t rows);

struct TrianglePair {
  std::size_t a = 0;
  std::size_t b = 0;
  friend auto operator<=>(const TrianglePair&, const TrianglePair&) = default;
};

/// Oracle of `contacts`: all pairs of triangles that meet, ascending.
std::vector<TrianglePair> intersecting_pairs(const MeshSet& a, const MeshSet& b);

/// Oracle of `first_contact`: the least of them.
std::optional<TrianglePair> first_intersecting_pair(const MeshSet& a, const MeshSet& b);

/// Oracle of `self_contacts`: two triangles of one mesh that have more in common than the hull of the vertices they
/// share, or that have the same vertices; ascending, a < b.
std::vector<TrianglePair> self_intersecting_pairs(const MeshSet& mesh);

/// Some pair of triangles meets in the relative interiors of both, their six vertices not coplanar.
bool surfaces_cross(const MeshSet& a, const MeshSet& b);

/// Oracle of `locate`. The winding number is positive inside a mesh whose normals point outwards, and 0 on a face.
struct Location {
  bool on_face = false;
  int winding_number = 0;
  friend bool operator==(const Location&, const Location&) = default;
};

Location locate(const RationalPoint& p, const MeshSet& closed);

/// Oracle of `overlap` for meshes: the closed sets have a point in common.
bool overlap(const MeshSet& a, const MeshSet& b);

/// Oracle of `relation` for meshes. Cuts every triangle into the cells that the other triangles leave of it and asks
/// for the winding numbers on both sides of each; meant for up to about a hundred triangles in all.
Relation relation(const MeshSet& a, const MeshSet& b);

/// Oracle of `distance` for meshes: 0 when the sets meet, else the least over all pairs of triangles.
Rational squared_distance(const MeshSet& a, const MeshSet& b);

}  // namespace toccata::oracle
