#include "toccata/motion/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "oracle/rational.hpp"
#include "support/rigid_cases.hpp"
#include "toccata/core/error.hpp"

namespace toccata::test {
namespace {

Vec3 drawn_point(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

Pose drawn_rigid_pose(Random& random) {
  return {rotation_about(drawn_point(random), random.between(-180, 180)), 3 * drawn_point(random)};
}

double difference(const Pose& a, const Pose& b) {
  double largest = 0;
  for (int i = 0; i < 12; ++i) {
    const auto at = static_cast<std::size_t>(i);
    largest = std::max(largest, std::abs(a.numbers()[at] - b.numbers()[at]));
  }
  return largest;
}

/// What a rotation turns by, in turns.
double turns_of(const Mat3& rotation) {
  const double cosine = 0.5 * (((rotation[0].x + rotation[1].y) + rotation[2].z) - 1);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) / (2 * std::acos(-1.0));
}

TEST(RigidMotion, WhatRestsIsAtItsPoseAtEveryTime) {
  const Pose pose = Pose::rotation({1, 2, 3}, 40);
  for (const double time : {0.0, 0.3, 1.0}) EXPECT_EQ(RigidMotion(pose).at(time), pose);
}

TEST(RigidMotion, AMoveIsTheFormulaOfTheTruthPage) {
  const RigidMotion motion(Pose::translation(2, 0, 0), {{1, 0, 0}, {0, 0, 5}, 1, {0, 0, 8}});
  EXPECT_EQ(motion.at(0), Pose::translation(2, 0, 0));
  EXPECT_EQ(transform(motion.at(0.25), Vec3{}), (Vec3{1, 1, 2}));
  EXPECT_EQ(transform(motion.at(0.5), Vec3{}), (Vec3{0, 0, 4}));
  EXPECT_EQ(transform(motion.at(1), Vec3{}), (Vec3{2, 0, 8}));
}

TEST(RigidMotion, BetweenTwoPosesBothAreReachedTheShorterWay) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose start = drawn_rigid_pose(random), end = drawn_rigid_pose(random);
    const Vec3 centre = drawn_point(random);
    for (const RigidMotion& motion : {RigidMotion::between(start, end, centre), RigidMotion::screw(start, end)}) {
      EXPECT_EQ(motion.at(0), start);
      EXPECT_LT(difference(motion.at(1), end), 0x1p-42) << i;
      EXPECT_NEAR(motion.pieces()[0].move.turns, turns_of(end.linear * transpose(start.linear)), 1e-7);
    }
    const Vec3 half_way = transform(RigidMotion::between(start, end, centre).at(0.5), centre);
    EXPECT_LT(length(half_way - 0.5 * (transform(start, centre) + transform(end, centre))), 1e-14);
  }
}

TEST(RigidMotion, AHalfTurnAndSmallTurnsAreTurnsToo) {
  for (const double degrees : {180.0, 179.99999, 90.0, 1.0, 1e-7, 1e-14}) {
    const Pose end = Pose::rotation({1, 2, 2}, degrees);
    const RigidMotion motion = RigidMotion::between({}, end);
    EXPECT_LT(difference(motion.at(1), end), 1e-15) << degrees;
    EXPECT_NEAR(motion.pieces()[0].move.turns * 360 / degrees, 1, 1e-3 / degrees * 1e-12 + 1e-14) << degrees;
  }
}

TEST(RigidMotion, AScrewHasItsTranslationAlongItsAxis) {
  const RigidMotion motion = RigidMotion::screw(Pose::translation(3, 1, 0), {rotation_about({0, 0, 1}, 90), {1, 3, 5}});
  const RigidMove& move = motion.pieces()[0].move;
  EXPECT_LT(length(move.translation - Vec3{0, 0, 5}), 1e-14);
  EXPECT_LT(length(Vec3{move.centre.x, move.centre.y, 0} - Vec3{1, 1, 0}), 1e-14);
}

TEST(RigidMotion, AMotionThroughPosesIsAtEachAtItsTime) {
  Random random(2);
  std::vector<MotionKey> keys;
  for (const double time : {0.0, 0.1, 0.6, 1.0}) keys.push_back({time, drawn_rigid_pose(random)});
  const RigidMotion motion = RigidMotion::through(keys, {1, 0, 0});
  for (const MotionKey& key : keys) EXPECT_LT(difference(motion.at(key.time), key.pose), 1e-14);
}

