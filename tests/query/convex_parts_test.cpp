#include "toccata/query/convex_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "query/decomposition/part_concavity.hpp"
#include "support/data.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/signed_distance.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata::test {
namespace {

bool hull_holds(const ConvexHull& hull, const Vec3& point) {
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index h = topology.face_start[f];
    const auto corner = [&](Index i) { return hull.vertex(topology.origin[h + i]); };
    if (orient3d(corner(0), corner(1), corner(2), point) == Sign::positive) return false;
  }
  return true;
}

bool union_holds(const ConvexParts& parts, const Vec3& point) {
  return std::ranges::any_of(parts.parts, [&](const ConvexPart& part) {
    return part.hull.dimension() == 3 ? hull_holds(part.hull, point) : overlap(Model(part.hull), Point{point});
  });
}

/// By exact signs alone: no vertex is before a face.
void expect_convex(const ConvexHull& hull) {
  if (hull.dimension() < 3) return;
  for (Index v = 0; v < hull.vertex_count(); ++v) ASSERT_TRUE(hull_holds(hull, hull.vertex(v)));
}

void expect_contained(const ConvexParts& parts, const TriangleMesh& mesh, int samples) {
  for (const auto& t : mesh.triangles())
    for (const Index v : t) ASSERT_TRUE(union_holds(parts, mesh.vertices()[v])) << "vertex " << v;
  const Model solid(mesh);
  const MeshHealth health = inspect(mesh);
  Random random(1);
  for (int i = 0; i < samples; ++i) {
    const Vec3 point{random.between(health.lower.x, health.upper.x), random.between(health.lower.y, health.upper.y),
                     random.between(health.lower.z, health.upper.z)};
    if (locate(point, solid).side == Side::outside) continue;
    ASSERT_TRUE(union_holds(parts, point)) << point.x << ' ' << point.y << ' ' << point.z;
  }
}

ConvexParts checked(const TriangleMesh& mesh, const DecompositionOptions& options = {}, int samples = 500) {
  ConvexParts parts = decompose(mesh, options);
  EXPECT_GE(parts.parts.size(), 1U);
  EXPECT_LE(parts.parts.size(), options.max_parts);
  double sum = 0;
  for (const ConvexPart& part : parts.parts) {
    expect_convex(part.hull);
    EXPECT_LE(part.concavity_found, part.concavity);
    EXPECT_LE(part.concavity, parts.concavity);
    EXPECT_TRUE(std::ranges::is_sorted(part.faces));
    sum += part.volume;
  }
  EXPECT_NEAR(parts.hull_volume, sum, 1e-12 * sum);
  EXPECT_NEAR(parts.excess, parts.hull_volume - parts.mesh_volume, 1e-12 * sum);
  expect_contained(parts, mesh, samples);
  return parts;
}

/// A prism over a polygon in the plane z = 0, with sides up to z = 1.
TriangleMesh prism_over(const std::vector<Vec2>& outline) {
  PolygonMesh polygons;
  const auto n = static_cast<Index>(outline.size());
  for (const double z : {0.0, 1.0})
    for (const Vec2& p : outline) polygons.vertices.push_back({p.x, p.y, z});
  const auto close = [&] { polygons.first.push_back(static_cast<Index>(polygons.corners.size())); };
  for (Index i = n; i-- > 0;) polygons.corners.push_back(i);
  close();
  for (Index i = 0; i < n; ++i) polygons.corners.push_back(n + i);
  close();
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    polygons.corners.insert(polygons.corners.end(), {i, next, n + next, n + i});
    close();
  }
  return triangulate(polygons);
}

TriangleMesh l_prism() { return prism_over({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}); }
TriangleMesh cross_prism() {
  return prism_over({{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}});
}
TriangleMesh slotted_prism() { return prism_over({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {2, 1}, {2, 4}, {0, 4}}); }

void expect_exact_parts(const TriangleMesh& mesh, std::size_t count) {
  const ConvexParts parts = checked(mesh);
  EXPECT_EQ(parts.parts.size(), count);
  EXPECT_NEAR(parts.excess, 0, 1e-14 * parts.mesh_volume);
  EXPECT_EQ(parts.concavity, 0);
}

TEST(ConvexParts, OfAConvexSolidAreOne) {
  expect_exact_parts(box_between({0, 0, 0}, {1, 2, 3}), 1);
  expect_exact_parts(sphere_mesh(1, 2), 1);
}

TEST(ConvexParts, OfPrismsAreAsFewAsThereCanBe) {
  expect_exact_parts(l_prism(), 2);
  expect_exact_parts(cross_prism(), 3);
  expect_exact_parts(slotted_prism(), 3);
}

