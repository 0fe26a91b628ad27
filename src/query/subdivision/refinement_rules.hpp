#pragma once

#include "query/subdivision/level_mesh.hpp"

namespace toccata {

/// How the point of a vertex is made from its neighbours.
enum class VertexRule { smooth, dart, crease, corner };

/// The rule follows from how many of its edges are sharp: none, one, two, more.
[[nodiscard]] VertexRule vertex_rule(double vertex_sharpness, std::span<const double> spoke_sharpness);

/// A level later.
[[nodiscard]] double child_sharpness(double sharpness);

/// Loop's weight of each of `valence` neighbours of a smooth vertex.
[[nodiscard]] double loop_weight(Index valence);

// The points of the next level. All faces at the vertex, or on both sides of the edge, must be present, and of
// Catmull–Clark with their `face_points`. Each coordinate is off from the exact rule by no more than `rule_rounding`.

[[nodiscard]] Vec3 point_for_vertex(const LevelMesh& mesh, Index vertex, Spokes& spokes);
[[nodiscard]] Vec3 point_for_edge(const LevelMesh& mesh, Index edge);
[[nodiscard]] Vec3 point_for_face(const LevelMesh& mesh, Index face);

/// See above. Derived in docs/methods/subdivision-surfaces.md.
[[nodiscard]] double rule_rounding(const LevelMesh& mesh);

}  // namespace toccata
