#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/error_message.hpp"
#include "support/mover_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/toccata.hpp"

// What a character does where there is no good answer, or none can be told: it says so.
namespace toccata::test {
namespace {

using State = MoverState<Index>;
using Step = MoverStep<Index>;
using Moved = std::vector<MovedObject<Index>>;

constexpr double skin = 0.01;

/// Stands with its lowest point at its position: 1.8 high, 0.8 wide.
Model capsule() { return Capsule({0, 0, 0.4}, {0, 0, 1.4}, 0.4); }

SceneIndex scene(std::vector<SceneInstance> models) { return SceneIndex(models); }

SceneInstance block(const Vec3& centre, const Vec3& half) { return {Box(half), Pose::translation(centre)}; }

SceneInstance floor_below() { return {HalfSpace({}, {0, 0, 1}), {}}; }

State landed(const SceneIndex& level, const Vec3& at) {
  const Step step = move_character(level, capsule(), {Pose::translation(at)}, {0, 0, -0.5});
  EXPECT_TRUE(step.state.ground);
  return step.state;
}

Model random_solid(Random& random) {
  const double a = random.between(0.2, 1), b = random.between(0.2, 1);
  switch (random.below(6)) {
    case 0:
      return Cylinder(a, b);
    case 1:
      return Cone(a, 2 * b);
    case 2:
      return Ellipsoid({a, b, random.between(0.2, 1)});
    case 3:
      return Rounded(Box({a, b, a}), 0.1);
    case 4:
      return Box({a, b, a});
    default:
      return Capsule({}, {a, b, a}, b / 2);
  }
}

/// Two solids on a line, the first in the middle.
struct TwoSolids {
  Model one, two;
  Pose at_one, at_two;
  Vec3 line;

  explicit TwoSolids(Random& random) : one(random_solid(random)), two(random_solid(random)) {
    const bool is_upright = random.below(3) == 0;
    at_one.linear = is_upright ? Pose{}.linear : random_rotation(random);
    at_two.linear = is_upright ? Pose{}.linear : random_rotation(random);
    line = is_upright ? Vec3{1, 0, 0} : normalized(random_vector(random, 1));
  }

  [[nodiscard]] bool meet_at(double distance) {
    at_two.offset = distance * line;
    return overlap(one, two, {at_one, at_two});
  }

  /// The greatest distance at which they are said to meet, and the next.
  [[nodiscard]] std::array<double, 2> touching() {
    double meets = 0, apart = 8;
    for (int i = 0; i < 64; ++i) {
      const double middle = 0.5 * (meets + apart);
      (meet_at(middle) ? meets : apart) = middle;
    }
    return {meets, apart};
  }

