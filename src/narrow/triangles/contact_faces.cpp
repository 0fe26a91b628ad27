#include "narrow/triangles/contact_faces.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"

namespace toccata {
namespace {

/// The sum of a fan's normals: not of length 1, and inwards when the pose mirrors.
Vec3 area_vector(const SupportSearch& shape, Index face) {
  const HullTopology topology = shape.shape().topology();
  const Index first = topology.face_start[face], last = topology.face_start[face + 1];
  const Vec3 origin = shape.vertex(topology.origin[first]);
  Vec3 sum, spoke = shape.vertex(topology.origin[first + 1]) - origin;
  for (Index h = first + 2; h < last; ++h) {
    const Vec3 next = shape.vertex(topology.origin[h]) - origin;
    sum = sum + cross(spoke, next);
    spoke = next;
  }
  return sum;
}

void consider(ContactFace& best, const SupportSearch& shape, Index face, const Vec3& direction, double mirrored) {
  const Vec3 area = mirrored * area_vector(shape, face);
  const double length = std::sqrt(dot(area, area));
  if (best.face == ContactFace::none) best.face = face;
  if (!(length > 0)) return;
  const double facing = dot(area, direction) / length;
  if (facing <= best.facing) return;
  best.face = face;
  best.facing = facing;
  best.area = length;
  best.normal = (1 / length) * area;
}

bool has_vertex(const HullTopology& topology, Index face, Index vertex) {
  for (Index h = topology.face_start[face]; h < topology.face_start[face + 1]; ++h)
    if (topology.origin[h] == vertex) return true;
  return false;
}

}  // namespace

double turn_of_faces(const Mat3& linear) {
  const double volume = dot(cross(linear[0], linear[1]), linear[2]);
  const double most =
      std::max({largest_magnitude(linear[0]), largest_magnitude(linear[1]), largest_magnitude(linear[2])});
  if (most < 2 && std::fabs(volume) > 0x1p-20) return volume < 0 ? -1 : 1;  // as of every pose that hardly deforms
  const auto plain = [](const Vec3& row) {
    const double greatest = std::max({std::fabs(row.x), std::fabs(row.y), std::fabs(row.z)});
    return Vec3{row.x / greatest, row.y / greatest, row.z / greatest};
  };
  return dot(cross(plain(linear[0]), plain(linear[1])), plain(linear[2])) < 0 ? -1 : 1;
}

ContactFace facing_face(const PosedPolytope& shape, const Vec3& direction) {
  ContactFace best;
  best.shape = &shape;
  const SupportKernels kernels = support_kernels();
  const SupportSearch search(shape, kernels);
  best.vertex = search.least(-direction);
  const HullTopology topology = shape.topology();
  if (topology.face_count() == 0) return best;
  const double mirrored = turn_of_faces(shape.pose().linear);
  const Index start = topology.leaving[best.vertex];
  // A vertex between the ends of a triangle without area has no half-edge; its segment is the only face.
  if (topology.origin[start] != best.vertex) {
    consider(best, search, 0, direction, mirrored);
    return best;
  }
  Index half_edge = start;
  do {
    consider(best, search, topology.face[half_edge], direction, mirrored);
    half_edge = topology.next(topology.twin[half_edge]);
  } while (half_edge != start);
  return best;
}

ConvexFeature feature_of(const PosedPolytope& shape, const std::array<Index, 4>& vertices, std::size_t count) {
  const Index first = vertices[0];
  Index second = first;
  for (std::size_t k = 1; k < count; ++k)
    if (vertices[k] != first) second = vertices[k];
  const ConvexFeature corner{ConvexFeature::Kind::vertex, first};
  const HullTopology topology = shape.topology();
  if (second == first || topology.face_count() == 0) return corner;
  const bool is_edge = std::all_of(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count),
                                   [&](Index v) { return v == first || v == second; });
  const Index start = topology.leaving[first];
  if (topology.origin[start] != first) return corner;
  Index half_edge = start;
  do {
    if (is_edge && topology.target(half_edge) == second)
      return {ConvexFeature::Kind::edge, edge_number(topology, half_edge)};
    half_edge = topology.next(topology.twin[half_edge]);
  } while (half_edge != start);
  do {
    const Index face = topology.face[half_edge];
    if (std::all_of(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count),
                    [&](Index v) { return has_vertex(topology, face, v); }))
      return {ConvexFeature::Kind::face, face};
    half_edge = topology.next(topology.twin[half_edge]);
  } while (half_edge != start);
  return corner;
}

}  // namespace toccata
