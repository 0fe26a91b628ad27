#pragma once

#include <vector>

#include "query/relation/relation_samples.hpp"

namespace toccata {

/// The triangles of two meshes that meet triangles of the other, ascending, each once.
struct ContactTriangles {
  std::vector<Index> of_a;
  std::vector<Index> of_b;
};

/// What was seen, and all that there can be: what is neither does not exist.
struct RegionsKnown {
  RegionsSeen seen;
  RegionsSeen possible;

  [[nodiscard]] bool complete() const { return seen == (seen | possible); }
};

/// All kinds of region that border on triangles with contacts, seen, and those that can border on triangles without
/// that are connected with them.
[[nodiscard]] RegionsKnown regions_at_contacts(const SolidPair& pair, const ContactTriangles& contacts);

/// Those that can border on the parts of either mesh that have no contact; none is seen.
[[nodiscard]] RegionsSeen regions_possible_at_other_parts(const SolidPair& pair, const ContactTriangles& contacts);

/// What is seen beside one triangle of each of these parts.
[[nodiscard]] RegionsSeen sample_other_parts(const SolidPair& pair, const ContactTriangles& contacts);

/// The parts of the mesh, by number, that have none of these triangles.
[[nodiscard]] std::vector<Index> parts_without(const PosedMesh& mesh, std::span<const Index> triangles);

/// The point lies off all faces of the closed mesh, and its winding number there is not 0.
[[nodiscard]] bool is_interior(const Vec3& point, const PosedMesh& closed);

}  // namespace toccata