  [[nodiscard]] Step recovered() const {
    return move_character(scene({{two, at_two}}), one, State{at_one}, {}, {.skin = skin});
  }
};

TEST(CharacterMoverLimits, LeavesWhatItTouchesButForRounding) {
  Random random(1);
  for (int round = 0; round < 45; ++round) {
    TwoSolids pair(random);
    for (const double distance : pair.touching()) {
      static_cast<void>(pair.meet_at(distance));
      const Step step = pair.recovered();
      EXPECT_FALSE(step.tight) << round;
      EXPECT_FALSE(step.stuck) << round;
      EXPECT_GT(length(step.pushed_out), 0.99 * skin) << round;
      EXPECT_LT(length(step.pushed_out), 1.5 * skin) << round;
    }
  }
}

TEST(CharacterMoverLimits, LeavesOneConvexThingByItsPenetrationAndTheSkin) {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    TwoSolids pair(random);
    static_cast<void>(pair.meet_at(random.between(0, 0.6)));
    const Penetration depth = penetration(pair.one, pair.two, {pair.at_one, pair.at_two});
    const Step step = pair.recovered();
    EXPECT_FALSE(step.tight) << round;
    EXPECT_LT(length(step.pushed_out), 1.25 * (depth.upper + skin)) << round;
  }
}

TEST(CharacterMoverLimits, AWayThatCannotBeProvedIsSaidToBeCutShort) {
  const Model mover = capsule();
  const SceneIndex plain = scene({floor_below()});
  const State on_plain{Pose::translation(0, 0, skin)};
  const Step far = move_character(plain, mover, on_plain, {1e11, 0, 0});
  EXPECT_EQ(far.moved, (Vec3{1e11, 0, 0}));
  EXPECT_FALSE(far.cut_short);
  const SceneIndex leaning = scene({{HalfSpace({}, normalized(Vec3{0.3, 0.1, 1})), {}}});
  const SceneIndex round = scene({{Cylinder(1e7, 1e13), Pose::rotation({0, 1, 0}, 90)}});
  int stopped = 0;
  for (const SceneIndex* level : {&plain, &leaning, &round})
    for (const double size : {1e6, 1e9, 1e12, 1e15}) {
      const double height = level == &round ? 1e7 + 0.011 : 0.02;
      const Vec3 motion = level == &leaning ? size * normalized(Vec3{1, 0, -0.3}) : Vec3{size, 0, 0};
      const Step step = move_character(*level, mover, {Pose::translation(0, 0, height)}, motion);
      const bool is_whole = length(step.moved - step.pushed_out - motion) <= 1e-9 * size;
      EXPECT_TRUE(is_whole || step.cut_short) << size;
      stopped += is_whole ? 0 : 1;
    }
  EXPECT_GT(stopped, 0);
}

// Up beside a plane that leans by little, as far as it cannot be proved where that is met.
TEST(CharacterMoverLimits, AStepThatCannotBeProvedIsSaidToBeCutShort) {
  const SceneIndex level =
      scene({floor_below(), block({2, 0, 1}, {1, 1, 1}), {HalfSpace({-2, 0, 0}, normalized(Vec3{1, 0, -1e-9})), {}}});
  const State state = landed(level, {0, 0, 0.1});
  const Step low = move_character(level, capsule(), state, {2, 0, 0}, {.step_height = 1e6});
  const Step high = move_character(level, capsule(), state, {2, 0, 0}, {.step_height = 1e12});
  EXPECT_TRUE(low.stepped);
  EXPECT_FALSE(low.cut_short);
  EXPECT_TRUE(high.stepped);
  EXPECT_TRUE(high.cut_short);
}

TEST(CharacterMoverLimits, AWayThatBendsTooOftenIsSaidToBeCutShort) {
  // Around a many-sided pillar in a ring of walls the way bends at each.
  std::vector<SceneInstance> models;
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 3.14159265358979323846 / 12;
    const Vec3 inward{-std::cos(angle), -std::sin(angle), 0};
    models.push_back({HalfSpace(-5.0 * inward, inward), {}});
  }
  const SceneIndex ring = scene(models);
  const State begin{Pose::translation(4.5, 0, 0)};
  const Vec3 motion{2, 8, 0};
  const Step few = move_character(ring, capsule(), begin, motion, {.max_slides = 2});
  const Step many = move_character(ring, capsule(), begin, motion, {.max_slides = 40});
  EXPECT_TRUE(few.cut_short);
  EXPECT_FALSE(many.cut_short);
  EXPECT_GT(many.moved.y, few.moved.y + 0.1);
}

/// A lift that moves by `by`, with the character on it in the middle.
Step ridden(std::vector<SceneInstance> others, const Vec3& by) {
  const Pose before = Pose::translation(0, 0, -0.5);
  others.insert(others.begin(), {Box({1, 1, 0.5}), before});
  const State state = landed(scene(others), {0, 0, 0.1});
  others[0].pose = Pose::translation(by) * before;
  const SceneIndex level = scene(others);
  const Moved moved{{0, before}};
  return move_character(level, capsule(), state, {}, {}, {}, moved);
}

