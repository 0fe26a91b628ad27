#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/vec3_measures.hpp"
#include "narrow/near.hpp"
#include "narrow/quadric_cases.hpp"
#include "narrow/quadrics/distance/axial_box.hpp"
#include "narrow/quadrics/distance/ellipsoid_pair.hpp"
#include "narrow/quadrics/distance/fast_pair.hpp"
#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "toccata/narrow/quadrics.hpp"

// Answers in doubles, where these only just suffice, against 60 digits.
namespace toccata::test {
namespace {

using oracle::Fine;

template <class B>
bool is_within(const PosedQuadric& a, const B& b, double length) {
  return nearby(a, b, WantedDistance::within(length)).has_value();
}

/// What is wrong about an interval of [lower, upper] or about yes and no around it; empty: nothing.
template <class B>
std::string fast_fault(const PlacedQuadric& placed_a, const B& placed_b) {
  const PosedQuadric a = posed(placed_a);
  const auto b = posed(placed_b);
  const Distance d = distance(a, b);
  const oracle::FineNearness truth = oracle::fine_nearness(fine_set(placed_a), fine_set(placed_b), 1e-22, 600);
  if (truth.meet) return "they meet";
  if (Fine(d.lower) > truth.upper || Fine(d.upper) < truth.lower) return "interval";
  if (d.status != Status::exact) return "status";
  if (quadric_contact(a, b) != QuadricContact::apart) return "contact";
  for (const double part : {1e-6, 0.5, 1 - 1e-9, 1 - 1e-14, 1.0, 1 + 1e-14, 1 + 1e-9, 2.0, 1e6}) {
    const double tolerance = part * d.upper;
    const bool within = is_within(a, b, tolerance);
    if (!within && Fine(tolerance) >= truth.upper) return "not within " + std::to_string(part);
    if (within && tolerance < d.lower) return "within " + std::to_string(part);
  }
  return "";
}

std::string fast_fault(const QuadricCase& pair) {
  return std::visit([&](const auto& other) { return fast_fault(pair.a, other); }, pair.b);
}

// From gaps that doubles prove to gaps that need twice the digits.
TEST(QuadricFast, IntervalsHoldWhereDoublesOnlyJustProveThem) {
  Random random(8);
  for (const std::string& a : quadric_kinds())
    for (const std::string& b : quadric_other_kinds()) {
      for (const double gap : {0.02, 4e-3, 1e-3, 2e-4}) {
        QuadricCase pair = quadric_case(a, b, "far", random);
        leave_quadric_gap(pair, gap);
        const Vec3 place = 5 * quadric_direction(random);
        pair.a.pose.offset = pair.a.pose.offset + place;
        pair.pose_of_b().offset = pair.pose_of_b().offset + place;
        EXPECT_EQ(fast_fault(pair), "") << a << " " << b << " " << gap;
      }
    }
}

// There, the places of a hull's vertices are rounded by more than what decides, and the farthest one in the hull's own
// frame need not be the farthest in the world.
TEST(QuadricFast, HullsFarFromTheOriginAreNotToldApartThatMeet) {
  Random random(9);
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    QuadricCase pair = quadric_case(quadric_kinds()[random.below(3)], "hull", "far", random);
    const double far = std::pow(10.0, random.between(8, 13));
    const Vec3 place = far * quadric_direction(random);
    pair.a.pose.offset = pair.a.pose.offset + place;
    pair.pose_of_b().offset = pair.pose_of_b().offset + place;
    leave_quadric_gap(pair, random.between(-4, 8) * 0x1p-53 * far);
    const PosedQuadric a = posed(pair.a);
    const PlacedPolytope& placed_b = std::get<PlacedPolytope>(pair.b);
    const PosedPolytope b = posed(placed_b);
    const oracle::FineNearness truth = oracle::fine_nearness(fine_set(pair.a), fine_set(placed_b), 1e-14, 400);
    met += truth.meet ? 1 : 0;
    if (truth.meet) {
      EXPECT_NE(quadric_contact(a, b), QuadricContact::apart) << i;
      EXPECT_GT(penetration(a, b).upper, 0) << i;
    } else {
      EXPECT_TRUE(is_within(a, b, 1.05 * truth.upper.convert_to<double>())) << i;
    }
  }
  EXPECT_GT(met, 100);
}

// A tip, a rim, an edge and a face that lie straight towards each other, where the search arrives at once.
TEST(QuadricFast, NearestFeaturesThatTheSearchMeetsExactly) {
  const PlacedPolytope box{Box({1, 1, 1}), {}};
  Pose down;
  down.linear = rotation_about({1, 0, 0}, 180);
  for (const double gap : {2.0, 0.1, 1e-3, 0x1p-20, 1e-9}) {
    for (const QuadricShape& shape :
         {QuadricShape(Cone(0.5, 2)), QuadricShape(Cylinder(0.5, 2)), QuadricShape(Ellipsoid({0.5, 0.7, 2}))})
      for (Pose pose : {Pose{}, down})
        for (const Vec3& beside : {Vec3{0, 0, 0}, Vec3{1, 0.25, 0}, Vec3{1, 1, 0}, Vec3{1.5, 0, 0}, Vec3{3, 3, 0}}) {
          pose.offset = beside + Vec3{0, 0, 3 + gap};
          EXPECT_EQ(fast_fault(PlacedQuadric{shape, pose}, box), "") << gap << " " << beside.x << " " << beside.y;
        }
  }
}

std::optional<FastDistance> own_way(const PosedQuadric& a, const PosedPolytope& b) { return axial_box_distance(a, b); }
std::optional<FastDistance> own_way(const PosedQuadric& a, const PosedQuadric& b) {
  return ellipsoid_distance(a, b, {});
}

/// How the answers of a pair's own way differ from those that any pair gets; empty: in nothing, or it gives none.
template <class B>
std::string own_way_fault(const PosedQuadric& a, const B& b, int& answered) {
  const auto own = own_way(a, b);
  const auto plain = FastPair<B>(a, b, pair_frame(a, b)).distance();
  if (!own) return "";
  ++answered;
  if (!is_narrow(*own)) return "wide";
  if (!plain) return "";
  if (own->lower > plain->upper || plain->lower > own->upper) return "interval";
  const double off = std::max(plain_length(own->on_a - plain->on_a), plain_length(own->on_b - plain->on_b));
  // The middles lie by 5 from the origin at most, and the other way is as good as that.
  return off > 2e-12 ? fmt::format("points by {}", off) : "";
}

// From far apart, where a corner and a rim are nearest, to hairs, where edges and faces are.
TEST(QuadricFast, PairsWithAWayOfTheirOwnAgreeWithTheWayOfAll) {
  Random random(10);
  const std::pair<const char*, const char*> kinds[] = {
      {"cylinder", "box"}, {"cone", "box"}, {"ellipsoid", "ellipsoid"}};
  for (const auto& [kind_a, kind_b] : kinds)
    for (const double gap : {5.0, 1.0, 0.1, 0.01, 3e-3}) {
      int answered = 0;
      for (int i = 0; i < 200; ++i) {
        QuadricCase pair = quadric_case(kind_a, kind_b, "far", random);
        leave_quadric_gap(pair, gap);
        const PosedQuadric a = posed(pair.a);
        EXPECT_EQ(std::visit([&](const auto& b) { return own_way_fault(a, posed(b), answered); }, pair.b), "")
            << kind_a << " " << gap << " " << i;
      }
      EXPECT_GT(answered, gap < 0.01 ? 0 : 150) << kind_a << " " << gap;
    }
}

std::optional<QuadricContact> own_contact(const PosedQuadric& a, const PosedPolytope& b) {
  return axial_box_contact(a, b);
}
std::optional<QuadricContact> own_contact(const PosedQuadric& a, const PosedQuadric& b) {
  return ellipsoid_contact(a, b);
}

/// How often doubles tell that shapes meet, and that they are apart.
struct FastContacts {
  int met = 0;
  int apart = 0;
};

/// How what doubles prove differs from the proof with bounded numbers; empty: in nothing.
template <class B>
std::string contact_fault(const PosedQuadric& a, const B& b, FastContacts& counted) {
  const PairFrame frame = pair_frame(a, b);
  const QuadricBody body_a(a, frame), body_b(b, frame);
  const QuadricContact at_length = nearest_of(a, body_a, b, body_b, QuadricQuestion::meeting).contact;
  const auto of_any = is_fast(a, b, frame) ? FastPair<B>(a, b, frame).contact() : std::nullopt;
  for (const auto& found : {of_any, own_contact(a, b)}) {
    if (!found) continue;
    if (*found == QuadricContact::undecided) return "undecided";
    if (at_length != QuadricContact::undecided && *found != at_length) return "told otherwise";
    (*found == QuadricContact::contact ? counted.met : counted.apart) += 1;
  }
  return "";
}

TEST(QuadricFast, ContactInDoublesIsThatOfBoundedNumbers) {
  Random random(11);
  for (const std::string& regime : quadric_regimes()) {
    FastContacts counted;
    for (const std::string& a : quadric_kinds())
      for (const std::string& b : quadric_other_kinds())
        for (int i = 0; i < 4; ++i) {
          QuadricCase pair = quadric_case(a, b, regime, random);
          const PosedQuadric first = posed(pair.a);
          EXPECT_EQ(std::visit([&](const auto& other) { return contact_fault(first, posed(other), counted); }, pair.b),
                    "")
              << regime << " " << a << " " << b << " " << i;
        }
    EXPECT_GT(counted.apart, regime == "deep" ? 0 : regime == "close" ? 10 : 50) << regime;
    EXPECT_GT(counted.met, regime == "deep" ? 80 : regime == "far" ? -1 : regime == "close" ? 0 : 10) << regime;
  }
}

// Middles, rims and tips that lie just within, or just beyond what doubles prove.
TEST(QuadricFast, BoxesThatMeetRoundShapesByAHair) {
  Random random(12);
  FastContacts counted;
  for (int i = 0; i < 400; ++i) {
    QuadricCase pair = quadric_case(i % 2 == 0 ? "cylinder" : "cone", "box", "far", random);
    leave_quadric_gap(pair, 0.01);
    const PosedQuadric a = posed(pair.a);
    const Distance now = std::visit([&](const auto& b) { return distance(a, posed(b)); }, pair.b);
    const double deeper = 1 + (i % 3 == 0 ? -1 : 1) * std::pow(10.0, random.between(-15, 0));
    pair.pose_of_b().offset = pair.pose_of_b().offset + deeper * (now.on_a - now.on_b);
    EXPECT_EQ(std::visit([&](const auto& b) { return contact_fault(a, posed(b), counted); }, pair.b), "") << i;
  }
  EXPECT_GT(counted.apart, 50);
  EXPECT_GT(counted.met, 50);
}

// The hulls have more than eight vertices.
TEST(QuadricFast, HullsOfManyVertices) {
  Random random(9);
  for (int i = 0; i < 24; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < (i % 3 == 0 ? 12 : 200); ++k) points.push_back(quadric_direction(random));
    QuadricCase pair = quadric_case(quadric_kinds()[static_cast<std::size_t>(i) % 3], "point", "far", random);
    pair.b = PlacedPolytope{ConvexHull(points), {quadric_linear("far", random), 9 * quadric_direction(random)}};
    leave_quadric_gap(pair, i % 2 == 0 ? 1 : 0.01);
    EXPECT_EQ(fast_fault(pair), "") << i;
  }
}

// Where they meet, every tolerance is reached; and 0 is `overlap`.
TEST(QuadricFast, WhatMeetsIsWithinAnyTolerance) {
  const PosedQuadric can(Cylinder(1, 2)), cone(Cone(1, 1), Pose::translation(0.5, 0, 2.5));
  const PosedPolytope box(Box({1, 1, 1})), standing(Box({1, 1, 1}), Pose::translation(0, 0, 3));
  for (const double tolerance : {0.0, 1e-300, 1e-9, 1.0, 1e9}) {
    EXPECT_TRUE(is_within(can, cone, tolerance));
    EXPECT_TRUE(is_within(can, box, tolerance));
    EXPECT_TRUE(is_within(can, standing, tolerance)) << "touching";
  }
  EXPECT_FALSE(is_within(can, PosedPolytope(Box({1, 1, 1}), Pose::translation(0, 0, 3.5)), 0));
  EXPECT_FALSE(is_within(can, PosedPolytope(Box({1, 1, 1}), Pose::translation(0, 0, 3.5)), 0.499));
}

}  // namespace
}  // namespace toccata::test
