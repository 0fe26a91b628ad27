#pragma once

#include <span>
#include <string>

#include "query/subdivision/level_mesh.hpp"

namespace toccata {

/// How errors name what a cage has.
struct CageNames {
  std::span<const Vec3> points;
  std::span<const Index> vertices{};  ///< their numbers in the mesh that the cage is made of; empty: it is of none
  std::span<const Index> faces{};

  [[nodiscard]] std::string vertex(Index v) const;
  [[nodiscard]] std::string face(Index f) const;
  [[nodiscard]] std::string edge(Index a, Index b) const;
};

/// How what is a cage is connected; without sharpness. Throws Error as SubdivisionCage does.
[[nodiscard]] LevelMesh checked_level(const PolygonMesh& polygons, SubdivisionScheme scheme,
                                      const CageFeatures& features, const CageNames& names);

/// Gives each group of faces that meet others in a vertex only a vertex of its own, at the end, and makes all of these
/// corners that stay where they are for ever, as OpenSubdiv has it. The mesh is that of the polygons.
void part_at_vertices(const LevelMesh& mesh, PolygonMesh& polygons, CageFeatures& features);

}  // namespace toccata