TEST(CharacterMoverLimits, ALiftThatPressesItAgainstACeilingCrushesIt) {
  for (const double height : {2.0, 5.0, 200.0}) {
    const Step step = ridden({block({0, 0, 3}, {4, 4, 0.5})}, {0, 0, height});
    EXPECT_TRUE(step.crushed) << height;
    EXPECT_LT(step.state.pose.offset.z, 2.5 - 1.8) << height;
  }
  EXPECT_FALSE(ridden({block({0, 0, 3}, {4, 4, 0.5})}, {0, 0, 0.5}).crushed);
}

TEST(CharacterMoverLimits, ALiftGoesOnUnderWhatIsHeldBack) {
  const Step held = ridden({block({1, 0, 1}, {0.2, 4, 0.9})}, {0.7, 0, 0});
  EXPECT_FALSE(held.crushed);
  EXPECT_FALSE(held.stuck);
  EXPECT_NEAR(held.state.pose.offset.x, 0.8 - 0.4 - skin, 1e-6);
}

TEST(CharacterMoverLimits, WhatSlipsAlongItAndThenMeetsItPushesIt) {
  // A wall beside it, nearer than the skin, with a post farther on, which comes along the wall.
  const Compound wall(
      {{Box({0.1, 9, 2}), Pose::translation(0.1, 0, 0)}, {Box({0.4, 0.1, 2}), Pose::translation(-0.4, -3, 0)}});
  const Pose before = Pose::translation(0.405, 0, 1), after = Pose::translation(0.405, 6, 1);
  const SceneIndex level = scene({{Model(wall), after}});
  const Moved moved{{0, before}};
  const Step step = move_character(level, capsule(), State{}, {}, {}, {}, moved);
  EXPECT_GT(step.carried.y, 3.4);
  EXPECT_FALSE(step.stuck);
}

