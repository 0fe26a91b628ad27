// The rules of refinement against rationals, and the bounds against what levels that follow do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/subdivision.hpp"
#include "query/subdivision/limit_bound.hpp"
#include "query/subdivision_cages.hpp"
#include "query/subdivision_descent.hpp"

namespace toccata::test {
namespace {

oracle::RationalCage exact_cage(const LevelMesh& mesh) {
  oracle::RationalCage cage;
  cage.is_loop = mesh.scheme == SubdivisionScheme::loop;
  for (const Vec3& p : mesh.points) cage.points.push_back(oracle::exact(p));
  for (Index f = 0; f < mesh.face_count(); ++f) cage.faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  for (const LevelEdge& edge : mesh.edges)
    if (edge.sharpness > 0)
      cage.creases[std::minmax(edge.ends[0], edge.ends[1])] = oracle::exact(std::min(edge.sharpness, sharp_for_ever));
  for (const double s : mesh.vertex_sharpness) cage.corners.push_back(oracle::exact(std::min(s, sharp_for_ever)));
  return cage;
}

bool is_within(const Vec3& point, const oracle::RationalPoint& exact, double rounding) {
  const oracle::RationalPoint off = oracle::exact(point) - exact;
  const oracle::Rational most = oracle::exact(rounding);
  return abs(off.x) <= most && abs(off.y) <= most && abs(off.z) <= most;
}

void expect_the_rules_of_rationals(const SubdivisionCage& cage, int levels) {
  LevelMesh mesh = cage_level(cage);
  oracle::RationalCage exact = exact_cage(mesh);
  for (int level = 0; level < levels; ++level) {
    mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
    exact = oracle::refined(exact);
    ASSERT_EQ(mesh.face_count(), exact.faces.size());
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (std::size_t i = 0; i < exact.faces[f].size(); ++i)
        ASSERT_TRUE(is_within(mesh.points[mesh.face(f)[i]], exact.points[exact.faces[f][i]], mesh.rounding))
            << "level " << mesh.level << ", face " << f << ", corner " << i;
  }
}

TEST(RefinementRules, AreThoseOfRationals) {
  Random random(1);
  for (const CageCase& c : cage_cases(random))
    for (const bool for_ever : {false, true})
      expect_the_rules_of_rationals({c.polygons, c.scheme, random_features(c.polygons, for_ever, random)}, 1);
  const PolygonMesh sheet = shaken(sheet_cage(1, false), 0.3, random);
  expect_the_rules_of_rationals({sheet, SubdivisionScheme::catmull_clark, random_features(sheet, false, random)}, 3);
  const PolygonMesh pyramid = shaken(bipyramid_cage(3), 0.3, random);
  expect_the_rules_of_rationals({pyramid, SubdivisionScheme::loop, random_features(pyramid, false, random)}, 3);
}

/// The least and the greatest of what is moved in so many levels over the bound.
std::array<double, 2> expect_bounds_hold(const LevelMesh& mesh, int levels) {
  LimitBounds bounds(mesh);
  Descent descent(mesh);
  std::array<double, 2> shares{1, 0};
  for (int level = 0; level < levels; ++level) {
    descent.descend();
    const std::vector<double> moved = descent.moved(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const double share = moved[f] / bounds.of(f).to_limit;
      EXPECT_LE(share, 1) << "face " << f << " of level " << mesh.level;
      if (level + 1 == levels) shares = {std::min(shares[0], share), std::max(shares[1], share)};
    }
  }
  return shares;
}

TEST(LimitBounds, HoldWhatLaterLevelsMove) {
  Random random(2);
  for (const CageCase& c : cage_cases(random))
    for (int features = 0; features < 3; ++features) {
      const CageFeatures some = features == 0 ? CageFeatures{} : random_features(c.polygons, features == 2, random);
      LevelMesh mesh = first_level({c.polygons, c.scheme, some});
      expect_bounds_hold(mesh, 2);
      expect_bounds_hold(subdivided(mesh, std::vector<char>(mesh.face_count(), 1)), 1);
    }
}

/// The greatest of what grew in a level over what the growth of the face allows, and likewise of points that moved.
std::array<double, 2> expect_growth_holds(LevelMesh mesh) {
  const LevelMesh finer = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
  LimitBounds before(mesh), after(finer);
  const auto product = [](const SecondDifferences& a, const SecondDifferences& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  std::array<double, 2> most{};
  Descent descent(mesh);
  descent.descend();
  const std::vector<double> moved = descent.moved(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto around = before.differences_around(f);
    if (!around.is_settled) continue;
    most[1] = std::max(most[1], moved[f] / product(around.growth.shift, around.differences));
    for (Index child = 4 * f; child < 4 * f + 4; ++child) {
      const SecondDifferences grown = after.differences_around(child).differences;
      for (std::size_t i = 0; i < 3; ++i)
        most[0] = std::max(most[0], (grown[i] - 1e-12) / (product(around.growth.rows[i], around.differences) + 1e-300));
    }
  }
  EXPECT_LE(most[0], 1 + 1e-9);
  EXPECT_LE(most[1], 1 + 1e-9);
  return most;
}

/// Coordinates of −1, 0 and 1 at random come near the signs that grow most.
TEST(LimitBounds, DifferencesGrowByNoMoreThanTheMatrix) {
  Random random(8);
  std::array<double, 2> most{};
  for (int round = 0; round < 4; ++round)
    for (const CageCase& c : cage_cases(random)) {
      PolygonMesh signs = c.polygons;
      for (Vec3& v : signs.vertices) v = {double(random.below(3)) - 1, 0, 0};
      const CageFeatures features = round % 2 == 0 ? CageFeatures{} : random_features(signs, true, random);
      LevelMesh mesh = first_level({signs, c.scheme, features});
      for (Vec3& v : mesh.points) v = {double(random.below(3)) - 1, 0, 0};
      const std::array<double, 2> found = expect_growth_holds(mesh);
      const LevelMesh finer = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
      expect_growth_holds(finer);
      most = {std::max(most[0], found[0]), std::max(most[1], found[1])};
    }
  EXPECT_GT(most[0], 0.5);
  EXPECT_GT(most[1], 0.5);
}

TEST(LimitBounds, OfRegularFacesAreTwoToTenTimesWhatIsMoved) {
  for (const SubdivisionScheme scheme : {SubdivisionScheme::loop, SubdivisionScheme::catmull_clark}) {
    const SubdivisionCage torus(torus_cage(8, 6, scheme == SubdivisionScheme::loop), scheme);
    const std::array<double, 2> shares = expect_bounds_hold(first_level(torus), 3);
    EXPECT_GT(shares[0], 1.0 / 10) << (scheme == SubdivisionScheme::loop ? "Loop" : "Catmull–Clark");
    EXPECT_GT(shares[1], 1.0 / 5) << (scheme == SubdivisionScheme::loop ? "Loop" : "Catmull–Clark");
  }
}

TEST(LimitBounds, FallByAQuarterEachLevelWhereAllIsRegularAndElseByHalf) {
  const auto greatest = [](const LevelMesh& mesh) {
    LimitBounds bounds(mesh);
    double most = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) most = std::max(most, bounds.of(f).to_limit);
    return most;
  };
  const auto fall = [&](const SubdivisionCage& cage) {
    LevelMesh mesh = first_level(cage);
    for (int i = 0; i < 2; ++i) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
    return greatest(subdivided(mesh, std::vector<char>(mesh.face_count(), 1))) / greatest(mesh);
  };
  EXPECT_LT(fall({torus_cage(5, 4, true), SubdivisionScheme::loop}), 0.3);
  EXPECT_LT(fall({torus_cage(5, 4, false), SubdivisionScheme::catmull_clark}), 0.3);
  EXPECT_LT(fall({cube_cage(), SubdivisionScheme::catmull_clark}), 0.75);
  EXPECT_LT(fall({bipyramid_cage(5), SubdivisionScheme::loop}), 0.75);
}

// All sums of two coordinates round to 2, so all differences to 0; a pole moves by Loop's sixteenth of 2⁻⁵².
TEST(LimitBounds, CountWhatRoundingHidesOfDifferences) {
  PolygonMesh points = bipyramid_cage(6);
  for (Vec3& v : points.vertices) v = {1, 0, 0};
  points.vertices[2].x = 1 + 0x1p-52;
  const LevelMesh mesh = first_level({points, SubdivisionScheme::loop});
  const oracle::RationalCage exact = oracle::refined(exact_cage(mesh));
  EXPECT_EQ(exact.points[0].x, oracle::exact(1) + oracle::exact(0x1p-56));
  LimitBounds bounds(mesh);
  for (Index f = 0; f < mesh.face_count(); ++f) EXPECT_GE(bounds.of(f).to_limit, 0x1p-56);
}

TEST(DifferenceGrowth, ShrinksAtEveryValence) {
  const SecondDifferences one{1, 1, 1};
  for (Index n = 3; n < 2000; n += n < 40 ? 1 : 97)
    for (const SubdivisionScheme scheme : {SubdivisionScheme::loop, SubdivisionScheme::catmull_clark}) {
      DifferenceGrowth growth = growth_at_new_vertices(scheme, false);
      growth.include(growth_at(scheme, {.rule = VertexRule::smooth, .valence = n}));
      EXPECT_LT(moved_by_all_levels(growth, one), 40) << n;
    }
  DifferenceGrowth of_two = growth_at_new_vertices(SubdivisionScheme::catmull_clark, false);
  of_two.include(growth_at(SubdivisionScheme::catmull_clark, {.rule = VertexRule::smooth, .valence = 2}));
  EXPECT_LT(moved_by_all_levels(of_two, one), 40);
}

}  // namespace
}  // namespace toccata::test
