// METHODS B5: a convex solid made from half-spaces, against every three planes solved in rational numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

using HalfSpaces = std::vector<HalfSpace>;

oracle::HalfSpace exact_of(const HalfSpace& h) {
  const oracle::RationalPoint normal = oracle::exact(h.normal());
  return {normal, oracle::dot(normal, oracle::exact(h.point()))};
}

bool less(const Vec3& a, const Vec3& b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; }

/// The point of every three planes that is in all half-spaces, rounded; sorted, each once.
std::vector<Vec3> vertices_by_triples(const HalfSpaces& half_spaces) {
  std::vector<oracle::HalfSpace> all;
  for (const HalfSpace& h : half_spaces) all.push_back(exact_of(h));
  std::vector<Vec3> found;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      for (std::size_t k = j + 1; k < all.size(); ++k) {
        const auto &a = all[i], &b = all[j], &c = all[k];
        const oracle::Rational determinant = oracle::dot(a.normal, oracle::cross(b.normal, c.normal));
        if (determinant == 0) continue;
        const oracle::RationalPoint p = (1 / determinant) * (a.offset * oracle::cross(b.normal, c.normal) +
                                                             b.offset * oracle::cross(c.normal, a.normal) +
                                                             c.offset * oracle::cross(a.normal, b.normal));
        if (std::all_of(all.begin(), all.end(), [&](const auto& h) { return oracle::dot(h.normal, p) <= h.offset; }))
          found.push_back(oracle::rounded(p));
      }
  std::sort(found.begin(), found.end(), less);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<Vec3> vertices_of(const ConvexHull& hull) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  std::sort(vertices.begin(), vertices.end(), less);
  return vertices;
}

HalfSpaces cube(double half_edge) {
  HalfSpaces all;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3 normal;
      normal[axis] = side;
      all.emplace_back(half_edge * normal, normal);
    }
  return all;
}

std::string refusal_of(const HalfSpaces& half_spaces) {
  try {
    static_cast<void>(hull_of_half_spaces(half_spaces));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The numbers in "half-spaces 1, 4, 7 have".
std::vector<std::size_t> numbers_in(const std::string& text) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (std::isdigit(static_cast<unsigned char>(text[i])) != 0) {
      std::size_t length = 0;
      numbers.push_back(std::stoul(text.substr(i), &length));
      i += length;
    }
  return numbers;
}

double whole(Random& random, int most) {
  return static_cast<double>(random.below(2 * static_cast<std::uint64_t>(most) + 1)) - most;
}

/// grid: small whole numbers, many planes through one vertex; ball: about the unit ball; far: the same from afar;
/// needles: normals nearly in one plane.
HalfSpaces random_half_spaces(const std::string& family, Random& random, std::size_t count) {
  HalfSpaces all = cube(family == "far" ? 0x1p40 : 4);
  while (all.size() < count) {
    Vec3 normal{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    Vec3 point = normal;
    if (family == "grid") normal = {whole(random, 2), whole(random, 2), whole(random, 2)};
    if (family == "grid") point = normal;
    if (family == "far") point = point + Vec3{0x1p30, 3, -7};
    if (family == "needles") normal.z *= 1e-7;
    if (normal == Vec3{}) continue;
    all.emplace_back(point, normal);
  }
  return all;
}

TEST(HullOfHalfSpaces, OfSixIsACube) {
  const ConvexHull hull = hull_of_half_spaces(cube(0.5));
  EXPECT_EQ(hull.vertex_count(), 8U);
  EXPECT_EQ(hull.topology().face_count(), 6U);
  for (const Vec3& v : vertices_of(hull))
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::abs(v[axis]), 0.5);
}

TEST(HullOfHalfSpaces, HasTheVerticesOfEveryThreePlanes) {
  for (const std::string family : {"grid", "ball", "far", "needles"})
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const HalfSpaces all = random_half_spaces(family, random, 12);
      const std::vector<Vec3> expected = vertices_by_triples(all);
      ASSERT_GE(expected.size(), 4U);
      EXPECT_EQ(vertices_of(hull_of_half_spaces(all)), vertices_of(ConvexHull(expected)));
    }
}

TEST(HullOfHalfSpaces, OrderAndRepetitionsDoNotShow) {
  Random random(5);
  HalfSpaces all = random_half_spaces("grid", random, 30);
  const ConvexHull hull = hull_of_half_spaces(all);
  std::reverse(all.begin(), all.end());
  all.insert(all.end(), all.begin(), all.begin() + 10);
  all.emplace_back(Vec3{100, 0, 0}, Vec3{2, 1, 0});  // adds nothing
  const ConvexHull again = hull_of_half_spaces(all);
  ASSERT_EQ(again.vertex_count(), hull.vertex_count());
  for (Index i = 0; i < hull.vertex_count(); ++i) EXPECT_EQ(again.vertex(i), hull.vertex(i));
}

