#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "distributed/twin_worlds.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/world/world_queries.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

Vec3 middle_of(const Aabb& box) { return 0.5 * (box.lower + box.upper); }

class CrowdsOfRanks : public testing::TestWithParam<const char*> {};

TEST_P(CrowdsOfRanks, TellTheSerialPairs) {
  Crowd crowd(GetParam(), 150);
  std::vector<Body> bodies;
  for (const Aabb& box : crowd.boxes())
    bodies.push_back({Box(0.5 * (box.upper - box.lower)), Pose::translation(middle_of(box))});
  TwinWorlds twins;
  twins.add(bodies);
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  for (int frame = 0; frame < 60; ++frame) {
    SCOPED_TRACE(frame);
    for (const Index moved : crowd.step()) twins.move(ids[moved], Pose::translation(middle_of(crowd.boxes()[moved])));
    twins.step();
    if (HasFailure()) return;
  }
  EXPECT_FALSE(twins.world.pairs().empty());
}

INSTANTIATE_TEST_SUITE_P(Scenes, CrowdsOfRanks,
                         testing::Values("uniform", "clustered", "sizes", "terrain", "fast", "pile"));

class BodiesOfRanks : public testing::TestWithParam<const char*> {};

TEST_P(BodiesOfRanks, TellTheSerialPairs) {
  BodyCrowd crowd(GetParam(), 80);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < crowd.shapes().size(); ++i)
    bodies.push_back({Model(crowd.shapes()[i]), crowd.poses()[i],
                      i < crowd.ground_count() ? BodyType::static_body : BodyType::dynamic_body});
  DistributedOptions options;
  options.world.distance = options.world.relation = options.world.contacts = options.world.penetration = true;
  TwinWorlds twins(options);
  twins.add(bodies);
  const std::vector<BodyId> ids = twins.world.bodies();
  for (int frame = 0; frame < 20; ++frame) {
    SCOPED_TRACE(frame);
    twins.step();
    if (HasFailure()) return;
    crowd.step();
    for (std::size_t i = crowd.ground_count(); i < ids.size(); ++i) twins.move(ids[i], crowd.poses()[i]);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BodiesOfRanks, testing::Values("fly", "stacks", "terrain"));

class RandomBodiesOfRanks : public testing::TestWithParam<std::string_view> {};

