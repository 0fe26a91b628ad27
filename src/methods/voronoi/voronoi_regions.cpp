#include "toccata/methods/voronoi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "methods/voronoi/region_parts.hpp"
#include "narrow/convex/plain_topology.hpp"

namespace toccata {
namespace {

RegionPlane plane_through(const Vec3& normal, const Vec3& point) { return {normal, dot(normal, point)}; }

int dimension_of(const HullTopology& topology) {
  return topology.origin.empty() ? 0 : std::min(static_cast<int>(topology.face_count()), 3);
}

/// The normal of a face, and what each of its coordinates may be off by. The normal is that of the corner where the two
/// edges are the least parallel: off by 6u of the product of their lengths, and rounded to length 1.
struct FaceNormal {
  Vec3 unit;
  double error = 0;
};

/// Given the directions of all half-edges.
FaceNormal face_normal(const HullTopology& t, Index face, std::span<const Vec3> directions) {
  FaceNormal best{{}, infinity};
  for (Index h = t.face_start[face]; h < t.face_start[face + 1]; ++h) {
    const Vec3 normal = cross(directions[h], directions[t.next(h)]);
    const double sine = plain_length(normal), error = 0x1p-49 / sine + 0x1p-50;
    if (error < best.error) best = {normal, error};
  }
  return {unit_or_zero(best.unit), best.error};
}

/// Each edge's both, unit.
std::vector<Vec3> directions_of(const RegionParts& parts) {
  const HullTopology& t = parts.topology;
  std::vector<Vec3> directions(t.origin.size());
  for (Index h = 0; h < t.origin.size(); ++h)
    if (h < t.twin[h]) {
      directions[h] = unit_or_zero(parts.way(h));
      directions[t.twin[h]] = -directions[h];
    }
  return directions;
}

void add_spokes(RegionParts& parts) {
  const HullTopology& t = parts.topology;
  parts.spokes.reserve(t.origin.size());
  for (Index v = 0; v < parts.vertex_count; ++v) {
    if (t.origin.empty() || t.origin[t.leaving[v]] != v) continue;  // a corner that is none
    parts.vertices[v].first_spoke = static_cast<Index>(parts.spokes.size());
    Index h = t.leaving[v];
    do {
      parts.spokes.push_back({t.target(h), h});
      h = t.next(t.twin[h]);
    } while (h != t.leaving[v]);
    parts.vertices[v].end_of_spokes = static_cast<Index>(parts.spokes.size());
  }
}

bool is_of_face(const HullTopology& t, Index vertex, Index face) {
  const auto corners = corners_of_face(t, face);
  return std::ranges::find(corners, vertex) != corners.end();
}

/// The least depth below the plane of a face that a vertex has which is not of the face. Vertices down to any depth
/// hang together by edges, so it is a neighbour of the face.
double least_depth(const RegionParts& parts, Index face, const Vec3& normal) {
  const HullTopology& t = parts.topology;
  double least = infinity;
  for (Index h = t.face_start[face]; h < t.face_start[face + 1]; ++h)
    for (const RegionParts::Spoke& spoke : parts.spokes_at(t.origin[h]))
      if (!is_of_face(t, spoke.vertex, face))
        least = std::min(least, -dot(normal, parts.vertex(spoke.vertex) - parts.vertex(t.origin[h])));
  return least;
}

RegionParts::Side side_of(const RegionParts& parts, Index face, std::span<const Vec3> directions) {
  const FaceNormal normal = face_normal(parts.topology, face, directions);
  const double depth = parts.dimension == 3 ? least_depth(parts, face, normal.unit) : 0;
  const double certain = depth - 8 * normal.error * parts.extent;
  const double clearance = certain > 0 && normal.error < 0x1p-30 ? certain : 0;
  const auto corners = corners_of_face(parts.topology, face);
  RegionParts::Side side{normal.unit, clearance, normal.error, {}, static_cast<Index>(corners.size())};
  side.first = parts.topology.face_start[face];
  if (corners.size() != 3) return side;
  side.is_turned = corners[2] < corners[1];
  std::ranges::partial_sort_copy(corners, side.triangle);
  return side;
}

/// The way from the start of a half-edge into its face: see `Edge::into`.
Vec3 way_into(const RegionParts& parts, Index half_edge) {
  const HullTopology& t = parts.topology;
  const RegionParts::Side& beyond = parts.sides[t.face[t.twin[half_edge]]];
  const Vec3 into = parts.vertex(t.target(t.next(half_edge))) - parts.vertex(t.origin[half_edge]);
  const double height = -dot(beyond.normal, into) + 8 * beyond.error * parts.extent;
  return ((1 - 0x1p-40) * (beyond.clearance / height)) * into;
}

void add_edges(RegionParts& parts, std::span<const Vec3> directions) {
  const HullTopology& t = parts.topology;
  parts.edge_number.resize(t.origin.size());
  parts.edges.reserve(t.origin.size() / 2);
  parts.faces_at.reserve(t.origin.size() / 2);
  for (Index h = 0; h < t.origin.size(); ++h) {
    const Index twin = t.twin[h];
    if (twin < h) continue;
    parts.edge_number[h] = parts.edge_number[twin] = static_cast<Index>(parts.edges.size());
    const auto [least, greatest] = std::minmax({t.origin[h], t.target(h)});
    const auto lean = static_cast<float>(4 * parts.extent / dot(directions[h], parts.way(h)));
    RegionParts::Edge edge{{}, std::nextafter(lean, std::numeric_limits<float>::infinity()), h, {least, greatest}};
    const Index forth = t.origin[h] == least ? h : twin;
    parts.faces_at.push_back({t.face[forth], t.face[t.twin[forth]]});
    if (parts.dimension == 3) edge.into = {way_into(parts, h), way_into(parts, twin)};
    parts.edges.push_back(edge);
  }
}

void add_rims(RegionParts& parts, std::span<const Vec3> directions) {
  const HullTopology& t = parts.topology;
  parts.rims.reserve(t.origin.size());
  for (Index h = 0; h < t.origin.size(); ++h) {
    const Vec3 into = cross(parts.sides[t.face[h]].normal, directions[h]);
    parts.rims.push_back(plane_through(unit_or_zero(into), parts.vertex(t.origin[h])));
  }
}

/// Summed so that nothing overflows.
Vec3 middle_of(const RegionParts& parts) {
  const double share = 1.0 / parts.vertex_count;
  Vec3 middle;
  for (Index i = 0; i < parts.vertex_count; ++i) middle = middle + share * parts.vertex(i);
  return middle;
}

std::shared_ptr<const RegionParts> parts_of(const std::vector<Vec3>& vertices, const HullTopology& topology,
                                            std::optional<ConvexHull> hull = {}) {
  const auto parts = std::make_shared<RegionParts>();
  parts->hull = std::move(hull);
  if (parts->hull) parts->stored = parts->hull->padded_coordinates(0).data();
  parts->topology = topology;
  parts->dimension = dimension_of(topology);
  parts->vertex_count = static_cast<Index>(vertices.size());
  parts->vertices.reserve(vertices.size());
  for (const Vec3& v : vertices) {
    parts->vertices.push_back({v, 0, 0});
    parts->extent = std::max(parts->extent, largest_magnitude(v));
  }
  parts->middle = middle_of(*parts);
  add_spokes(*parts);
  const std::vector<Vec3> directions = directions_of(*parts);
  if (parts->has_faces()) {
    parts->sides.reserve(topology.face_count());
    for (Index f = 0; f < topology.face_count(); ++f) parts->sides.push_back(side_of(*parts, f, directions));
    add_rims(*parts, directions);
  }
  add_edges(*parts, directions);
  parts->numbers = {parts->vertex_count, static_cast<Index>(topology.origin.size()),
                    static_cast<Index>(parts->sides.size())};
  return parts;
}

std::vector<Vec3> corners_of(const ConvexHull& hull) {
  std::vector<Vec3> corners;
  corners.reserve(hull.vertex_count());
  for (Index i = 0; i < hull.vertex_count(); ++i) corners.push_back(hull.vertex(i));
  return corners;
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
    : parts_(parts_of(corners_of(shape), shape.topology(), shape)) {}

int VoronoiRegions::dimension() const { return parts_->dimension; }
const HullTopology& VoronoiRegions::topology() const { return parts_->topology; }
Index VoronoiRegions::vertex_count() const { return parts_->vertex_count; }
Vec3 VoronoiRegions::vertex(Index i) const { return parts_->vertex(i); }

RegionPlane VoronoiRegions::vertex_edge_plane(Index half_edge) const {
  return plane_through(unit_or_zero(parts_->way(half_edge)), parts_->vertex(parts_->topology.origin[half_edge]));
}
RegionPlane VoronoiRegions::edge_face_plane(Index half_edge) const { return parts_->rims[half_edge]; }
RegionPlane VoronoiRegions::face_plane(Index face) const {
  const HullTopology& t = parts_->topology;
  return plane_through(parts_->sides[face].normal, parts_->vertex(t.origin[t.face_start[face]]));
}

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
    for (const RegionParts::Spoke& spoke : parts_->spokes_at(feature.index))
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
  const RegionParts& p = *parts_;
  return sizeof(RegionParts) + p.vertices.size() * sizeof(RegionParts::Vertex) +
         p.spokes.size() * sizeof(RegionParts::Spoke) + p.edge_number.size() * sizeof(Index) +
         p.edges.size() * (sizeof(RegionParts::Edge) + sizeof(p.faces_at[0])) + p.rims.size() * sizeof(RegionPlane) +
         p.sides.size() * sizeof(RegionParts::Side);
}

}  // namespace toccata