/// About the unit ball, at this distance from its centre.
HalfSpaces around_ball(std::size_t count, double distance) {
  Random random(3);
  HalfSpaces all;
  while (all.size() < count) {
    const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    all.emplace_back((distance / std::sqrt(dot(p, p))) * p, p);
  }
  return all;
}

/// A vertex for every face but two, and again.
TEST(HullOfHalfSpaces, OfManyHasAsManyVerticesAsEulerSays) {
  EXPECT_EQ(hull_of_half_spaces(around_ball(100, 1)).vertex_count(), 2U * 100 - 4);
}

TEST(HullOfHalfSpaces, ThatCutNothingOffOrAreThereOftenDoNoHarm) {
  HalfSpaces all = cube(0.5);
  const HalfSpaces beyond = around_ball(200, 2);
  all.insert(all.end(), beyond.begin(), beyond.end());
  for (int i = 0; i < 1000; ++i) all.push_back(all[static_cast<std::size_t>(i % 6)]);
  EXPECT_EQ(hull_of_half_spaces(all).vertex_count(), 8U);
}

TEST(HullOfHalfSpaces, IsGivenUpWhereItTakesTooManyComparisons) {
  const HalfSpaces many = around_ball(60, 1);
  try {
    static_cast<void>(hull_of_half_spaces(many, 5000));
    ADD_FAILURE() << "it was not given up";
  } catch (const Error& error) {
    EXPECT_TRUE(has(error.what(), "more than 5000 comparisons")) << error.what();
    EXPECT_TRUE(has(error.what(), "of the 60 half-spaces, taken in a mixed order, have ")) << error.what();
    // So many vertices as that many half-spaces about a ball have, or fewer where they leave it open.
    const std::vector<std::size_t> told = numbers_in(error.what());
    ASSERT_EQ(told.size(), 4U) << error.what();
    EXPECT_LT(told[0], told[1]);
    EXPECT_LE(told[2], 2 * told[0] - 4);
  }
  EXPECT_EQ(hull_of_half_spaces(many, 1'000'000).vertex_count(), 2U * 60 - 4);
  // What has no point in common is found before, and named.
  HalfSpaces empty = many;
  empty.emplace_back(Vec3{5, 0, 0}, Vec3{-1, 0, 0});
  EXPECT_TRUE(has(refusal_of(empty), "no point in common")) << refusal_of(empty);
}

