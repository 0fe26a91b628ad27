#include "query/contacts/surface_within.hpp"

#include <algorithm>
#include <utility>

#include "query/relation/relation_locality.hpp"
#include "shapes/union_find.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

VertexGraph::VertexGraph(const PosedMesh& mesh) : mesh_(mesh), welded_(weld(mesh.model().mesh())) {
  const std::size_t count = welded_.distinct_vertices;
  representative_.resize(count);
  first_.assign(count + 1, 0);
  const auto triangles = mesh.model().mesh().triangles();
  for (Index t = 0; t < welded_.triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      representative_[welded_.triangles[t][corner]] = triangles[t][corner];
      ++first_[welded_.triangles[t][corner] + 1];
    }
  for (std::size_t i = 0; i < count; ++i) first_[i + 1] += first_[i];
  around_.resize(first_[count]);
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (Index t = 0; t < welded_.triangles.size(); ++t)
    for (const Index corner : welded_.triangles[t]) around_[next[corner]++] = t;
}

Index triangle_of(const Contact& contact, ContactSide side) {
  return side == ContactSide::a ? contact.triangle_a : contact.triangle_b;
}

const Feature& feature_of(const IntersectionPoint& point, ContactSide side) {
  return side == ContactSide::a ? point.on_a : point.on_b;
}

void TouchedFeatures::add(const Contact& contact, ContactSide side) {
  for (std::size_t i = 0; i < contact.intersection.count; ++i) {
    const Feature& feature = feature_of(contact.intersection.points[i], side);
    if (feature.kind == FeatureKind::face) continue;
    edges[feature.index] = true;
    if (feature.kind != FeatureKind::vertex) continue;
    vertices[feature.index] = true;
    edges[(feature.index + 2) % 3] = true;
  }
}

SurfaceWithin::SurfaceWithin(const VertexGraph& graph, const PosedMesh& solid, std::span<const Contact> contacts,
                             ContactSide side)
    : graph_(graph), piece_of_vertex_(graph.vertex_count(), none) {
  collect(contacts, side);
  std::vector<char> has_contact(graph.triangle_count());
  for (const TriangleInContact& one : in_contact_) has_contact[one.triangle] = 1;
  for (const Index corner : inner_corners(solid))
    if (piece_of_vertex_[corner] == none) flood(corner, has_contact);
}

void SurfaceWithin::collect(std::span<const Contact> contacts, ContactSide side) {
  std::vector<std::pair<Index, Index>> uses;
  for (Index i = 0; i < contacts.size(); ++i) uses.emplace_back(triangle_of(contacts[i], side), i);
  std::sort(uses.begin(), uses.end());
  for (const auto& [triangle, contact] : uses) {
    if (in_contact_.empty() || in_contact_.back().triangle != triangle) in_contact_.push_back({triangle, {}, {}});
    in_contact_.back().contacts.push_back(contact);
    in_contact_.back().touched.add(contacts[contact], side);
  }
}

/// Corners of the triangles in contact. Two at the ends of an edge that nothing touches are on the same side.
std::vector<Index> SurfaceWithin::inner_corners(const PosedMesh& solid) const {
  std::vector<Index> corners;
  for (const TriangleInContact& one : in_contact_)
    for (const Index corner : graph_.corners(one.triangle)) corners.push_back(corner);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto place = [&](Index corner) {
    return static_cast<Index>(std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin());
  };
  UnionFind same_side(corners.size());
  for (const TriangleInContact& one : in_contact_) {
    if (!has_area(graph_.mesh().triangle(one.triangle))) continue;
    const auto& of_triangle = graph_.corners(one.triangle);
    for (std::size_t i = 0; i < 3; ++i)
      if (!one.touched.edges[i]) same_side.unite(place(of_triangle[i]), place(of_triangle[(i + 1) % 3]));
  }
  std::vector<char> leader_is_inside(corners.size());
  std::vector<Index> inner;
  for (Index i = 0; i < corners.size(); ++i) {
    const Index leader = same_side.leader(i);
    if (leader == i) leader_is_inside[i] = is_interior(graph_.position(corners[i]), solid) ? 1 : 0;
    if (leader_is_inside[leader] != 0) inner.push_back(corners[i]);
  }
  return inner;
}

void SurfaceWithin::flood(Index from, const std::vector<char>& has_contact) {
  const auto number = static_cast<Index>(pieces_.size());
  InnerPiece piece;
  std::vector<Index> waiting{from};
  piece_of_vertex_[from] = number;
  while (!waiting.empty()) {
    const Index vertex = waiting.back();
    waiting.pop_back();
    piece.vertices.push_back(graph_.position(vertex));
    for (const Index triangle : graph_.triangles_at(vertex)) {
      if (has_contact[triangle] != 0) continue;
      if (graph_.corners(triangle)[0] == vertex) piece.triangles.push_back(triangle);
      for (const Index corner : graph_.corners(triangle)) {
        if (piece_of_vertex_[corner] != none) continue;
        piece_of_vertex_[corner] = number;
        waiting.push_back(corner);
      }
    }
  }
  pieces_.push_back(std::move(piece));
}

}  // namespace toccata
