// A World with space_time tells the same as one without, whatever its bodies do and whatever they promise.
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

namespace toccata {
namespace {

using test::vector_in;

/// How a body flies: on, turning, now and then somewhere else.
struct Course {
  Vec3 at, velocity, axis{0, 0, 1};
  double angle = 0, spin = 0;
  [[nodiscard]] Pose pose() const { return {rotation_about(axis, angle), at}; }
};

struct Manners {
  double jitter = 0;      ///< of the velocity, in a step
  double promised = -1;   ///< as max_acceleration; negative: nothing
  double share_wild = 0;  ///< of bodies that jump in a step
  double room = 12;
  double spin = 3;  ///< degrees in a step, at most
};

void fly(Course& course, const Manners& manners, Random& random) {
  course.velocity += vector_in(random, -manners.jitter, manners.jitter);
  course.at += course.velocity;
  course.angle += course.spin;
  for (int axis = 0; axis < 3; ++axis)
    if (course.at[axis] < 0 || course.at[axis] > manners.room) course.velocity[axis] = -course.velocity[axis];
  if (random.unit() < manners.share_wild) course.at = vector_in(random, 0, manners.room);
}

bool same_pairs(const std::vector<PairReport>& a, const std::vector<PairReport>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PairReport& x, const PairReport& y) {
    const bool same_details =
        !x.details == !y.details &&
        (!x.details || (x.details->distance == y.details->distance &&
                        x.details->first_contact.has_value() == y.details->first_contact.has_value()));
    return x.a.index == y.a.index && x.b.index == y.b.index && x.in_contact == y.in_contact && same_details;
  });
}

/// Two Worlds, with the option and without it, to which the same is done.
class Twins {
 public:
  explicit Twins(const WorldOptions& options, int threads = 1) {
    WorldOptions scheduled = options;
    scheduled.space_time = true;
    scheduled.threads = threads;
    plain_ = World(options);
    scheduled_ = World(scheduled);
  }

  void add(const Body& body) {
    ids_.push_back(plain_.add(body));
    others_.push_back(scheduled_.add(body));
  }
  template <class Do>
  void both(const Do& act) {
    act(plain_, ids_);
    act(scheduled_, others_);
  }
  void step() {
    const WorldStep& a = plain_.step();
    const WorldStep& b = scheduled_.step();
    ++steps_;
    ASSERT_TRUE(same_pairs(a.begin, b.begin) && same_pairs(a.persist, b.persist) && same_pairs(a.end, b.end))
        << "step " << steps_;
    ASSERT_LE(b.candidates, a.candidates) << "step " << steps_;
    asked_plain_ += a.asked;
    asked_scheduled_ += b.asked;
    events_ += a.begin.size() + a.persist.size() + a.end.size();
  }

  [[nodiscard]] World& scheduled() { return scheduled_; }
  [[nodiscard]] std::size_t events() const { return events_; }
  [[nodiscard]] std::size_t asked_plain() const { return asked_plain_; }
  [[nodiscard]] std::size_t asked_scheduled() const { return asked_scheduled_; }

 private:
  World plain_, scheduled_;
  std::vector<BodyId> ids_, others_;
  int steps_ = 0;
  std::size_t events_ = 0, asked_plain_ = 0, asked_scheduled_ = 0;
};

std::vector<Course> random_courses(std::size_t count, const Manners& manners, double speed, Random& random) {
  std::vector<Course> courses;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at = vector_in(random, 0, manners.room), velocity = vector_in(random, -speed, speed);
    courses.push_back({at, velocity, vector_in(random, -1, 1), 0, manners.spin * random.between(-1, 1)});
  }
  return courses;
}

void live(Twins& twins, std::vector<Course>& courses, const Manners& manners, int steps, Random& random) {
  for (int i = 0; i < steps && !testing::Test::HasFatalFailure(); ++i) {
    for (Course& course : courses) fly(course, manners, random);
    twins.both([&](World& world, const std::vector<BodyId>& ids) {
      std::vector<Pose> poses;
      for (const Course& course : courses) poses.push_back(course.pose());
      world.move(ids, poses);
    });
    twins.step();
  }
}

Body rod_at(const Course& course) { return {Capsule({-1, -1, 0}, {1, 1, 0}, 0.05), course.pose()}; }

TEST(SpaceTime, AsksAThirdOrLessWhereLittleHappens) {
  Random random(1);
  const Manners manners{.room = 20, .spin = 0.1};
  std::vector<Course> courses = random_courses(150, manners, 0.01, random);
  Twins twins({});
  for (const Course& course : courses) twins.add(rod_at(course));
  live(twins, courses, manners, 120, random);
  EXPECT_GT(twins.events(), 20);
  EXPECT_GT(twins.asked_plain(), 3 * twins.asked_scheduled());
}