/// Also where the search for those that are named would begin when the first has taken nearly all of them.
TEST(HullOfHalfSpaces, TakesNoMoreComparisonsInAllThanAreAllowed) {
  HalfSpaces empty = around_ball(25, 1);
  empty.emplace_back(Vec3{5, 0, 0}, Vec3{-1, 0, 0});
  const auto refusal = [&](std::uint64_t most) -> std::string {
    try {
      static_cast<void>(hull_of_half_spaces(empty, most));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  std::uint64_t too_few = 0, enough = 100'000;
  while (enough - too_few > 1) {
    const std::uint64_t middle = (too_few + enough) / 2;
    (has(refusal(middle), "no point in common") ? enough : too_few) = middle;
  }
  EXPECT_TRUE(has(refusal(too_few), "to find those of all")) << refusal(too_few);
  EXPECT_TRUE(has(refusal(enough), "it would take more than " + std::to_string(enough) + " comparisons to tell a few"))
      << refusal(enough);
  EXPECT_EQ(numbers_in(refusal(100 * enough)), numbers_in(refusal_of(empty)));
}

/// A quarter of the random ones have no common point. Those that are named have none, and with one less they have.
TEST(HullOfHalfSpaces, WithoutACommonPointNamesAtMostFour) {
  int empty = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    HalfSpaces all = cube(8);
    while (all.size() < 11) {
      const Vec3 normal{whole(random, 2), whole(random, 2), whole(random, 2)};
      if (normal != Vec3{}) all.emplace_back(Vec3{whole(random, 3), whole(random, 3), whole(random, 3)}, normal);
    }
    const bool is_empty = vertices_by_triples(all).empty();
    const std::string refusal = refusal_of(all);
    EXPECT_EQ(has(refusal, "no point in common"), is_empty) << refusal;
    if (!is_empty) continue;
    ++empty;
    const std::vector<std::size_t> named = numbers_in(refusal);
    ASSERT_GE(named.size(), 2U);
    ASSERT_LE(named.size(), 4U);
    for (std::size_t left_out = 0; left_out <= named.size(); ++left_out) {
      HalfSpaces few = cube(1e4);  // so that there are vertices, which the oracle looks for
      for (std::size_t i = 0; i < named.size(); ++i)
        if (i != left_out) few.push_back(all[named[i]]);
      EXPECT_EQ(vertices_by_triples(few).empty(), left_out == named.size()) << refusal << ", without " << left_out;
    }
  }
  EXPECT_GT(empty, 3);
}

TEST(HullOfHalfSpaces, WithoutEndTellsADirection) {
  HalfSpaces open = cube(1);
  open.pop_back();
  EXPECT_TRUE(has(refusal_of(open), "without end in the direction (0, 0, 1)")) << refusal_of(open);
  // Normals in one plane, and on one line: prisms and slabs.
  const HalfSpaces sides = cube(1);
  EXPECT_TRUE(has(refusal_of({sides[0], sides[1], sides[2], sides[3]}), "without end in the direction (0, 0, "));
  EXPECT_TRUE(has(refusal_of({sides[0], sides[1], sides[0], sides[1]}), "without end in the direction (0, "));
  const HalfSpace beyond({3, 0, 0}, {-1, 0, 0});
  EXPECT_TRUE(has(refusal_of({sides[0], sides[1], sides[2], beyond}), "half-spaces 1, 3 have no point"));
  EXPECT_TRUE(has(refusal_of({sides[0], sides[1], sides[1], sides[0], beyond}), "have no point in common"));
  EXPECT_TRUE(has(refusal_of({sides[0], sides[1], sides[2]}), "give at least four"));
  EXPECT_TRUE(has(refusal_of({}), "give at least four"));
}

TEST(HullOfHalfSpaces, ThatIsFlatNamesItsPlanes) {
  HalfSpaces flat = cube(1);
  flat.emplace_back(Vec3{1, 0, 0}, Vec3{-2, 0, 0});
  EXPECT_TRUE(has(refusal_of(flat), "planes of half-spaces 1, 6")) << refusal_of(flat);
  flat.emplace_back(Vec3{0, 5, 0}, Vec3{0, -1, 0});  // and nothing of it is left
  EXPECT_TRUE(has(refusal_of(flat), "half-spaces 3, 7 have no point in common")) << refusal_of(flat);
}

/// Four planes through one point, whose coordinates are no doubles, with normals around it: all that they have in
/// common is that point. So it is flat, and not empty.
TEST(HullOfHalfSpaces, ThatIsOnePointBetweenDoublesIsFlat) {
  Random random(6);
  int made = 0;
  while (made < 40) {
    std::array<Vec3, 3> normals;
    Vec3 sum;
    double offset = 0;
    HalfSpaces all;
    for (Vec3& normal : normals) {
      normal = {whole(random, 9), whole(random, 9), whole(random, 9)};
      if (&normal == &normals[2]) normal.x = 1 - sum.x;
      const Vec3 point{whole(random, 9), whole(random, 9), whole(random, 9)};
      sum += normal;
      offset += dot(normal, point);
      if (normal != Vec3{}) all.emplace_back(point, normal);
    }
    if (dot(normals[0], cross(normals[1], normals[2])) == 0) continue;
    all.emplace_back(Vec3{offset, 0, 0}, -sum);  // the sum's x is 1
    ASSERT_TRUE(has(refusal_of(all), "planes of half-spaces 0, 1, 2, 3")) << refusal_of(all);
    ++made;
  }
}

/// A wedge between x = 1 and a plane that leaves it by 2^-60 at the far end: no double lies between.
TEST(HullOfHalfSpaces, ThatIsThinnerThanDoublesIsRefused) {
  HalfSpaces thin = cube(1);
  thin.emplace_back(Vec3{1, 0, 0}, Vec3{-1, -0x1p-60, 0});
  EXPECT_TRUE(has(refusal_of(thin), "thinner than doubles")) << refusal_of(thin);
  HalfSpaces huge = cube(1e308);
  huge.emplace_back(Vec3{1e308, 0, 0}, Vec3{1, 0.5, 0});
  EXPECT_EQ(refusal_of(huge), "");
}

/// A corner is beyond the first plane by less than half a unit of the sum that tells its side, which is rounded to
/// minus one.
TEST(HullOfHalfSpaces, HasNoCornerThatOnlyRoundingTakesForOneInside) {
  const Vec3 corner{0x1.ef8bbf2620fdap-1, 0x1.82528fd60b9ccp-11, 0x1.4c75e1afdeb58p-5};
  HalfSpaces sides{{Vec3{0, 0, 0x1.98f2028b04ed5p-1}, Vec3{0x1.90aa5c04dbaf0p-1, 1, 1}}};
  ASSERT_GT(oracle::height_above(exact_of(sides.front()), oracle::exact(corner)), 0);
  for (const double side : {-1.0, 1.0})
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 along;
      along[axis] = side;
      sides.emplace_back(side < 0 ? Vec3{} : corner, along);
    }
  const ConvexHull hull = hull_of_half_spaces(sides);
  EXPECT_EQ(hull.vertex_count(), 10);
  for (Index v = 0; v < hull.vertex_count(); ++v) EXPECT_NE(hull.vertex(v), corner);
}

}  // namespace
}  // namespace toccata