TEST(ConvexPartsSlow, ContainSolidsOfManyKinds) {
  for (const char* name : {"torus", "helix", "gear", "cavity-box", "tetrahedron"}) {
    SCOPED_TRACE(name);
    checked(generate_mesh(name), {.max_parts = 10});
  }
}

TEST(ConvexParts, ContainSeveralComponentsAndAvoidCavities) {
  const TriangleMesh two = joined({box_between({0, 0, 0}, {1, 1, 1}), box_between({5, 0, 0}, {6, 1, 1})});
  expect_exact_parts(two, 2);
}

TEST(ConvexParts, OfABoxWithACavityAreItsWalls) {
  const auto hollow = [](const Vec3& lower, const Vec3& upper) {
    return joined({box_between({0, 0, 0}, {6, 6, 6}), inverted(test::box_between(lower, upper))});
  };
  expect_exact_parts(hollow({2, 2, 2}, {4, 4, 4}), 6);
  expect_exact_parts(hollow({1, 2, 0.5}, {3, 3.5, 5}), 6);
  const ConvexParts thin = checked(hollow({0.25, 0.25, 0.25}, {5.75, 5.75, 5.75}), {.max_parts = 6});
  EXPECT_NEAR(thin.excess, 0, 1e-14 * thin.mesh_volume);
}

TEST(ConvexParts, OfAMeshThatCrossesItselfContainIt) {
  checked(joined({box_between({0, 0, 0}, {2, 2, 2}), box_between({1, 1, 1}, {3, 3, 3})}), {.max_parts = 6});
}

TEST(ConvexPartsSlow, ContainRealMeshes) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  for (const char* name : {"spot", "cow"}) {
    SCOPED_TRACE(name);
    checked(read_mesh(*data / "meshes" / (std::string(name) + ".obj")), {.max_parts = 8}, 2000);
  }
}

TEST(ConvexParts, OfAMeshInsideOutAreThoseOfTheMesh) {
  const ConvexParts parts = checked(inverted(l_prism()));
  EXPECT_EQ(parts.parts.size(), 2U);
  EXPECT_EQ(parts.mesh_volume, 5);
}

TEST(ConvexParts, AreTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = generate_mesh("helix");
  const ConvexParts one = decompose(mesh, {.max_parts = 8}), two = decompose(mesh, {.max_parts = 8, .threads = 2});
  ASSERT_EQ(one.parts.size(), two.parts.size());
  EXPECT_EQ(one.excess, two.excess);
  for (std::size_t i = 0; i < one.parts.size(); ++i) {
    ASSERT_EQ(one.parts[i].hull.vertex_count(), two.parts[i].hull.vertex_count());
    for (Index v = 0; v < one.parts[i].hull.vertex_count(); ++v)
      ASSERT_EQ(one.parts[i].hull.vertex(v), two.parts[i].hull.vertex(v));
    EXPECT_EQ(one.parts[i].concavity, two.parts[i].concavity);
    EXPECT_EQ(one.parts[i].faces, two.parts[i].faces);
  }
}

TEST(ConvexParts, AtAnyScaleAndPlaceContainTheSolid) {
  for (const double scale : {1e-150, 1e-9, 1e9, 1e100})
    for (const double far : {0.0, 1e6}) {
      SCOPED_TRACE(scale);
      const TriangleMesh prism = l_prism();
      std::vector<Vec3> vertices(prism.vertices().begin(), prism.vertices().end());
      for (Vec3& v : vertices) v = scale * (v + Vec3{far, far, -far});
      const ConvexParts parts = checked(prism.with_vertices(vertices));
      EXPECT_EQ(parts.parts.size(), 2U);
    }
}

/// Among some corners of the hull.
Vec3 point_within(const ConvexHull& hull, Random& random) {
  Vec3 point{};
  double left = 1;
  for (int i = 0; i < 4; ++i) {
    const double weight = i == 3 ? left : left * random.between(0, 1);
    point = point + weight * hull.vertex(static_cast<Index>(random.below(hull.vertex_count())));
    left -= weight;
  }
  return point;
}

TEST(ConvexParts, ConcavitiesBracketTheFarthestOfManyPoints) {
  const Model solid(generate_mesh("noise-sphere", {{"subdivisions", 3}}));
  const ConvexParts parts = decompose(solid, {.max_parts = 6});
  Random random(4);
  for (const ConvexPart& part : parts.parts) {
    EXPECT_GT(part.hull.topology().face_count(), 64U);
    double farthest = 0;
    for (int i = 0; i < 3000; ++i)
      farthest = std::max(farthest, signed_distance(point_within(part.hull, random), solid).lower);
    EXPECT_LE(farthest, part.concavity);
    EXPECT_LT(part.concavity, 0.25);
  }
}