/// Balls and bars that turn and cross each other slowly, deep in contact.
TEST(SpaceTime, AsksAFourthOrLessWherePairsStayInContact) {
  Random random(3);
  const Manners manners{.room = 40, .spin = 0.5};
  std::vector<Course> courses = random_courses(40, manners, 0.005, random);
  Twins twins({});
  for (std::size_t i = 0; i < courses.size(); ++i) {
    if (i % 2 == 1) courses[i].at = courses[i - 1].at + vector_in(random, -0.2, 0.2);
    twins.add(i % 4 == 0 ? Body{Sphere(1), courses[i].pose()} : Body{Box({2, 1, 1}), courses[i].pose()});
  }
  live(twins, courses, manners, 60, random);
  EXPECT_GT(twins.events(), 60 * 15);
  EXPECT_GT(twins.asked_plain(), 4 * twins.asked_scheduled());
}

TEST(SpaceTime, APairWhoseBoxesOverlapIsNotForgottenWhileItPauses) {
  Twins twins({});
  Body ball{Sphere(0.1), Pose::translation(0.8, -0.8, 0)};
  ball.max_speed = 0.1;
  twins.add(Body{Capsule({-1, -1, 0}, {1, 1, 0}, 0.05)});
  twins.add(ball);
  double way = 0;
  for (int step = 1; step <= 24; ++step) {
    way += step <= 3 ? 0.01 : step <= 7 ? 0 : 0.065;
    twins.both([&](World& world, const std::vector<BodyId>& ids) {
      world.move(ids[1], Pose::translation(0.8 - way, way - 0.8, 0));
    });
    twins.step();
  }
  EXPECT_GT(twins.events(), 0);
}

TEST(SpaceTime, WhatShrinksAwayFromWhatItIsDeepInIsFoundToLeave) {
  Twins twins({});
  twins.add(Body{Box({1, 1, 1})});
  twins.add(Body{Box({1, 1, 1}), Pose::translation(1.2, 0, 0)});
  for (int step = 1; step <= 60; ++step) {
    twins.both([&](World& world, const std::vector<BodyId>& ids) {
      const double scale = 1 - 0.01 * step;
      const Mat3 linear{{Vec3{scale, 0, 0}, Vec3{0, scale, 0}, Vec3{0, 0, scale}}};
      world.move(ids[0], {linear, {}});
      world.move(ids[1], {linear, {1.2, 0, 0}});
    });
    twins.step();
  }
  EXPECT_GT(twins.events(), 0);
  EXPECT_TRUE(twins.scheduled().pairs().empty());
}

TEST(SpaceTime, APairThatIsOnlyNearIsToldUntilItIsNotOrMeets) {
  for (const double speed : {0.05, -0.05}) {
    Twins twins({});
    Body a{Sphere(1)}, b{Capsule({0, -1, 0}, {0, 1, 0}, 0.5), Pose::translation(3, 0, 0)};
    a.margin = b.margin = 1;
    twins.add(a);
    twins.add(b);
    for (int step = 1; step <= 60; ++step) {
      twins.both([&](World& world, const std::vector<BodyId>& ids) {
        world.move(ids[1], Pose::translation(3 + speed * step, 0, 0));
      });
      twins.step();
    }
    if (speed < 0) {
      EXPECT_GT(twins.asked_plain(), 2 * twins.asked_scheduled());
    }
    EXPECT_EQ(twins.scheduled().pairs().size(), speed > 0 ? 0 : 1);
  }
}

class SpaceTimeLives : public testing::TestWithParam<int> {};

TEST_P(SpaceTimeLives, TellTheSameAsPlainOnes) {
  const auto number = static_cast<std::uint64_t>(GetParam());
  Random random(100 + number);
  // Who promises little and moves wildly lies.
  const Manners manners{.jitter = number % 3 == 0 ? 0 : 0.01,
                        .promised = number % 2 == 0   ? -1
                                    : number % 4 == 1 ? 0.001
                                                      : 0.05,
                        .share_wild = number % 5 == 4 ? 0.02 : 0};
  std::vector<Course> courses = random_courses(40, manners, number % 4 == 0 ? 0.3 : 0.03, random);
  Twins twins({.distance = number % 2 == 0}, 1 + GetParam() % 2);
  for (const Course& course : courses) {
    Body body{random.below(3) == 0 ? test::random_any(random) : test::random_solid(0.7, random), course.pose()};
    if (manners.promised >= 0) body.max_acceleration = manners.promised;
    if (number % 6 == 5) body.max_speed = 0.02;
    if (random.below(4) == 0) body.margin = 0.25;
    twins.add(body);
  }
  live(twins, courses, manners, 40, random);
  EXPECT_GT(twins.events(), 0);
}

INSTANTIATE_TEST_SUITE_P(All, SpaceTimeLives, testing::Range(0, 12));

