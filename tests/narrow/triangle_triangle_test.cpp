#include "toccata/narrow/triangle_triangle.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "narrow/triangles/feature_intersection.hpp"

namespace toccata {
namespace {

std::string to_text(const Feature& f) {
  if (f.kind == FeatureKind::face) return "f";
  return (f.kind == FeatureKind::vertex ? "v" : "e") + std::to_string(f.index);
}

/// For example "segment crossing on f/f: e0/f e1/f", features of a first.
std::string to_text(const Intersection& m) {
  static const std::vector<std::string> kinds{"none", "point", "segment", "polygon"};
  std::string text = kinds[static_cast<std::size_t>(m.kind)];
  if (m.coplanar) text += " coplanar";
  if (m.crossing) text += " crossing";
  if (m.count == 0) return text;
  text += " on " + to_text(m.on_a) + "/" + to_text(m.on_b) + ":";
  for (std::size_t i = 0; i < m.count; ++i) text += " " + to_text(m.points[i].on_a) + "/" + to_text(m.points[i].on_b);
  return text;
}

/// A triangle that meets the right triangle below in a known way.
struct KnownCase {
  std::string name;
  Triangle b;
  std::string expected;
};

void PrintTo(const KnownCase& c, std::ostream* out) { *out << c.name; }

const Triangle right_triangle{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}};

const std::vector<KnownCase> known_cases{
    // Nothing.
    {"above", {{{{0, 0, 1}, {4, 0, 1}, {0, 4, 2}}}}, "none"},
    {"parallel", {{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}}}, "none"},
    {"through the plane beside the triangle", {{{{3, 3, -1}, {3, 3, 1}, {5, 5, 0}}}}, "none"},
    {"with a vertex in the plane beside the triangle", {{{{3, 3, 0}, {3, 3, 1}, {5, 5, 1}}}}, "none"},
    {"beside in the plane", {{{{3, 3, 0}, {5, 3, 0}, {3, 5, 0}}}}, "none coplanar"},
    {"point beside in the plane", {{{{3, 3, 0}, {3, 3, 0}, {3, 3, 0}}}}, "none coplanar"},
    {"point above", {{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}}, "none"},
    {"segment above", {{{{1, 1, 1}, {1, 1, 2}, {1, 1, 3}}}}, "none"},
    {"segment beside on the line of an edge", {{{{5, 0, 0}, {6, 0, 0}, {7, 0, 0}}}}, "none coplanar"},

    // One point, in different planes.
    {"vertex on vertex", {{{{0, 0, 0}, {-1, 0, 1}, {0, -1, 1}}}}, "point on v0/v0: v0/v0"},
    {"vertex on edge", {{{{1, 0, 1}, {2, 0, 0}, {2, 1, 1}}}}, "point on e0/v1: e0/v1"},
    {"vertex on face", {{{{1, 1, 1}, {2, 1, 1}, {1, 1, 0}}}}, "point on f/v2: f/v2"},
    {"edge on vertex", {{{{-1, 0, -1}, {1, 0, 1}, {-2, 0, 1}}}}, "point on v0/e0: v0/e0"},
    {"edge across edge", {{{{2, 2, -1}, {2, 2, 1}, {4, 4, 0}}}}, "point on e1/e0: e1/e0"},
    {"face on vertex", {{{{-1, 1, -1}, {1, -1, -1}, {0, 0, 3}}}}, "point on v0/f: v0/f"},