/// Bodies that come, go, become others and jump; with margins without end, groups and half-spaces; on whole numbers,
/// where the planes between ranks are too.
TEST_P(RandomBodiesOfRanks, TellTheSerialPairs) {
  const std::string_view family = GetParam();
  Random random(5);
  TwinWorlds twins;
  std::vector<Body> bodies;
  for (int i = 0; i < 50; ++i) bodies.push_back(random_body(family, random));
  twins.add(bodies);
  for (int frame = 0; frame < 60; ++frame) {
    SCOPED_TRACE(frame);
    twins.step();
    if (HasFailure()) return;
    for (const BodyId id : twins.world.bodies()) {
      const std::uint64_t chance = random.below(20);
      if (chance == 0) {
        twins.remove(id);
      } else if (chance == 1) {
        twins.replace(id, random_body(family, random));
      } else if (chance < 8) {
        twins.move(id, random_place(family, random));
      } else if (chance < 12 && family != "far") {
        Pose pose = twins.world.body(id).pose;
        pose.offset.x += 0.125;
        twins.move(id, pose);
      }
    }
    const std::vector<Body> more(random.below(5), random_body(family, random));
    twins.add(more);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, RandomBodiesOfRanks, testing::ValuesIn(body_families));

TEST(WorldsOfRanks, StandNoBodyOneBodyAndAllInOnePlace) {
  TwinWorlds twins;
  twins.step();
  twins.add(std::vector{Body{Sphere(1)}});
  twins.step();
  twins.add(std::vector(40, Body{Sphere(1)}));
  twins.step();
  EXPECT_EQ(twins.world.pairs().size(), 41U * 40 / 2);
  for (const BodyId id : twins.world.bodies()) twins.move(id, Pose::translation(5, 0, 0));
  twins.step();
  for (const BodyId id : twins.world.bodies()) twins.remove(id);
  twins.step();
  twins.step();
}

/// A body that reached the bodies of all ranks, and in the next step only its neighbours: the ranks that it leaves have
/// it once more in that step.
TEST(WorldsOfRanks, TellNoPairsOfWhatABodyWas) {
  TwinWorlds twins;
  std::vector<Body> bodies = row_of_spheres(40);
  bodies[20].margin = std::numeric_limits<double>::infinity();
  twins.add(bodies);
  twins.step();
  EXPECT_EQ(twins.world.pairs().size(), 39U + 37);
  bodies[20].margin = 0;
  twins.replace(twins.world.bodies()[20], bodies[20]);
  twins.step();
  EXPECT_EQ(twins.world.last_step().end.size(), 37U);
  twins.step();
}

/// Its pairs end, and those of the new body begin, where it is one that the other was in too.
TEST(WorldsOfRanks, GiveTheIdOfARemovedBodyToAnotherInTheSameStep) {
  TwinWorlds twins;
  const std::vector<Body> bodies = row_of_spheres(40);
  twins.add(bodies);
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  for (const std::size_t at : {0, 13, 19, 20, 39}) twins.remove_and_add(ids[at], {Sphere(0.7), bodies[at].pose});
  twins.step();
  EXPECT_EQ(twins.world.last_step().end.size(), twins.world.last_step().begin.size());
  twins.step();
}

/// From 0.001 to 1000, each at the surface of one of any size, where it goes on to another now and then: a part of
/// space is smaller than some bodies, and has a thousand of others.
TEST(WorldsOfRanks, TellThePairsOfSizesOverSixDecades) {
  Random random(11);
  TwinWorlds twins;
  std::vector<double> sizes;
  std::vector<Body> bodies;
  const auto at_another = [&] {
    const std::size_t other = random.below(sizes.size());
    const Vec3 way = normalized(vector_in(random, -1, 1));
    return Pose{random_rotation(random), bodies[other].pose.offset + random.between(0.9, 1) * sizes[other] * way};
  };
  for (int i = 0; i < 150; ++i) {
    const double size = std::pow(10, i < 2 ? 6 * i - 3 : random.between(-3, 3));
    const Pose pose = i == 0 ? Pose{} : at_another();
    sizes.push_back(size);
    bodies.push_back({random_solid(size, random), pose});
  }
  twins.add(bodies);
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  std::map<BodyId, double> size_of;
  for (std::size_t i = 0; i < ids.size(); ++i) size_of[ids[i]] = sizes[i];
  double largest_ratio = 0;
  for (int frame = 0; frame < 20 && !HasFailure(); ++frame) {
    SCOPED_TRACE(frame);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (random.below(4) == 0) twins.move(ids[i], bodies[i].pose = at_another());
    twins.step();
    for (const PairReport& pair : twins.world.pairs())
      if (pair.in_contact)
        largest_ratio = std::max({largest_ratio, size_of[pair.a] / size_of[pair.b], size_of[pair.b] / size_of[pair.a]});
  }
  EXPECT_GT(largest_ratio, 3e5);
}

TEST(WorldsOfRanks, ShareTheWorkAndKeepFewGhosts) {
  Crowd crowd("uniform", 3000);
  std::vector<Body> bodies;
  for (const Aabb& box : crowd.boxes())
    bodies.push_back({Box(0.5 * (box.upper - box.lower)), Pose::translation(middle_of(box))});
  TwinWorlds twins;
  twins.add(bodies);
  twins.step();
  twins.step();
  const DistributedCosts& costs = twins.distributed.last_step().costs;
  EXPECT_LE(costs.imbalance, 1.2);
  EXPECT_LT(costs.ghosts, 900U);
  // Nothing has moved.
  EXPECT_EQ(costs.bytes_sent, 0U);
  // Six reductions and two barriers (docs/design/distributed.md, "A model of scale").
  EXPECT_EQ(costs.collectives, our_ranks().count() > 1 ? 8U : 0U);
  const DistributedSeconds& seconds = costs.seconds;
  EXPECT_GT(seconds.pairs, 0);
  EXPECT_GT(seconds.telling, 0);
  EXPECT_EQ(seconds.waiting > 0, our_ranks().count() > 1);
  EXPECT_LE(seconds.waiting,
            seconds.changes + seconds.division + seconds.sending + seconds.receiving + seconds.pairs + seconds.telling);
}

/// What one rank does wrong all ranks are told, in the same words; and go on.
TEST(WorldsOfRanks, TellAllRanksWhatOneDoesWrong) {
  TwinWorlds twins;
  twins.add(row_of_spheres(20));
  twins.step();
  DistributedWorld& world = twins.distributed;
  const int last = world.rank_count() - 1;
  const bool is_last = world.rank() == last;
  const auto fails = [&](const std::string& words) {
    const std::string message = message_of([&] { world.step(); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
    twins.step();
  };
  if (is_last) world.add(std::vector<GlobalBody>{{1007, {Sphere(1)}}});
  fails("body 1007 is given on rank " + std::to_string(last) + " and is there already, given on rank ");
  world.add(std::vector<GlobalBody>{{1, {Sphere(1)}}});
  if (world.rank_count() > 1) {
    fails("body 1 is given twice, on rank 0 and on rank 1");
  } else {
    world.add(std::vector<GlobalBody>{{1, {Sphere(1)}}});
    fails("rank 0: body 1 is given twice");
  }
  if (is_last) {
    Body bad{Sphere(1)};
    bad.margin = -1;
    bad.name = "gear";
    world.add(std::vector<GlobalBody>{{2, bad}});
  }
  fails("rank " + std::to_string(last) + ": body 2 (\"gear\"): body 0 of the 1 to add (\"gear\"): its margin is -1");
  const GlobalId stranger = 3;
  const Pose pose{};
  if (is_last) world.move({&stranger, 1}, {&pose, 1});
  fails("rank " + std::to_string(last) + ": body 3 does not live on this rank");
  for (const GlobalId id : world.bodies())
    if (id == 1014) {
      const Pose nowhere = Pose::translation(std::numeric_limits<double>::quiet_NaN(), 0, 0);
      world.move({&id, 1}, {&nowhere, 1});
    }
  fails("body 1014");
}

TEST(WorldsOfRanks, RefuseOptionsThatDiffer) {
  DistributedOptions options;
  if (our_ranks().rank() == our_ranks().count() - 1 && our_ranks().rank() > 0) options.most_imbalance = 1.5;
  const std::string message = message_of([&] { DistributedWorld world(all_ranks(), options); });
  EXPECT_EQ(message, our_ranks().count() == 1
                         ? "nothing was thrown"
                         : "rank " + std::to_string(our_ranks().count() - 1) +
                               ": most_imbalance is 1.5 here and 1.2 on rank 0; give all ranks the same options");
}

/// Each rank asks its own, and other numbers of them; the answers are those of the one World, in all that is told.
void compare_answers(TwinWorlds& twins, Random& own, std::size_t count) {
  const WorldQueries serial(twins.world);
  const auto same_first = [&]<class Answer>(const auto& expected, const std::optional<GlobalAnswer<Answer>>& found) {
    ASSERT_EQ(expected.has_value(), found.has_value());
    if (!expected) return;
    EXPECT_EQ(twins.id_of(expected->body), found->body);
    EXPECT_EQ(static_cast<const Answer&>(*expected), static_cast<const Answer&>(*found));
  };
  std::vector<Ray> rays;
  std::vector<SceneInstance> shapes;
  std::vector<MovingShape> moving;
  for (std::size_t i = 0; i < count; ++i) {
    rays.push_back({vector_in(own, -2, 8), vector_in(own, -9, 9)});
    shapes.push_back({random_convex_model(own), random_place("convex", own)});
    moving.push_back({shapes.back(), vector_in(own, -5, 5)});
  }
  const auto hits = twins.distributed.cast_ray_each(rays);
  const auto casts = twins.distributed.cast_shape_each(moving);
  const auto nearest = twins.distributed.nearest_each(shapes);
  const auto near = twins.distributed.nearest_each(shapes, 0.25);
  const auto within = twins.distributed.within_each(shapes, 0.5);
  const auto overlapping = twins.distributed.overlapping_each(shapes);
  const auto ids_of = [&](const std::vector<BodyId>& locals) {
    std::vector<GlobalId> ids;
    for (const BodyId local : locals) ids.push_back(twins.id_of(local));
    return ids;
  };
  for (std::size_t i = 0; i < count; ++i) {
    same_first(serial.cast_ray(rays[i]), hits[i]);
    same_first(serial.cast_shape(moving[i]), casts[i]);
    same_first(serial.nearest(shapes[i]), nearest[i]);
    same_first(serial.nearest(shapes[i], 0.25), near[i]);
    EXPECT_EQ(ids_of(serial.within(shapes[i], 0.5)), within[i]);
    EXPECT_EQ(ids_of(serial.overlapping(shapes[i])), overlapping[i]);
  }
}

TEST(QueriesOfRanks, AnswerAsTheSerialOnes) {
  Random random(3);
  TwinWorlds twins;
  std::vector<Body> bodies;
  for (int i = 0; i < 120; ++i) {
    bodies.push_back(random_body(i % 2 == 0 ? "whole" : "convex", random));
    // Twice in one place: the least id is told.
    if (i % 10 == 0) bodies.push_back(bodies.back());
  }
  twins.add(bodies);
  twins.step();
  const auto rank = static_cast<std::size_t>(twins.distributed.rank());
  Random own(100 + rank);
  std::size_t came = 0;
  for (int frame = 0; frame < 6; ++frame) {
    SCOPED_TRACE(frame);
    for (const BodyId id : twins.world.bodies())
      if (random.below(3) == 0) twins.move(id, random_place("convex", random));
    twins.step();
    came += twins.distributed.last_step().costs.came;
    compare_answers(twins, own, frame == 0 ? 30 + 10 * rank : 8 + 3 * rank);
  }
  EXPECT_EQ(came > 0, our_ranks().count() > 1);
  std::vector<Ray> rays(5, Ray{{}, {1, 0, 0}});
  if (rank == 0) rays[3].motion = {};
  expect_message([&] { static_cast<void>(twins.distributed.cast_ray_each(rays)); },
                 "rank 0: ray 3: a ray: its motion is zero");
}

}  // namespace
}  // namespace toccata::test