/// Flies for a while, so that the pairs are not looked at, and then does what the schedule could not foresee.
class SpaceTimeSurprise : public testing::Test {
 protected:
  SpaceTimeSurprise() : random_(7), courses_(random_courses(60, manners_, 0.002, random_)), twins_({}) {
    for (const Course& course : courses_) twins_.add(Body{Sphere(0.2), course.pose()});
    live(twins_, courses_, manners_, 8, random_);
  }
  void go_on() { live(twins_, courses_, manners_, 30, random_); }

  Manners manners_{.room = 30};
  Random random_;
  std::vector<Course> courses_;
  Twins twins_;
};

TEST_F(SpaceTimeSurprise, PairsAreNotLookedAtAndABodyThatJumpsIsFoundAtOnce) {
  EXPECT_EQ(twins_.scheduled().last_step().candidates, 0);
  courses_[0].at = courses_[1].at;
  live(twins_, courses_, manners_, 1, random_);
  EXPECT_EQ(twins_.scheduled().pairs().size(), 1);
  go_on();
}

TEST_F(SpaceTimeSurprise, ABodyThatWasAddedReplacedOrGivenAMarginIsFoundAtOnce) {
  const Course course{courses_[2].at, {}};
  courses_.push_back(course);
  twins_.add(Body{Box({0.5, 0.5, 0.5}), course.pose()});
  go_on();
  twins_.both([&](World& world, const std::vector<BodyId>& ids) {
    world.replace(ids[3], Body{Sphere(5), courses_[3].pose()});
    Body wide = world.body(ids[4]);
    wide.margin = 8;
    world.replace(ids[4], wide);
  });
  go_on();
  EXPECT_GT(twins_.scheduled().pairs().size(), 2);
}

TEST_F(SpaceTimeSurprise, ARuleIsFollowedAtOnce) {
  twins_.both([](World& world, const std::vector<BodyId>& ids) {
    world.set_rule({.a = ids[5], .b = ids[6], .margin = 60});
    world.set_rule({.a = ids[7], .b = ids[8], .margin = std::numeric_limits<double>::infinity()});
  });
  go_on();
  EXPECT_EQ(twins_.scheduled().pairs().size(), 2);
  twins_.both([](World& world, const std::vector<BodyId>& ids) {
    world.set_rule({.a = ids[5], .b = ids[6], .excluded = true});
    world.set_rule({.a = ids[7], .b = ids[8]});
  });
  go_on();
  EXPECT_TRUE(twins_.scheduled().pairs().empty());
}

TEST_F(SpaceTimeSurprise, ABodyThatGoesAlongAMotionMeetsWhatIsOnItsWay) {
  twins_.both([&](World& world, const std::vector<BodyId>& ids) {
    world.move_along(ids[0], RigidMotion::straight(courses_[0].pose(), 2 * (courses_[1].at - courses_[0].at)));
  });
  twins_.step();
  EXPECT_FALSE(twins_.scheduled().pairs().empty());
  go_on();
}

TEST_F(SpaceTimeSurprise, ABodyThatRestsAndIsHitIsFound) {
  for (Course& course : courses_) course.velocity = {};
  for (Course& course : courses_) course.spin = 0;
  go_on();
  courses_[0].velocity = 0.05 * (courses_[1].at - courses_[0].at);
  go_on();
  EXPECT_GT(twins_.events(), 0);
}

TEST_F(SpaceTimeSurprise, ACopyTellsTheSameFromThereOn) {
  twins_.scheduled() = World(twins_.scheduled());
  go_on();
  courses_[0].at = courses_[1].at;
  go_on();
}

TEST_F(SpaceTimeSurprise, AStepThatIsBrokenOffLosesNoPair) {
  courses_[1].at = courses_[0].at + Vec3{0.1, 0, 0};
  courses_[0].velocity = courses_[1].velocity = {};
  courses_[0].spin = courses_[1].spin = 0;
  for (int round = 0; round < 10; ++round) {
    live(twins_, courses_, manners_, 8 + round, random_);
    ASSERT_FALSE(twins_.scheduled().pairs().empty());
    bool is_broken = false;
    const Vec3 from = courses_[2].at, way = courses_[0].at - from;
    const auto course = [&](double time) {
      if (is_broken) throw std::runtime_error("the line is dead");
      return Pose::translation(from + time * way);
    };
    twins_.both([&](World& world, const std::vector<BodyId>& ids) {
      is_broken = false;
      world.move_along(ids[2], RigidMotion::of(course, {.speed = 1.01 * length(way)}));
      is_broken = true;
      EXPECT_THROW(world.step(), std::runtime_error);
      world.move(ids[2], courses_[2].pose());
    });
    twins_.step();
  }
}

TEST(SpaceTime, NegativePromisesAreRefused) {
  World world({.space_time = true});
  Body body{Sphere(1)};
  body.max_acceleration = -1;
  EXPECT_THROW(world.add(body), Error);
  body.max_acceleration = 0;
  body.max_speed = std::nan("");
  EXPECT_THROW(world.add(body), Error);
  EXPECT_EQ(world.size(), 0);
}

}  // namespace
}  // namespace toccata
