#include "world/character_mover/face_normals.hpp"

#include <cmath>
#include <variant>

namespace toccata {
/// The normal by Newell's sum over the corners (M. E. Newell; in I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A
/// Characterization of Ten Hidden-Surface Algorithms", 1974).
Vec3 normal_of_face(const PosedPolytope& polytope, Index face) {
  const HullTopology topology = polytope.topology();
  Vec3 sum{};
  const Index first = topology.face_start[face], end = topology.face_start[face + 1];
  const Vec3 origin = polytope.vertex(topology.origin[first]);
  for (Index edge = first; edge < end; ++edge)
    sum += cross(polytope.vertex(topology.origin[edge]) - origin, polytope.vertex(topology.target(edge)) - origin);
  const auto& pose = polytope.pose().linear.row;
  const bool is_mirrored = dot(pose[0], cross(pose[1], pose[2])) < 0;  // so each face is turned round
  return normalized(is_mirrored ? -sum : sum);
}

std::vector<Vec3> face_normals_at(const LevelSet& set, const Vec3& point, const Vec3& outward, double tolerance) {
  std::vector<Vec3> normals;
  const auto* polytope = std::get_if<PosedPolytope>(&set);
  if (polytope == nullptr) return normals;
  const HullTopology topology = polytope->topology();
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Vec3 normal = normal_of_face(*polytope, face);
    const Vec3 corner = polytope->vertex(topology.origin[topology.face_start[face]]);
    const double height = std::abs(dot(normal, point - corner));
    if (std::abs(height - polytope->radius()) > tolerance || normal == Vec3{}) continue;
    if (dot(normal, outward) > 0) normals.push_back(normal);
  }
  return normals;
}

}  // namespace toccata
