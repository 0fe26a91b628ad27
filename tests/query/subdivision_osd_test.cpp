// Against OpenSubdiv, where it is installed: points of uniform refinement, and limit points.
#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "query/subdivision/level_mesh.hpp"
#include "query/subdivision_cages.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata::test {
namespace {

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
};

/// Arrays in the types that the peer reads.
struct PeerCage {
  explicit PeerCage(const SubdivisionCage& cage) {
    const PolygonMesh& mesh = cage.polygons();
    for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f)
      counts.push_back(static_cast<int>(mesh.first[f + 1] - mesh.first[f]));
    for (const Index corner : mesh.corners) corners.push_back(static_cast<int>(corner));
    const auto weight = [](double sharpness) { return static_cast<float>(std::min(sharpness, sharp_for_ever)); };
    for (const CageCrease& crease : cage.features().creases) {
      crease_ends.push_back(static_cast<int>(crease.first));
      crease_ends.push_back(static_cast<int>(crease.second));
      crease_weights.push_back(weight(crease.sharpness));
    }
    for (const CageCorner& corner : cage.features().corners) {
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

PeerLevel peer_level(const SubdivisionCage& cage, int level) {
  const PeerCage peer(cage);
  using Factory = osd::Far::TopologyRefinerFactory<osd::Far::TopologyDescriptor>;
  osd::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(cage.features().border == CageBorder::smooth
                                          ? osd::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                          : osd::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  const auto scheme = cage.scheme() == SubdivisionScheme::loop ? osd::Sdc::SCHEME_LOOP : osd::Sdc::SCHEME_CATMARK;
  const std::unique_ptr<osd::Far::TopologyRefiner> refiner(
      Factory::Create(peer.descriptor, Factory::Options(scheme, options)));
  osd::Far::TopologyRefiner::UniformOptions uniform(level);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);

  PeerLevel found;
  for (const Vec3& v : cage.polygons().vertices) found.points.push_back({v});
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
  return found;
}

double gap_to(const std::vector<Vec3>& points, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : points) least = std::min(least, length(p - q));
  return least;
}

TEST(SubdivisionOfOpenSubdiv, HasTheSamePointsAndLimitsWithinTheBound) {
  Random random(7);
  for (const CageCase& c : cage_cases(random))
    for (int features = 0; features < 3; ++features) {
      const SubdivisionCage cage(c.polygons, c.scheme,
                                 features == 0 ? CageFeatures{} : random_features(c.polygons, features == 2, random));
      LevelMesh mesh = cage_level(cage);
      for (int level = 0; level < 2; ++level) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
      const PeerLevel peer = peer_level(cage, 2);
      ASSERT_EQ(peer.points.size(), mesh.points.size());
      for (const WeightedPoint& p : peer.points) EXPECT_LT(gap_to(mesh.points, p.at), 1e-6);

      const SubdividedMesh refined = refine(cage, {.levels = 1});
      const Model model(refined.mesh);
      for (const WeightedPoint& p : peer_level(cage, 3).limits)
        EXPECT_LE(nearest_point(p.at, model).lower, refined.distance_to_limit + 1e-6);
    }
}

}  // namespace
}  // namespace toccata::test
