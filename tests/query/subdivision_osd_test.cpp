// Against OpenSubdiv, where it is installed: points of uniform refinement, and limit points.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "query/osd_level.hpp"
#include "query/subdivision/level_mesh.hpp"
#include "query/subdivision_cages.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata::test {
namespace {

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
        EXPECT_LE(nearest_point(p.at, model)->lower, refined.distance_to_limit + 1e-6);
    }
}

TEST(SubdivisionOfOpenSubdiv, KeepsAVertexWhereFacesMeetInItOnly) {
  for (const SubdivisionScheme scheme : {SubdivisionScheme::loop, SubdivisionScheme::catmull_clark}) {
    const PolygonMesh pinched = pinched_sheet(scheme == SubdivisionScheme::loop);
    const CageFeatures features{.creases = {{2, 3, 1.5}}};
    LevelMesh mesh = cage_level({pinched, scheme, features});
    for (int level = 0; level < 3; ++level) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
    const PeerLevel peer = peer_level(pinched, scheme, features, 3);
    ASSERT_EQ(peer.points.size() + 1, mesh.points.size());
    for (const WeightedPoint& p : peer.points) EXPECT_LT(gap_to(mesh.points, p.at), 1e-6);
  }
}

}  // namespace
}  // namespace toccata::test
