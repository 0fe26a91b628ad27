#pragma once

#include <array>
#include <cstdint>

#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// The parts of a triangle's convex hull, lowest dimension first: what Feature may name for it.
struct TriangleFeatures {
  std::uint8_t count = 0;
  std::array<Feature, 7> feature{};

  /// The hull itself: the feature whose relative interior is the triangle's.
  [[nodiscard]] Feature whole() const { return feature[count - 1U]; }
};

/// Exact, by the dimension of the hull: 7 for a triangle, 3 for a segment, 1 for a point.
[[nodiscard]] TriangleFeatures features_of(const Triangle& t);

constexpr Feature vertex_feature(int i) { return {FeatureKind::vertex, static_cast<std::uint8_t>(i)}; }
constexpr Feature edge_feature(int i) { return {FeatureKind::edge, static_cast<std::uint8_t>(i)}; }
constexpr Feature face_feature() { return {FeatureKind::face, 0}; }

/// The vertices in the closure of a feature, bit i for vertex i: unions of these sets are joins of features.
constexpr unsigned vertex_set(const Feature& f) {
  switch (f.kind) {
    case FeatureKind::vertex:
      return 1U << f.index;
    case FeatureKind::edge:
      return (1U << f.index) | (1U << ((f.index + 1U) % 3U));
    case FeatureKind::face:
      break;
  }
  return 7U;
}

/// The inverse of vertex_set, for a set that is not empty.
constexpr Feature feature_of_vertices(unsigned set) {
  constexpr std::array<Feature, 8> by_set{face_feature(),    vertex_feature(0), vertex_feature(1), edge_feature(0),
                                          vertex_feature(2), edge_feature(2),   edge_feature(1),   face_feature()};
  return by_set[set];
}

constexpr int next_vertex(int i) { return (i + 1) % 3; }
constexpr int previous_vertex(int i) { return (i + 2) % 3; }

/// The first and the second vertex of edge i.
constexpr const Vec3& edge_start(const Triangle& t, int i) { return t[i]; }
constexpr const Vec3& edge_end(const Triangle& t, int i) { return t[(i + 1) % 3]; }

}  // namespace toccata