    // One point, without area.
    {"point on vertex", {{{{4, 0, 0}, {4, 0, 0}, {4, 0, 0}}}}, "point coplanar on v1/v0: v1/v0"},
    {"point on edge", {{{{2, 2, 0}, {2, 2, 0}, {2, 2, 0}}}}, "point coplanar on e1/v0: e1/v0"},
    {"point on face", {{{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}}, "point coplanar on f/v0: f/v0"},
    {"segment through the face", {{{{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}}}, "point crossing on f/e0: f/e0"},
    {"segment through the face at its middle vertex",
     {{{{1, 1, -1}, {1, 1, 0}, {1, 1, 1}}}},
     "point crossing on f/e2: f/e2"},
    {"segment standing on the face", {{{{1, 1, 0}, {1, 1, 0}, {1, 1, 1}}}}, "point on f/v0: f/v0"},
    {"segment through an edge", {{{{0, 1, -1}, {0, 1, 1}, {0, 1, -1}}}}, "point on e2/e0: e2/e0"},
    {"segment through a vertex", {{{{0, 4, -1}, {0, 4, 3}, {0, 4, 1}}}}, "point on v2/e0: v2/e0"},
    {"segment in the plane on a vertex", {{{{-1, 1, 0}, {1, -1, 0}, {1, -1, 0}}}}, "point coplanar on v0/e0: v0/e0"},

    // One point, in one plane.
    {"vertex on vertex in the plane", {{{{4, 0, 0}, {6, 0, 0}, {6, 2, 0}}}}, "point coplanar on v1/v0: v1/v0"},
    {"vertex on edge in the plane", {{{{2, 2, 0}, {4, 2, 0}, {4, 4, 0}}}}, "point coplanar on e1/v0: e1/v0"},
    {"edge on vertex in the plane", {{{{-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}}}}, "point coplanar on v0/e0: v0/e0"},

    // A segment, in different planes.
    {"a crosses b", {{{{1, 1, -1}, {1, 1, 1}, {9, 1, 0}}}}, "segment crossing on f/f: e1/f f/e0"},
    {"b passes through a", {{{{1, 1, -1}, {1, 1, 1}, {2, 1, 0}}}}, "segment crossing on f/f: f/v2 f/e0"},
    {"a passes through b", {{{{-9, 1, -9}, {-9, 1, 9}, {30, 1, 0}}}}, "segment crossing on f/f: e1/f e2/f"},
    {"from vertex to edge", {{{{0, 0, -1}, {0, 0, 1}, {4, 4, 0}}}}, "segment crossing on f/f: v0/e0 e1/f"},
    {"edge on the face", {{{{1, 1, 0}, {2, 1, 0}, {1, 1, 1}}}}, "segment on f/e0: f/v0 f/v1"},
    {"edge across the face", {{{{-1, 1, 0}, {9, 1, 0}, {1, 1, 1}}}}, "segment on f/e0: e1/e0 e2/e0"},
    {"shared edge", {{{{4, 0, 0}, {0, 0, 0}, {0, 0, 4}}}}, "segment on e0/e0: v0/v1 v1/v0"},
    {"edge inside edge", {{{{1, 0, 0}, {3, 0, 0}, {0, 0, 4}}}}, "segment on e0/e0: e0/v0 e0/v1"},
    {"edges overlap", {{{{3, 0, 0}, {5, 0, 0}, {0, 0, 4}}}}, "segment on e0/e0: v1/e0 e0/v0"},
    {"edge through the other face", {{{{1, 0, -1}, {1, 0, 1}, {9, 0, 0}}}}, "segment on e0/f: v1/f e0/e0"},

    // A segment, without area or in one plane.
    {"segment in the face", {{{{1, 1, 0}, {2, 1, 0}, {1.5, 1, 0}}}}, "segment coplanar on f/e0: f/v0 f/v1"},
    {"segment across the face", {{{{-1, 1, 0}, {2, 1, 0}, {9, 1, 0}}}}, "segment coplanar on f/e2: e1/e2 e2/e2"},
    {"segment along an edge", {{{{-1, 0, 0}, {-1, 0, 0}, {2, 0, 0}}}}, "segment coplanar on e0/e2: v0/e2 e0/v2"},
    {"shared edge in the plane", {{{{4, 0, 0}, {0, 0, 0}, {0, -4, 0}}}}, "segment coplanar on e0/e0: v0/v1 v1/v0"},
    {"edges overlap in the plane", {{{{1, 0, 0}, {9, 0, 0}, {0, -4, 0}}}}, "segment coplanar on e0/e0: v1/e0 e0/v0"},

    // A polygon.
    {"equal", right_triangle, "polygon coplanar on f/f: v0/v0 v1/v1 v2/v2"},
    {"equal turned around", {{{{4, 0, 0}, {0, 0, 0}, {0, 4, 0}}}}, "polygon coplanar on f/f: v0/v1 v1/v0 v2/v2"},
    {"inside", {{{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}}, "polygon coplanar on f/f: f/v0 f/v1 f/v2"},
    {"shared edge on one side", {{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}}}, "polygon coplanar on f/f: v0/v0 v1/v1 f/v2"},
    {"a corner cut off", {{{{2, -1, 0}, {9, -1, 0}, {2, 9, 0}}}}, "polygon coplanar on f/f: v1/f e0/e2 e1/e2"},
    {"a square in common", {{{{2, 2, 0}, {-2, 2, 0}, {2, -2, 0}}}}, "polygon coplanar on f/f: v0/e1 e0/e2 e1/v0 e2/e0"},
    {"a star", {{{{3, 3, 0}, {-1, 3, 0}, {3, -1, 0}}}}, "polygon coplanar on f/f: e0/e1 e0/e2 e1/e2 e1/e0 e2/e0 e2/e1"},
};

class TriangleCase : public testing::TestWithParam<KnownCase> {};

TEST_P(TriangleCase, IsToldExactlyAndBothWays) {
  const auto& [name, b, expected] = GetParam();
  const Intersection m = intersect(right_triangle, b);
  EXPECT_EQ(to_text(m), expected);
  EXPECT_EQ(feature_intersection(right_triangle, b), m);
  EXPECT_EQ(intersect(b, right_triangle), flipped(m));
  for (const auto overlaps : {overlap, overlap_by_penetration, overlap_by_separating_axes}) {
    EXPECT_EQ(overlaps(right_triangle, b), m.kind != IntersectionKind::none);
    EXPECT_EQ(overlaps(b, right_triangle), m.kind != IntersectionKind::none);
  }
}

/// "Meets", not "lays within": the slide's test looks only at the segment in which the second triangle cuts the plane
/// of the first, and wants it inside the first.
TEST(Penetration, SeesASegmentThatIsNotWithinTheTriangle) {
  const Triangle passes_over_an_edge{{{{1, 1, -1}, {1, 1, 1}, {9, 1, 0}}}};
  const Triangle swallows_the_triangle{{{{-9, 1, -9}, {-9, 1, 9}, {30, 1, 0}}}};
  EXPECT_TRUE(overlap_by_penetration(right_triangle, passes_over_an_edge));
  EXPECT_TRUE(overlap_by_penetration(right_triangle, swallows_the_triangle));
}

/// "One is above and one is below" would miss these.
TEST(Penetration, SeesTrianglesWithoutAVertexOnBothSides) {
  EXPECT_TRUE(overlap_by_penetration(right_triangle, {{{{1, 1, 0}, {2, 1, 1}, {1, 2, 1}}}}));
  EXPECT_TRUE(overlap_by_penetration(right_triangle, {{{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}}));
}

TEST(Coordinates, AreNearestDoublesOfTheExactPoints) {
  const Triangle b{{{{1, 1, -1}, {1, 1, 2}, {9, 1, 0}}}};  // leaves the right triangle at x = 3, y = 1
  const IntersectionPoints at = intersection_points(intersect(right_triangle, b), right_triangle, b);
  ASSERT_EQ(at.count, 2);
  EXPECT_EQ(at.points[0], (Vec3{3, 1, 0}));
  EXPECT_EQ(at.points[1], (Vec3{1, 1, 0}));
  const Triangle third{{{{0, 1, -1}, {1, 1, 2}, {9, 9, 9}}}};  // its edge 0 pierces at a third of its length
  const Intersection m = intersect(right_triangle, third);
  ASSERT_EQ(m.points[0], (IntersectionPoint{Feature{}, {FeatureKind::edge, 0}}));
  EXPECT_EQ(intersection_points(m, right_triangle, third).points[0], (Vec3{1.0 / 3.0, 1, 0}));
}

TEST(Coordinates, OfASharedVertexDoNotDependOnTheSignOfZero) {
  const Triangle b{{{{-0.0, -0.0, -0.0}, {-1, 0, 1}, {0, -1, 1}}}};
  const Intersection m = intersect(right_triangle, b);
  ASSERT_EQ(m.kind, IntersectionKind::point);
  EXPECT_FALSE(std::signbit(intersection_points(flipped(m), b, right_triangle).points[0].x));
}

/// Far beyond what products of doubles can hold.
TEST(TriangleTriangle, ReachesToTheEndsOfTheDoubles) {
  const Triangle huge{{{{-DBL_MAX, -DBL_MAX, 0}, {DBL_MAX, -DBL_MAX, 0}, {0, DBL_MAX, 0}}}};
  constexpr double least = 5e-324;
  const auto needle_from = [](double height) {
    return Triangle{{{{0, 0, height}, {0, 0, DBL_MAX}, {DBL_MAX, 0, DBL_MAX}}}};
  };
  EXPECT_FALSE(overlap(huge, needle_from(least)));
  EXPECT_EQ(to_text(intersect(huge, needle_from(0))), "point on f/v0: f/v0");
  EXPECT_EQ(to_text(intersect(huge, needle_from(-least))), "segment crossing on f/f: f/e0 f/e2");
  const Triangle smallest{{{{0, 0, 0}, {least, 0, 0}, {0, least, 0}}}};
  EXPECT_EQ(to_text(intersect(smallest, huge)), "polygon coplanar on f/f: v0/f v1/f v2/f");
}

INSTANTIATE_TEST_SUITE_P(Known, TriangleCase, testing::ValuesIn(known_cases));

}  // namespace
}  // namespace toccata
