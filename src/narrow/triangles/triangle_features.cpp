#include "narrow/triangles/triangle_features.hpp"

#include "narrow/triangles/incidence.hpp"

namespace toccata {
namespace {

constexpr TriangleFeatures point_features{1, {vertex_feature(0)}};
constexpr TriangleFeatures face_features{7,
                                         {vertex_feature(0), vertex_feature(1), vertex_feature(2), edge_feature(0),
                                          edge_feature(1), edge_feature(2), face_feature()}};

/// The segment from the lexicographically least to the greatest vertex; of equal vertices the one of least index.
TriangleFeatures segment_features(const Triangle& t) {
  int least = 0, greatest = 0;
  for (int i = 1; i < 3; ++i) {
    if (lexicographically_less(t[i], t[least])) least = i;
    if (lexicographically_less(t[greatest], t[i])) greatest = i;
  }
  const Feature edge = feature_of_vertices((1U << least) | (1U << greatest));
  return {3, {vertex_feature(std::min(least, greatest)), vertex_feature(std::max(least, greatest)), edge}};
}

}  // namespace

TriangleFeatures features_of(const Triangle& t) {
  if (!collinear(t[0], t[1], t[2])) return face_features;
  return t[0] == t[1] && t[1] == t[2] ? point_features : segment_features(t);
}

}  // namespace toccata
