#include "toccata/narrow/voronoi_regions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/vec3_measures.hpp"
#include "narrow/convex/plain_topology.hpp"
#include "narrow/voronoi/region_parts.hpp"

namespace toccata {
namespace {

using Parts = VoronoiRegions::Parts;

RegionPlane plane_through(const Vec3& normal, const Vec3& point) { return {normal, dot(normal, point)}; }

int dimension_of(const HullTopology& topology) {
  return topology.origin.empty() ? 0 : std::min(static_cast<int>(topology.face_count()), 3);
}

/// Of a face: its normal, and what each coordinate of that may be off by. The normal is that of the corner where the
/// two edges are the least parallel: off by 6u of the product of their lengths, and rounded to length 1.
struct FaceNormal {
  Vec3 unit;
  double error = 0;
};

FaceNormal face_normal(const Parts& parts, Index face) {
  const HullTopology& t = parts.topology;
  FaceNormal best{{}, std::numeric_limits<double>::infinity()};
  for (Index h = t.face_start[face]; h < t.face_start[face + 1]; ++h) {
    const Vec3 corner = parts.vertices[t.target(h)];
    const Vec3 from = corner - parts.vertices[t.origin[h]], to = parts.vertices[t.target(t.next(h))] - corner;
    const Vec3 unit_from = unit_or_zero(from), unit_to = unit_or_zero(to), normal = cross(unit_from, unit_to);
    const double sine = plain_length(normal), error = 0x1p-49 / sine + 0x1p-50;
    if (error < best.error) best = {unit_or_zero(normal), error};
  }
  return best;
}

void add_spokes(Parts& parts) {
  const HullTopology& t = parts.topology;
  parts.first_spoke.assign(parts.vertices.size() + 1, 0);
  parts.spoke_of.resize(t.origin.size());
  for (Index v = 0; v < parts.vertices.size(); ++v) {
    parts.first_spoke[v + 1] = static_cast<Index>(parts.spokes.size());
    if (t.origin.empty() || t.origin[t.leaving[v]] != v) continue;  // a corner that is none
    Index h = t.leaving[v];
    do {
      const Vec3 along = parts.vertices[t.target(h)] - parts.vertices[v];
      parts.spoke_of[h] = static_cast<Index>(parts.spokes.size());
      parts.spokes.push_back({along, 1 / dot(unit_or_zero(along), along), h});
      h = t.next(t.twin[h]);
    } while (h != t.leaving[v]);
    parts.first_spoke[v + 1] = static_cast<Index>(parts.spokes.size());
  }
}

bool is_of_face(const HullTopology& t, Index vertex, Index face) {
  const auto corners = corners_of_face(t, face);
  return std::ranges::find(corners, vertex) != corners.end();
}

/// The least depth below the plane of a face that a vertex has which is not of the face. Vertices down to any depth
/// hang together by edges, so it is a neighbour of the face.
double least_depth(const Parts& parts, Index face, const FaceNormal& normal) {
  const HullTopology& t = parts.topology;
  double least = std::numeric_limits<double>::infinity();
  for (Index h = t.face_start[face]; h < t.face_start[face + 1]; ++h)
    for (const Parts::Spoke& spoke : parts.spokes_at(t.origin[h])) {
      if (is_of_face(t, t.target(spoke.half_edge), face)) continue;
      const Vec3 along = parts.vertices[t.target(spoke.half_edge)] - parts.vertices[t.origin[h]];
      least = std::min(least, -dot(normal.unit, along));
    }
  return least;
}

void add_sides(Parts& parts, const std::vector<FaceNormal>& normals) {
  const HullTopology& t = parts.topology;
  for (Index f = 0; f < t.face_count(); ++f) {
    const RegionPlane plane = plane_through(normals[f].unit, parts.vertices[t.origin[t.face_start[f]]]);
    const double depth = parts.dimension == 3 ? least_depth(parts, f, normals[f]) : 0;
    const double certain = depth - 8 * normals[f].error * parts.extent;
    const double clearance = certain > 0 && normals[f].error < 0x1p-30 ? certain : 0;
    const auto corners = corners_of_face(t, f);
    std::array<Index, 3> triangle{};
    if (corners.size() == 3) std::ranges::partial_sort_copy(corners, triangle);
    parts.sides.push_back({plane, clearance, normals[f].error, triangle, static_cast<Index>(corners.size())});
  }
}

void add_rims(Parts& parts, const std::vector<FaceNormal>& normals) {
  const HullTopology& t = parts.topology;
  for (Index h = 0; h < t.origin.size(); ++h) {
    const Parts::Spoke& spoke = parts.spokes[parts.spoke_of[h]];
    const Vec3 start = parts.vertices[t.origin[h]], unit = unit_or_zero(spoke.along);
    Parts::Rim rim{plane_through(unit_or_zero(cross(normals[t.face[h]].unit, unit)), start), {}, spoke.per_length};
    if (parts.dimension == 3) {
      const Index beyond = t.face[t.twin[h]];
      const Vec3 into = parts.vertices[t.target(t.next(h))] - start;
      const double height = -dot(normals[beyond].unit, into) + 8 * normals[beyond].error * parts.extent;
      rim.into = ((1 - 0x1p-40) * (parts.sides[beyond].clearance / height)) * into;
    }
    parts.rims.push_back(rim);
  }
}

std::shared_ptr<const Parts> parts_of(std::vector<Vec3> vertices, const HullTopology& topology,
                                      std::optional<ConvexHull> hull = {}) {
  Parts parts;
  parts.hull = std::move(hull);
  if (parts.hull) parts.stored = parts.hull->padded_coordinates(0).data();
  parts.topology = topology;
  parts.dimension = dimension_of(topology);
  parts.vertices = std::move(vertices);
  for (const Vec3& v : parts.vertices) parts.extent = std::max(parts.extent, largest_magnitude(v));
  add_spokes(parts);
  if (parts.has_faces()) {
    std::vector<FaceNormal> normals;
    for (Index f = 0; f < topology.face_count(); ++f) normals.push_back(face_normal(parts, f));
    add_sides(parts, normals);
    add_rims(parts, normals);
  }
  return std::make_shared<const Parts>(std::move(parts));
}

std::vector<Vec3> vertices_of(const ConvexHull& hull) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  return vertices;
}

std::vector<Vec3> corners_of(const Box& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(box.corner(i));
  return corners;
}

}  // namespace

