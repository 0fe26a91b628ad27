#pragma once

// What OpenSubdiv makes of a cage.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "toccata/query/subdivision.hpp"

namespace toccata::test {

namespace osd = OpenSubdiv;

struct WeightedPoint {
  Vec3 at{};
  void Clear(void* = nullptr) { at = {}; }
  void AddWithWeight(const WeightedPoint& other, double weight) { at += weight * other.at; }
};

/// Points of a level, and where those come to lie in the limit.
struct PeerLevel {
  std::vector<WeightedPoint> points;
  std::vector<WeightedPoint> limits;
  std::vector<std::array<Index, 3>> triangles;  ///< of the level's faces
};

/// Arrays in the types that the peer reads.
struct PeerCage {
  PeerCage(const PolygonMesh& mesh, const CageFeatures& features) {
    for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f)
      counts.push_back(static_cast<int>(mesh.first[f + 1] - mesh.first[f]));
    for (const Index corner : mesh.corners) corners.push_back(static_cast<int>(corner));
    const auto weight = [](double sharpness) { return static_cast<float>(std::min(sharpness, sharp_for_ever)); };
    for (const CageCrease& crease : features.creases) {
      crease_ends.push_back(static_cast<int>(crease.first));
      crease_ends.push_back(static_cast<int>(crease.second));
      crease_weights.push_back(weight(crease.sharpness));
    }
    for (const CageCorner& corner : features.corners) {
      corner_vertices.push_back(static_cast<int>(corner.vertex));
      corner_weights.push_back(weight(corner.sharpness));
    }
    descriptor.numVertices = static_cast<int>(mesh.vertices.size());
    descriptor.numFaces = static_cast<int>(counts.size());
    descriptor.numVertsPerFace = counts.data();
    descriptor.vertIndicesPerFace = corners.data();
    descriptor.numCreases = static_cast<int>(crease_weights.size());
    descriptor.creaseVertexIndexPairs = crease_ends.data();
    descriptor.creaseWeights = crease_weights.data();
    descriptor.numCorners = static_cast<int>(corner_weights.size());
    descriptor.cornerVertexIndices = corner_vertices.data();
    descriptor.cornerWeights = corner_weights.data();
  }

  std::vector<int> counts, corners, crease_ends, corner_vertices;
  std::vector<float> crease_weights, corner_weights;
  osd::Far::TopologyDescriptor descriptor;
};

/// After so many uniform refinements. The cage need not be one of ours.
inline PeerLevel peer_level(const PolygonMesh& cage, SubdivisionScheme kind, const CageFeatures& features, int level) {
  const PeerCage peer(cage, features);
  using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
  osd::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(features.border == CageBorder::smooth
                                          ? osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                          : osd::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  const auto scheme = kind == SubdivisionScheme::loop ? osd::Sdc::SCHEME_LOOP : osd::Sdc::SCHEME_CATMARK;
  const std::unique_ptr<osd::Far::TopologyRefiner> refiner(
      Factory::Create(peer.descriptor, Factory::Options(scheme, options)));
  osd::Far::TopologyRefiner::UniformOptions uniform(level);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);

  PeerLevel found;
  for (const Vec3& v : cage.vertices) found.points.push_back({v});
  const osd::Far::PrimvarRefinerReal<double> points(*refiner);
  for (int i = 1; i <= level; ++i) {
    std::vector<WeightedPoint> finer(static_cast<std::size_t>(refiner->GetLevel(i).GetNumVertices()));
    WeightedPoint* destination = finer.data();
    points.Interpolate(i, found.points.data(), destination);
    found.points = std::move(finer);
  }
  found.limits.resize(found.points.size());
  WeightedPoint* limits = found.limits.data();
  points.Limit(found.points.data(), limits);
  const osd::Far::TopologyLevel& last = refiner->GetLevel(level);
  for (int f = 0; f < last.GetNumFaces(); ++f) {
    const auto corners = last.GetFaceVertices(f);
    for (int i = 2; i < corners.size(); ++i)
      found.triangles.push_back(
          {static_cast<Index>(corners[0]), static_cast<Index>(corners[i - 1]), static_cast<Index>(corners[i])});
  }
  return found;
}

inline PeerLevel peer_level(const SubdivisionCage& cage, int level) {
  return peer_level(cage.polygons(), cage.scheme(), cage.features(), level);
}

}  // namespace toccata::test
