#pragma once

#include <optional>
#include <span>
#include <string>

#include "toccata/motion/deforming_mesh.hpp"

namespace toccata::test {

/// Which meshes are asked about.
struct DeformingPair {
  const DeformingMesh& a;
  const DeformingMesh& b;
  bool is_within_one = false;

  explicit DeformingPair(const DeformingMesh& mesh) : a(mesh), b(mesh), is_within_one(true) {}
  DeformingPair(const DeformingMesh& first, const DeformingMesh& second) : a(first), b(second) {}
};

/// Who says of two features alone when they meet: the oracle, or the library's question about two features.
enum class FeatureJudge { oracle, library };

/// What is wrong with answers, nothing where they are right; and how many pairs of features, with ways that come near
/// each other, were judged alone.
struct ImpactVerdict {
  std::optional<std::string> wrong;
  std::size_t judged = 0;
};

/// The verdict on `impacts` without a separation, by all pairs of features.
ImpactVerdict verdict_on_impacts(const DeformingPair& meshes, std::span<const MeshImpact> found, FeatureJudge judge);

/// What is wrong with `impacts` without a separation, judged by all pairs of features; nothing where it is right.
std::optional<std::string> wrong_impacts(const DeformingPair& meshes, std::span<const MeshImpact> found,
                                         FeatureJudge judge);

/// What is wrong with what was told of two features and a separation, judged by exact distances at some times.
std::optional<std::string> wrong_approach(const VertexFace& pair, const std::optional<MeshImpact>& told,
                                          double separation);
std::optional<std::string> wrong_approach(const EdgeEdge& pair, const std::optional<MeshImpact>& told,
                                          double separation);

}  // namespace toccata::test