VoronoiRegions::VoronoiRegions(const Point& shape) : parts_(parts_of({shape.position()}, point_topology())) {}

VoronoiRegions::VoronoiRegions(const Segment& shape)
    : parts_(parts_of({shape.start(), shape.end()},
                      shape.start() == shape.end() ? point_topology() : segment_topology())) {}

VoronoiRegions::VoronoiRegions(const Triangle& shape)
    : parts_(parts_of({shape[0], shape[1], shape[2]}, triangle_topology(shape))) {}

VoronoiRegions::VoronoiRegions(const Box& shape) : parts_(parts_of(corners_of(shape), box_topology())) {}

VoronoiRegions::VoronoiRegions(const ConvexHull& shape)
    : parts_(parts_of(vertices_of(shape), shape.topology(), shape)) {}

int VoronoiRegions::dimension() const { return parts_->dimension; }
const HullTopology& VoronoiRegions::topology() const { return parts_->topology; }
Index VoronoiRegions::vertex_count() const { return static_cast<Index>(parts_->vertices.size()); }
Vec3 VoronoiRegions::vertex(Index i) const { return parts_->vertices[i]; }

RegionPlane VoronoiRegions::vertex_edge_plane(Index half_edge) const {
  const Vec3 unit = unit_or_zero(parts_->spokes[parts_->spoke_of[half_edge]].along);
  return plane_through(unit, parts_->vertices[parts_->topology.origin[half_edge]]);
}
RegionPlane VoronoiRegions::edge_face_plane(Index half_edge) const { return parts_->rims[half_edge].plane; }
RegionPlane VoronoiRegions::face_plane(Index face) const { return parts_->sides[face].plane; }

std::vector<ConvexFeature> VoronoiRegions::features() const {
  using Kind = ConvexFeature::Kind;
  const HullTopology& t = parts_->topology;
  std::vector<ConvexFeature> features;
  if (t.origin.empty()) return {{Kind::vertex, 0}};
  for (Index v = 0; v < vertex_count(); ++v)
    if (!parts_->spokes_at(v).empty()) features.push_back({Kind::vertex, v});
  for (Index h = 0; h < t.origin.size(); ++h)
    if (h < t.twin[h]) features.push_back({Kind::edge, h});
  if (parts_->has_faces())
    for (Index f = 0; f < t.face_count(); ++f) features.push_back({Kind::face, f});
  return features;
}

std::vector<RegionBound> VoronoiRegions::bounds(const ConvexFeature& feature) const {
  using Kind = RegionBound::Kind;
  const HullTopology& t = parts_->topology;
  std::vector<RegionBound> bounds;
  if (feature.kind == ConvexFeature::Kind::vertex) {
    for (const Parts::Spoke& spoke : parts_->spokes_at(feature.index))
      bounds.push_back({Kind::vertex_edge, spoke.half_edge, false, vertex_edge_plane(spoke.half_edge)});
  } else if (feature.kind == ConvexFeature::Kind::edge) {
    for (const Index h : {feature.index, t.twin[feature.index]}) {
      bounds.push_back({Kind::vertex_edge, h, true, vertex_edge_plane(h)});
      if (parts_->has_faces()) bounds.push_back({Kind::edge_face, h, false, edge_face_plane(h)});
    }
  } else {
    for (Index h = t.face_start[feature.index]; h < t.face_start[feature.index + 1]; ++h)
      bounds.push_back({Kind::edge_face, h, true, edge_face_plane(h)});
    bounds.push_back({Kind::face, feature.index, true, face_plane(feature.index)});
  }
  return bounds;
}

std::size_t VoronoiRegions::memory() const {
  const Parts& p = *parts_;
  return sizeof(Parts) + p.vertices.size() * sizeof(Vec3) + p.spokes.size() * sizeof(Parts::Spoke) +
         (p.first_spoke.size() + p.spoke_of.size()) * sizeof(Index) + p.rims.size() * sizeof(Parts::Rim) +
         p.sides.size() * sizeof(Parts::Side);
}

}  // namespace toccata
