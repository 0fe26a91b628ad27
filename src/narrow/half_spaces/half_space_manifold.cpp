#include <algorithm>
#include <cmath>
#include <vector>

#include "narrow/convex/contact_choices.hpp"
#include "narrow/convex/plain_scale.hpp"
#include "narrow/half_spaces/half_space_gap.hpp"
#include "narrow/triangles/contact_faces.hpp"

namespace toccata {
namespace {

std::vector<Index> vertices_of_face(const HullTopology& topology, Index face) {
  std::vector<Index> result;
  for (Index h = topology.face_start[face]; h < topology.face_start[face + 1]; ++h)
    result.push_back(topology.origin[h]);
  return result;
}

/// The sum of the triangles' normals of a fan, rounded.
Vec3 normal_of_face(const PosedPolytope& a, const std::vector<Index>& corners) {
  Vec3 sum;
  const Vec3 first = a.vertex(corners[0]);
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum = sum + cross(a.vertex(corners[i - 1]) - first, a.vertex(corners[i]) - first);
  return sum;
}

/// How much a face turns to the half-space: the cosine between its outward normal and −normal.
double facing(const PosedPolytope& a, const std::vector<Index>& corners, const Vec3& normal) {
  const Vec3 outward = normal_of_face(a, corners);
  const double length = std::sqrt(dot(outward, outward));
  if (!(length > 0)) return 0;
  return -turn_of_faces(a.pose().linear) * dot(outward, normal) / length;
}

/// The vertices of the face at a vertex that turns most to the half-space; of a point, the point.
std::vector<Index> facing_corners(const PosedPolytope& a, Index vertex, const Vec3& normal) {
  const HullTopology topology = a.topology();
  if (topology.face_count() == 0) return {vertex};
  const Index first = topology.leaving[vertex];
  std::vector<Index> best;
  double best_facing = 0;
  Index half_edge = first;
  do {
    std::vector<Index> corners = vertices_of_face(topology, topology.face[half_edge]);
    const double towards = facing(a, corners, normal);
    if (best.empty() || towards > best_facing) {
      best = std::move(corners);
      best_facing = towards;
    }
    half_edge = topology.next(topology.twin[half_edge]);
  } while (half_edge != first);
  return best;
}

double farthest(const PosedPolytope& a, const std::vector<Index>& corners, const Vec3& from) {
  double squared = 0;
  for (const Index i : corners) squared = std::fmax(squared, dot(a.vertex(i) - from, a.vertex(i) - from));
  return std::sqrt(squared);
}

ManifoldPoint point_at(const PosedPolytope& a, Index vertex, const PosedHalfSpace& b, const Vec3& normal) {
  const Vec3 position = a.vertex(vertex);
  const double height = dot(normal, position - b.point);
  const ConvexFeature plane{ConvexFeature::Kind::face, 0}, corner{ConvexFeature::Kind::vertex, vertex};
  return {position - (height + a.radius()) / 2 * normal, a.radius() - height, corner, plane};
}

/// The deepest, the farthest from it, and the farthest to both sides of the line through these.
Manifold four_of(const std::vector<ManifoldPoint>& points, const Vec3& normal) {
  Manifold result;
  result.normal = -normal;
  std::vector<bool> taken(points.size());
  const auto take_greatest = [&](const auto& measure) {
    std::size_t best = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!taken[i] && measure(points[i]) > (best == points.size() ? 0 : measure(points[best]))) best = i;
    if (best == points.size()) return;
    taken[best] = true;
    result.points[static_cast<std::size_t>(result.count++)] = points[best];
  };
  taken[0] = true;
  result.points[static_cast<std::size_t>(result.count++)] = points[0];
  const Vec3 origin = points[0].position;
  take_greatest([&](const ManifoldPoint& p) { return dot(p.position - origin, p.position - origin); });
  if (result.count < 2) return result;
  const Vec3 along = cross(normal, result.points[1].position - origin);
  take_greatest([&](const ManifoldPoint& p) { return dot(along, p.position - origin); });
  take_greatest([&](const ManifoldPoint& p) { return -dot(along, p.position - origin); });
  return result;
}

/// The manifold of shapes of plain sizes that meet.
Manifold of_plain_sizes(const PosedPolytope& a, Index lowest, const PosedHalfSpace& b) {
  const Vec3 normal = unit_normal(b);
  const std::vector<Index> corners = facing_corners(a, lowest, normal);
  const double gap = gap_of_resting * farthest(a, corners, a.vertex(lowest));
  std::vector<ManifoldPoint> points{point_at(a, lowest, b, normal)};
  for (const Index corner : corners) {
    const ManifoldPoint point = point_at(a, corner, b, normal);
    if (corner != lowest && point.depth >= -gap) points.push_back(point);
  }
  return four_of(points, normal);
}

}  // namespace

Manifold manifold(const PosedPolytope& a, const PosedHalfSpace& b) {
  const ExtremeVertex lowest = extreme_vertex(a, b, Reach::below);
  if (reach_sign(lowest.position, a.radius(), b, Reach::below) == Sign::negative) return {};
  const double of_plane = std::max({std::fabs(b.point.x), std::fabs(b.point.y), std::fabs(b.point.z)});
  const int exponent = exponent_to_plain(std::max(greatest_length(a), of_plane));
  if (exponent == 0) return of_plain_sizes(a, lowest.index, b);
  PosedHalfSpace plain = b;
  plain.point = {std::scalbn(b.point.x, exponent), std::scalbn(b.point.y, exponent), std::scalbn(b.point.z, exponent)};
  return scaled(of_plain_sizes(a.scaled(exponent), lowest.index, plain), -exponent);
}

}  // namespace toccata