TEST(CharacterMoverLimits, WhatPushesItAndGrowsIsNamed) {
  const Pose after = Pose::translation(0.6, 0, 1), smaller{{{Vec3{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}}, {3, 0, 1}};
  const SceneIndex level = scene({floor_below(), {Box({0.3, 1, 1}), after, Solid::automatic, "door"}});
  const Moved moved{{1, smaller}};
  const std::string message =
      message_of([&] { static_cast<void>(move_character(level, capsule(), State{}, {}, {}, {}, moved)); });
  EXPECT_NE(message.find("door"), std::string::npos) << message;
  EXPECT_NE(message.find("no turn"), std::string::npos) << message;
}

TEST(CharacterMoverLimits, KeepsTheGroundBesideAWallThatLeans) {
  const double down = 12 * 0.017453292519943295, lean = 15 * 0.017453292519943295;
  const SceneIndex level = scene({{HalfSpace({}, {std::sin(down), 0, std::cos(down)}), {}},
                                  {HalfSpace({0, 0.6, 0}, {0, -std::cos(lean), std::sin(lean)}), {}}});
  State state = landed(level, {0, 0, 0.1});
  for (int i = 0; i < 40; ++i) {
    const Step step = move_character(level, capsule(), state, {0.1, 0.05, 0});
    ASSERT_TRUE(step.state.ground) << i;
    EXPECT_GT(step.moved.x, 0.09) << i;
    state = step.state;
  }
  EXPECT_LT(distance_from_level(level, capsule(), state.pose), 1.125 * skin);
}

TEST(CharacterMoverLimits, KeepsTheGroundWhateverAxisIsUp) {
  const double down = 12 * 0.017453292519943295;
  for (const Vec3& way : {Vec3{1, 2, 3}, Vec3{-0.3, 0.2, 0.9}, Vec3{1, 1, 1}, Vec3{0, 0, 1}}) {
    const Vec3 up = normalized(way), ahead = normalized(cross(up, Vec3{1, 0, 0}));
    const Vec3 slope = std::cos(down) * up + std::sin(down) * ahead;
    const SceneIndex level = scene({{HalfSpace({}, slope), {}}});
    const Model ball(Sphere(0.4));
    const Vec3 start = 0.6 * slope;
    const MoverOptions options{.up = up};
    State state =
        move_character(level, ball, State{Pose::translation(start.x, start.y, start.z)}, -0.4 * up, options).state;
    for (int i = 0; i < 40; ++i) {
      const Vec3 motion = i % 4 == 3 ? Vec3{} : 0.1 * ahead;
      state = move_character(level, ball, state, motion, options).state;
      ASSERT_TRUE(state.ground) << i << ", up " << way.x << ' ' << way.y << ' ' << way.z;
    }
    EXPECT_GT(dot(state.pose.offset, ahead), 2.8);
  }
}

TEST(CharacterMoverLimits, TellsMoreOfWhatIsAskedWrongly) {
  const SceneIndex level = scene({floor_below()});
  const double nan = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
  const auto told = [&](const Model& shape, const State& from, const Vec3& motion, const MoverOptions& options,
                        const Moved& moved) {
    return message_of([&] { static_cast<void>(move_character(level, shape, from, motion, options, {}, moved)); });
  };
  const auto tells = [](const std::string& message, const char* word) {
    EXPECT_NE(message.find(word), std::string::npos) << word << ": " << message;
  };
  const Model mover = capsule();
  const State state{Pose::translation(0, 0, 1)};
  tells(told(mover, state, {endless, 0, 0}, {}, {}), "motion");
  tells(told(mover, {Pose::translation(nan, 0, 0)}, {}, {}, {}), "pose");
  tells(told(mover, state, {}, {.up = {0, nan, 1}}, {}), "up");
  tells(told(mover, state, {}, {.skin = endless}, {}), "skin");
  tells(told(mover, state, {}, {.skin = -1}, {}), "skin");
  tells(told(mover, state, {}, {.max_slope_degrees = nan}, {}), "slope");
  tells(told(mover, state, {}, {.step_height = endless}, {}), "step height");
  tells(told(mover, state, {}, {.step_height = nan}, {}), "step height");
  tells(told(mover, state, {}, {.snap_distance = -1}, {}), "snap distance");
  tells(told(mover, state, {}, {}, {{0, Pose::translation(0, endless, 0)}}), "not finite");
  tells(told(Model(HeightField(2, 2, 1, 1, std::vector<double>(4, 0))), state, {}, {}, {}), "height field");
  tells(told(Model(Compound({{Box({1, 1, 1}), Pose{}}})), state, {}, {}, {}), "compound");
  EXPECT_EQ(told(mover, state, {}, {}, {}), "");
}

TEST(CharacterMoverLimits, AWayNarrowerThanItIsStopsItOrIsToldWhereItIsIn) {
  // From 1.2 wide to 0.4 wide, for a character of 0.8.
  const SceneIndex funnel = scene({floor_below(),
                                   {HalfSpace({0, 0.6, 0}, normalized(Vec3{-0.05, -1, 0})), {}},
                                   {HalfSpace({0, -0.6, 0}, normalized(Vec3{-0.05, 1, 0})), {}}});
  State state = landed(funnel, {0, 0, 0.1});
  for (int i = 0; i < 60; ++i) {
    const Step step = move_character(funnel, capsule(), state, {0.2, 0.01, 0});
    EXPECT_FALSE(step.stuck);
    EXPECT_GT(distance_from_level(funnel, capsule(), step.state.pose), 0.875 * skin - 1e-9);
    state = step.state;
  }
  EXPECT_LT(state.pose.offset.x, 4);
  const Step inside = move_character(funnel, capsule(), {Pose::translation(8, 0, 0.1)}, {});
  EXPECT_EQ(inside.tight, is_within(funnel, capsule(), inside.state.pose, 0.90625 * skin));
  EXPECT_EQ(inside.stuck, distance_from_level(funnel, capsule(), inside.state.pose) == 0);
}

}  // namespace
}  // namespace toccata::test