TEST(RigidMotion, ItsPiecesMakeItAgain) {
  Random random(31);
  for (int round = 0; round < 20; ++round) {
    const std::vector<MotionKey> keys{
        {0, drawn_rigid_pose(random)}, {0.4, drawn_rigid_pose(random)}, {1, drawn_rigid_pose(random)}};
    const RigidMotion motion = RigidMotion::through(keys, drawn_point(random)).carrying(drawn_rigid_pose(random));
    const RigidMotion again = RigidMotion::of_pieces({motion.pieces().begin(), motion.pieces().end()});
    ASSERT_EQ(again.pieces().size(), 2U);
    for (const double time : {0.0, 0.3, 0.4, 0.8, 1.0}) EXPECT_EQ(again.at(time), motion.at(time));
  }
  using Piece = RigidMotion::Piece;
  const double infinite = std::numeric_limits<double>::infinity();
  for (const std::vector<Piece>& wrong : {std::vector<Piece>{},
                                          {Piece{0, 0.5}},
                                          {Piece{0.5, 1}},
                                          {Piece{0, 0.5}, Piece{0.6, 1}},
                                          {Piece{0, 0}, Piece{0, 1}},
                                          {Piece{0, std::nan("")}},
                                          {Piece{0, 1, Pose::translation(infinite, 0, 0)}},
                                          {Piece{0, 1, {}, {.axis = {}, .turns = 1}}}})
    EXPECT_THROW((void)RigidMotion::of_pieces(wrong), Error);
}

TEST(RigidMotion, APoseThatScalesMovesAsItIs) {
  const Pose start = scaled(Pose::rotation({0, 1, 0}, 30), 2.5);
  const Pose end{rotation_about({1, 1, 0}, 70) * start.linear, {1, 2, 3}};
  EXPECT_LT(difference(RigidMotion::between(start, end).at(1), end), 1e-14);
}

TEST(RigidMotion, AVertexIsNoFartherOffThanIsTold) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const double far = std::pow(10, random.between(-3, 6));
    const RigidMove move{far * drawn_point(random), drawn_point(random), random.between(-30, 30),
                         5 * drawn_point(random)};
    const RigidMotion motion({rotation_about(drawn_point(random), 50), far * drawn_point(random)}, move);
    const Vec3 local = drawn_point(random), start = oracle::world_vertex(motion.at(0), local);
    const double time = random.unit();
    const oracle::FineBody body{oracle::hull_set_of({start}, 0), move};
    const auto exact = std::get<oracle::FineSet>(oracle::moved(body, oracle::Fine(time)).set).vertices[0];
    const Vec3 posed = transform(motion.at(time), local);
    const auto off = [](double a, const oracle::Fine& b) {
      return oracle::Fine(abs(oracle::Fine(a) - b)).convert_to<double>();
    };
    const double sizes = 2 + 1.8 * far * 3 + 1.8 * far * 2 + 9;
    EXPECT_LT(off(posed.x, exact.x) + off(posed.y, exact.y) + off(posed.z, exact.z),
              (128 + 64 * std::abs(move.turns)) * 0x1p-53 * sizes);
  }
}

TEST(RigidMotion, WhatIsCarriedStaysWhereItIsFixed) {
  const Pose fixed{rotation_about({1, 2, 0}, 40), {1, 0, 3}};
  const RigidMotion arm = RigidMotion::through(
      std::vector<MotionKey>{{0, Pose{}}, {0.5, Pose::rotation({0, 0, 1}, 90)}, {1, Pose::translation(1, 2, 3)}});
  const RigidMotion told = RigidMotion::of([&](double time) { return arm.at(time); }, {.speed = 8, .turns = 1});
  for (const double time : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Vec3 expected = arm.at(time) * (fixed * Vec3{1, 1, 1});
    EXPECT_LT(length(arm.carrying(fixed).at(time) * Vec3{1, 1, 1} - expected), 1e-13);
    EXPECT_LT(length(told.carrying(fixed).at(time) * Vec3{1, 1, 1} - expected), 1e-13);
  }
  EXPECT_LT(length(fixed * told.carrying(fixed).speed().centre), 1e-13);
  EXPECT_THROW((void)arm.carrying(Pose::translation(0.0 / 0.0, 0, 0)), Error);
}

TEST(RigidMotion, WhatIsNoMotionIsAnError) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(RigidMotion(Pose::translation(infinity, 0, 0)), Error);
  EXPECT_THROW(RigidMotion(Pose{}, RigidMove{.turns = infinity}), Error);
  EXPECT_THROW(RigidMotion(Pose{}, RigidMove{.axis = {}, .turns = 1}), Error);
  EXPECT_THROW((void)RigidMotion::between(Pose{}, scaled(Pose{}, 2)), Error);
  Pose mirrored;
  mirrored.linear[0].x = -1;
  EXPECT_THROW((void)RigidMotion::between(Pose{}, mirrored), Error);
  EXPECT_THROW((void)RigidMotion(Pose{}).at(1.5), Error);
  EXPECT_THROW((void)RigidMotion(Pose{}).at(std::nan("")), Error);
  const auto through = [](std::vector<MotionKey> keys) { return RigidMotion::through(keys); };
  EXPECT_THROW((void)through({{0, {}}}), Error);
  EXPECT_THROW((void)through({{0, {}}, {0.5, {}}}), Error);
  EXPECT_THROW((void)through({{0, {}}, {0.7, {}}, {0.7, {}}, {1, {}}}), Error);
  EXPECT_THROW((void)through({{0, {}}, {std::nan(""), {}}, {1, {}}}), Error);
  EXPECT_THROW((void)RigidMotion::of(nullptr, {}), Error);
  EXPECT_THROW((void)RigidMotion::of([](double) { return Pose{}; }, {.speed = -1}), Error);
}

}  // namespace
}  // namespace toccata::test
