#include "query/contacts/surface_within.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "query/meshes/world_search.hpp"
#include "query/relation/relation_locality.hpp"
#include "shapes/union_find.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

std::size_t VertexGraph::Hash::operator()(const Vec3& v) const {
  const auto mixed = [](std::size_t seed, double x) {
    return (seed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;  // −0 equals 0
  };
  const std::size_t hash = mixed(mixed(mixed(0, v.x), v.y), v.z);
  return hash ^ (hash >> 32);
}

std::array<Index, 3> VertexGraph::corners(Index triangle) {
  const Triangle t = mesh_.triangle(triangle);
  std::array<Index, 3> result{};
  for (int i = 0; i < 3; ++i) {
    const auto [found, is_new] = numbers_.try_emplace(t[i], static_cast<Index>(positions_.size()));
    if (is_new) positions_.push_back(t[i]);
    result[static_cast<std::size_t>(i)] = found->second;
  }
  return result;
}

std::vector<Index> VertexGraph::triangles_at(Index vertex) const {
  std::vector<Index> around;
  const Vec3 position = positions_[vertex];
  visit_triangles_near(mesh_, Aabb{position, position}, [&](Index triangle) {
    const Triangle t = mesh_.triangle(triangle);
    if (t[0] == position || t[1] == position || t[2] == position) around.push_back(triangle);
    return true;
  });
  return around;
}

Index triangle_of(const Contact& contact, ContactSide side) {
  return side == ContactSide::a ? contact.element_a : contact.element_b;
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

SurfaceWithin::SurfaceWithin(VertexGraph& graph, const PosedMesh& solid, std::span<const Contact> contacts,
                             ContactSide side)
    : graph_(graph) {
  collect(contacts, side);
  piece_of_vertex_.assign(graph.vertex_count(), none);
  for (const Index corner : inner_corners(solid))
    if (piece_of_vertex_[corner] == none) flood(corner);
}

void SurfaceWithin::collect(std::span<const Contact> contacts, ContactSide side) {
  std::vector<std::pair<Index, Index>> uses;
  for (Index i = 0; i < contacts.size(); ++i) uses.emplace_back(triangle_of(contacts[i], side), i);
  std::sort(uses.begin(), uses.end());
  for (const auto& [triangle, contact] : uses) {
    if (in_contact_.empty() || in_contact_.back().triangle != triangle)
      in_contact_.push_back({triangle, graph_.corners(triangle), {}, {}});
    in_contact_.back().contacts.push_back(contact);
    in_contact_.back().touched.add(contacts[contact], side);
  }
}

/// Corners of the triangles in contact. Two at the ends of an edge that nothing touches are on the same side.
std::vector<Index> SurfaceWithin::inner_corners(const PosedMesh& solid) const {
  std::vector<Index> corners;
  for (const TriangleInContact& one : in_contact_)
    for (const Index corner : one.corners) corners.push_back(corner);
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto place = [&](Index corner) {
    return static_cast<Index>(std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin());
  };
  UnionFind same_side(corners.size());
  for (const TriangleInContact& one : in_contact_) {
    if (!has_area(graph_.mesh().triangle(one.triangle))) continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (!one.touched.edges[i]) same_side.unite(place(one.corners[i]), place(one.corners[(i + 1) % 3]));
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

bool SurfaceWithin::has_contact(Index triangle) const {
  const auto found = std::lower_bound(in_contact_.begin(), in_contact_.end(), triangle,
                                      [](const TriangleInContact& one, Index t) { return one.triangle < t; });
  return found != in_contact_.end() && found->triangle == triangle;
}

/// False where it was there already.
bool SurfaceWithin::enter(Index vertex, Index piece) {
  piece_of_vertex_.resize(graph_.vertex_count(), none);
  if (piece_of_vertex_[vertex] != none) return false;
  piece_of_vertex_[vertex] = piece;
  return true;
}

void SurfaceWithin::flood(Index from) {
  const auto number = static_cast<Index>(pieces_.size());
  InnerPiece piece;
  std::vector<Index> waiting{from};
  static_cast<void>(enter(from, number));
  while (!waiting.empty()) {
    const Index vertex = waiting.back();
    waiting.pop_back();
    piece.vertices.push_back(graph_.position(vertex));
    for (const Index triangle : graph_.triangles_at(vertex)) {
      if (has_contact(triangle)) continue;
      const std::array<Index, 3> corners = graph_.corners(triangle);
      if (corners[0] == vertex) piece.triangles.push_back(triangle);
      for (const Index corner : corners)
        if (enter(corner, number)) waiting.push_back(corner);
    }
  }
  pieces_.push_back(std::move(piece));
}

}  // namespace toccata
