#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "query/region_checks.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

TEST(FacesInRegion, AgreeWithTheOracleAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    std::uint64_t seed = 0;
    for (const std::string& family : test::region_families())
      for (int i = 0; i < 8; ++i) {
        Random random(++seed);
        const test::RegionCase c = test::region_case(family, random);
        ASSERT_EQ(faces_in_region(c.region, Model(c.mesh), c.pose), test::exact_faces_in_region(c))
            << family << ", seed " << seed << ", " << name_of(level);
      }
  });
}

Index count_within(const Region& region, const Model& model, const Pose& pose = {}) {
  return static_cast<Index>(faces_in_region(region, model, pose).size());
}

TEST(FacesInRegion, TouchingCountsAndTheNextDoubleDoesNot) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  const double next = std::nextafter(1, 2);
  EXPECT_EQ(count_within(Aabb{{1, 0.25, 0.25}, {2, 0.5, 0.3}}, cube), 1U);
  EXPECT_EQ(count_within(Aabb{{next, 0.25, 0.25}, {2, 0.5, 0.3}}, cube), 0U);
  EXPECT_EQ(count_within(Ball{{2, 0.75, 0.5}, 1}, cube), 1U);
  EXPECT_EQ(count_within(Ball{{2, 0.75, 0.5}, std::nextafter(1, 0)}, cube), 0U);
  EXPECT_EQ(count_within(Ball{{1, 1, 1}, 0}, cube), faces_in_region(Aabb{{1, 1, 1}, {1, 1, 1}}, cube).size());
}

TEST(FacesInRegion, InsideASolidThereAreNone) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(count_within(Aabb{{0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}}, cube), 0U);
  EXPECT_EQ(count_within(Aabb{{-9, -9, -9}, {9, 9, 9}}, cube), 12U);
  EXPECT_EQ(count_within(Ball{{0.5, 0.5, 0.5}, 1e200}, cube), 12U);
}

TEST(FacesInRegion, AFaceOfTheFileIsToldOnce) {
  // Two quads and a triangle, of which the quads are two triangles each.
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {3, 0, 0}},
                          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {4, 6, 5}}, {0, 0, 1, 1, 2});
  const Model model(mesh);
  const auto found = faces_in_region(Aabb{{0.4, 0.4, -1}, {1.5, 0.6, 1}}, model);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[3], (FoundElement{3, 1}));
  EXPECT_EQ(distinct_faces(found), (std::vector<Index>{0, 1}));
  EXPECT_TRUE(distinct_faces({}).empty());
}

TEST(FacesInRegion, CountsTheElementsOfACompoundOn) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  const std::vector<CompoundPart> parts{{Sphere(1), Pose::translation(-5, 0, 0)},
                                        {cube.shape(), Pose::translation(5, 0, 0)},
                                        {HalfSpace({0, 0, -7}, {0, 0, 1}), {}}};
  const Model model((Compound(parts)));
  const auto all = faces_in_region(Ball{{0, 0, 0}, 100}, model);
  ASSERT_EQ(all.size(), 14U);
  for (Index i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], (FoundElement{i, i}));
  EXPECT_EQ(faces_in_region(Aabb{{-5, 0, 0}, {-5, 0, 0}}, model), (std::vector<FoundElement>{{0, 0}}));
}

TEST(FacesInRegion, ManyAtOnceAreTheSameAsOneByOne) {
  const Model knot(generate_mesh("torus-knot"));
  Random random(3);
  std::vector<RegionQuery> queries;
  for (int i = 0; i < 200; ++i) {
    const Pose pose{rotation_about({1, 2, 3}, 10.0 * i), {1, 2, 3}};
    const Vec3 p = test::some_point_of(knot.mesh(), pose, random);
    if (i % 2 == 0) queries.push_back({Ball{p, 0.1 * random.unit()}, pose});
    if (i % 2 != 0) queries.push_back({test::box_of_two(p, p + test::some_offset(random, 0.5)), pose});
  }
  const auto one_thread = faces_in_region_each(queries, knot, {.threads = 1});
  EXPECT_EQ(faces_in_region_each(queries, knot, {.threads = 3}), one_thread);
  Workspace workspace;
  std::size_t found = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto one = faces_in_region(queries[i].region, knot, queries[i].pose, workspace);
    ASSERT_EQ(std::vector<FoundElement>(one.begin(), one.end()), one_thread[i]) << i;
    found += one.size();
  }
  EXPECT_GT(found, queries.size());
}

TEST(FacesInRegion, BadInputIsRefused) {
  const Model cube(test::box_between({0, 0, 0}, {1, 1, 1}));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Region> wrong{Aabb{},
                                  Aabb{{0, 0, 1}, {1, 1, 0}},
                                  Aabb{{0, 0, 0}, {1, infinity, 1}},
                                  Aabb{{NAN, 0, 0}, {1, 1, 1}},
                                  Ball{},
                                  Ball{{0, 0, 0}, infinity},
                                  Ball{{0, NAN, 0}, 1}};
  for (const Region& region : wrong) EXPECT_THROW(static_cast<void>(faces_in_region(region, cube)), Error);
  Pose lost;
  lost.offset.y = infinity;
  EXPECT_THROW(static_cast<void>(faces_in_region(Ball{{0, 0, 0}, 1}, cube, lost)), Error);
  try {
    static_cast<void>(faces_in_region_each(std::vector<RegionQuery>{{Ball{{0, 0, 0}, 1}, {}}, {Aabb{}, {}}}, cube));
    FAIL() << "an empty box was taken";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("query 1: the box", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace toccata