TEST(ConvexParts, ThatStickOutByRoundingAreKnownToDoNoMore) {
  const Model solid(box_between({0, 0, 0}, {1, 1, 1}));
  const SolidFrame frame(inspect(solid.mesh()));
  const auto found = [&](double out) {
    const TriangleMesh larger = box_between({-out, -out, -out}, {1 + out, 1, 1});
    return ConcaveSolid(solid, frame).concavity_of(ConvexHull(larger.vertices()), 1e-3, std::nullopt);
  };
  EXPECT_EQ(found(0).upper, 0);
  EXPECT_GT(found(0x1p-52).upper, 0x1p-52);
  EXPECT_LT(found(0x1p-52).upper, 1e-8);
  EXPECT_GT(found(0.1).lower, 0.05);
  EXPECT_GE(found(0.1).upper, std::sqrt(0.03));
  EXPECT_LT(found(0.1).upper, 0.2);
}

TEST(ConvexParts, OfTinyAndHugeMeshesAreAsConcaveAsOfTheSameMeshScaled) {
  const TriangleMesh prism = l_prism();
  const auto bound = [&](int exponent) {
    std::vector<Vec3> vertices(prism.vertices().begin(), prism.vertices().end());
    for (Vec3& v : vertices) v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
    const Model solid(prism.with_vertices(vertices));
    const SolidFrame frame(inspect(solid.mesh()));
    const Concavity found =
        ConcaveSolid(solid, frame).concavity_of(ConvexHull(vertices), std::ldexp(0.5, exponent), std::nullopt);
    return std::ldexp(found.upper, -exponent);
  };
  const double plain = bound(0);
  EXPECT_GT(plain, 0.1);
  for (const int exponent : {-560, 520}) EXPECT_NEAR(bound(exponent), plain, 1e-9 * plain) << exponent;
}

TEST(ConvexParts, OfTinyAndHugeMeshesAreThoseOfTheSameMeshScaled) {
  const TriangleMesh prism = cross_prism();
  const ConvexParts plain = decompose(prism, {.max_parts = 2});
  for (const int exponent : {-560, 520}) {
    const auto scaled = [&](const Vec3& v) {
      return Vec3{std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
    };
    std::vector<Vec3> vertices;
    for (const Vec3& v : prism.vertices()) vertices.push_back(scaled(v));
    const ConvexParts parts = decompose(prism.with_vertices(vertices), {.max_parts = 2});
    EXPECT_EQ(parts.concavity, std::ldexp(plain.concavity, exponent));
    EXPECT_EQ(parts.mesh_volume, exponent < 0 ? 0 : HUGE_VAL);
    EXPECT_EQ(parts.excess, exponent < 0 ? 0 : HUGE_VAL);
    ASSERT_EQ(parts.parts.size(), plain.parts.size());
    for (std::size_t i = 0; i < parts.parts.size(); ++i) {
      const ConvexHull &hull = parts.parts[i].hull, &expected = plain.parts[i].hull;
      ASSERT_EQ(hull.vertex_count(), expected.vertex_count());
      for (Index v = 0; v < hull.vertex_count(); ++v) EXPECT_EQ(hull.vertex(v), scaled(expected.vertex(v)));
    }
  }
  EXPECT_GT(plain.concavity, 0.1);
}

TEST(ConvexParts, KeepSheetsOfNoVolume) {
  // A fin of two triangles back to back, in the plane in which the L is cut.
  const TriangleMesh fin({{1, 1, 0}, {1, 3, 3}, {1, 1, 3}}, {{0, 1, 2}, {0, 2, 1}});
  checked(joined({l_prism(), fin}));
  const ConvexParts flat = checked(fin);
  EXPECT_EQ(flat.parts.size(), 1U);
  EXPECT_EQ(flat.mesh_volume, 0);
}

TEST(ConvexParts, RefuseWhatIsNoSolidAndLimitsOutOfRange) {
  const TriangleMesh open({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  try {
    static_cast<void>(decompose(open));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("open"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("close its holes"), std::string::npos);
  }
  EXPECT_THROW(static_cast<void>(decompose(l_prism(), {.max_parts = 0})), Error);
  EXPECT_THROW(static_cast<void>(decompose(l_prism(), {.concavity = -1})), Error);
  EXPECT_THROW(static_cast<void>(decompose(l_prism(), {.concavity = std::nan("")})), Error);
  EXPECT_THROW(static_cast<void>(decompose(Model(Box{{1, 1, 1}}))), Error);
  EXPECT_THROW(static_cast<void>(decompose(TriangleMesh({}, {}))), Error);
  EXPECT_THROW(static_cast<void>(decompose(TriangleMesh({{0, 0, 0}, {std::nan(""), 0, 0}}, {{0, 1, 0}}))), Error);
}

}  // namespace
}  // namespace toccata::test
