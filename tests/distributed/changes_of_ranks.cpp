// What else may be said of the bodies of a DistributedWorld: rules for two, motions, other vertices; the k nearest; and
// its way through a folder.
#include <mpi.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "distributed/twin_worlds.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/distance.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

/// Each pair of boxes is looked at by one rank, in the first step and while nothing moves.
TEST(ChangesOfRanks, LookAtEachPairOnce) {
  TwinWorlds twins;
  std::vector<Body> bodies = row_of_spheres(60);
  for (Body& body : bodies) body.margin = 1;  // several pairs reach over each border
  twins.add(bodies);
  for (int step = 0; step < 3; ++step) {
    twins.step();
    std::vector<std::size_t> all = gathered(std::vector{twins.distributed.last_step().costs.candidates});
    std::size_t sum = 0;
    for (const std::size_t one : all) sum += one;
    EXPECT_EQ(sum, twins.world.last_step().candidates);
  }
}

/// Margins of rules reach over all ranks, and end; so do those of bodies that are removed.
TEST(ChangesOfRanks, FollowRulesForTwo) {
  TwinWorlds twins;
  twins.add(row_of_spheres(40));
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  twins.set_rule({ids[2], ids[39], false, 100});
  twins.set_rule({ids[3], ids[4], true});
  twins.set_rule({ids[39], ids[1], false, 2});
  twins.step();
  EXPECT_EQ(twins.world.last_step().begin.size(), 1U);
  EXPECT_EQ(twins.world.last_step().end.size(), 1U);
  twins.move(ids[2], Pose::translation(-7, 0, 0));
  twins.step();
  twins.set_rule({ids[2], ids[39]});
  twins.set_rule({ids[3], ids[4], false, 0});
  twins.step();
  EXPECT_EQ(twins.world.last_step().end.size(), 1U);
  // The rule ends with the body: who has its id then has none.
  twins.set_rule({ids[7], ids[8], true});
  twins.step();
  twins.remove_and_add(ids[7], row_of_spheres(8)[7]);
  twins.step();
  EXPECT_EQ(twins.world.pairs().size(), 37U);
}

class RulesOfRanks : public testing::TestWithParam<std::string_view> {};

TEST_P(RulesOfRanks, TellTheSerialPairs) {
  const std::string_view family = GetParam();
  Random random(9);
  TwinWorlds twins;
  std::vector<Body> bodies;
  for (int i = 0; i < 40; ++i) bodies.push_back(random_body(family, random));
  twins.add(bodies);
  for (int frame = 0; frame < 40; ++frame) {
    SCOPED_TRACE(frame);
    twins.step();
    if (HasFailure()) return;
    for (const BodyId id : twins.world.bodies()) {
      const std::uint64_t chance = random.below(20);
      if (chance == 0)
        twins.remove(id);
      else if (chance == 1)
        twins.remove_and_add(id, random_body(family, random));
      else if (chance < 6)
        twins.move(id, random_place(family, random));
    }
    const std::vector<BodyId> left = twins.world.bodies();
    if (left.size() < 8) break;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t first = random.below(left.size() - 3) + i;
      PairRule rule{left[i], left[std::max(first, i + 1)]};
      rule.excluded = random.below(3) == 0;
      if (random.below(2) == 0) rule.margin = 0.5 * static_cast<double>(random.below(9));
      twins.set_rule(rule);
    }
    twins.add(std::vector<Body>(random.below(5), random_body(family, random)));
  }
}

INSTANTIATE_TEST_SUITE_P(Families, RulesOfRanks, testing::Values("convex", "whole", "any"));

TEST(ChangesOfRanks, TellAllRanksWhatIsNoRule) {
  TwinWorlds twins;
  twins.add(row_of_spheres(20));
  twins.step();
  DistributedWorld& world = twins.distributed;
  const bool is_last = world.rank() == world.rank_count() - 1;
  const auto refused = [&](const GlobalPairRule& rule, const std::string& words) {
    if (is_last) world.set_rules({&rule, 1});
    expect_message([&] { world.step(); }, words);
    twins.step();
  };
  refused({1000, 5, true}, "the rule for body 1000 and body 5: body 5 lives on no rank");
  refused({1000, 1000, true}, ": a rule is given for body 1000 with itself");
  refused({1000, 1007, false, -1}, "the rule for body 1000 and body 1007: its margin is -1");
  const GlobalPairRule one{1000, 1007, true}, other{1007, 1000, false, 1};
  if (world.rank() == 0) world.set_rules({&one, 1});
  refused(other, "the rule for body 1007 and body 1000 is given twice");
}

/// Small bodies cross the parts of all ranks in one step: nothing tunnels, and what has met is told once.
TEST(ChangesOfRanks, MoveAlongMotions) {
  Random random(3);
  DistributedOptions options;
  TwinWorlds twins(options);
  std::vector<Body> bodies;
  for (int i = 0; i < 60; ++i)
    bodies.push_back({i % 3 == 0 ? random_convex_model(random) : Model(Sphere(0.3)), random_place("convex", random)});
  for (Body& body : bodies) body.margin = random.below(4) == 0 ? 0.5 : 0;
  twins.add(bodies);
  const std::vector<BodyId> ids = twins.world.bodies();
  std::size_t passed = 0;
  for (int frame = 0; frame < 25; ++frame) {
    SCOPED_TRACE(frame);
    twins.step();
    if (HasFailure()) return;
    for (const PairReport& pair : twins.world.pairs()) passed += pair.details ? 1 : 0;
    for (const BodyId id : ids) {
      const Pose& from = twins.world.body(id).pose;
      const std::uint64_t chance = random.below(12);
      if (chance == 0) {
        twins.move_along(id, RigidMotion::between(from, random_place("convex", random)));
      } else if (chance == 1) {
        twins.move_along(id, RigidMotion::straight(from, vector_in(random, -6, 6)));
        if (random.below(4) == 0) twins.move(id, from);
      } else if (chance == 2) {
        twins.move(id, random_place("convex", random));
        if (random.below(4) == 0) twins.move_along(id, RigidMotion::screw(from, random_place("convex", random)));
      } else if (chance == 3 && random.below(4) == 0) {
        twins.replace(id, {random_convex_model(random), random_place("convex", random)});
      }
    }
  }
  EXPECT_GT(passed, 20U);
  twins.step();
  DistributedWorld& world = twins.distributed;
  std::vector<GlobalId> here = world.bodies();
  const MotionKey keys[] = {{0, {}}, {0.5, Pose::translation(1, 0, 0)}, {1, Pose::translation(0, 1, 0)}};
  const std::vector<RigidMotion> motions(here.size(), RigidMotion::through(keys));
  world.move_along(here, motions);
  expect_message([&] { world.step(); }, "its motion is of several pieces; give one move for a step");
  twins.step();
}

std::size_t ghosts_of_all(const TwinWorlds& twins) {
  std::size_t sum = 0;
  for (const std::size_t one : gathered(std::vector{twins.distributed.last_step().costs.ghosts})) sum += one;
  return sum;
}

/// On its way a body is on all ranks that it passes, and no longer when the step is over.
TEST(ChangesOfRanks, AreFreeOfABodyThatHasPassed) {
  TwinWorlds twins;
  std::vector<Body> bodies = row_of_spheres(40);
  bodies.push_back({Sphere(0.1), Pose::translation(0, 2, 0)});
  twins.add(bodies);
  twins.step();
  const std::size_t before = ghosts_of_all(twins);
  twins.move_along(twins.world.bodies().back(), RigidMotion::straight(bodies.back().pose, {39, 0, 0}));
  twins.step();
  EXPECT_EQ(ghosts_of_all(twins), before + static_cast<std::size_t>(our_ranks().count()) - 1);
  twins.step();
  EXPECT_EQ(ghosts_of_all(twins), before);
}

TEST(ChangesOfRanks, DeformMeshes) {
  Random random(4);
  TwinWorlds twins;
  const Model ball(icosphere_mesh(0.8, 2));
  std::vector<Body> bodies;
  for (int i = 0; i < 30; ++i) bodies.push_back({ball, random_place("convex", random)});
  twins.add(bodies);
  const std::vector<BodyId> ids = twins.world.bodies();
  for (int frame = 0; frame < 15; ++frame) {
    SCOPED_TRACE(frame);
    twins.step();
    if (HasFailure()) return;
    for (const BodyId id : ids) {
      if (random.below(4) == 0) {
        std::vector<Vec3> vertices;
        const double factor = random.between(0.5, 1.5);
        for (const Vec3& vertex : twins.world.body(id).model.mesh().vertices()) vertices.push_back(factor * vertex);
        twins.deform(id, vertices);
      }
      if (random.below(4) == 0) twins.move(id, random_place("convex", random));
    }
  }
  twins.step();
  DistributedWorld& world = twins.distributed;
  const std::vector<GlobalId> here = world.bodies();
  if (!here.empty()) world.deform(here.front(), {Vec3{}});
  expect_message([&] { world.step(); }, "body ");
  twins.step();
}

using NearBodies = std::vector<GlobalAnswer<Distance>>;

/// By the distance of each body.
NearBodies nearest_of_all(const TwinWorlds& twins, const SceneInstance& shape, std::size_t k, double max_distance) {
  NearBodies all;
  for (const BodyId id : twins.world.bodies()) {
    const Body& body = twins.world.body(id);
    const PairQuery query{shape.pose, body.pose, shape.solid, body.solid};
    if (const auto found = distance_within(shape.model, body.model, max_distance, query))
      all.push_back({*found, twins.id_of(id)});
  }
  const auto key = [](const GlobalAnswer<Distance>& one) { return std::tie(one.upper, one.body); };
  std::ranges::sort(all, {}, key);
  all.resize(std::min(k, all.size()));
  return all;
}

TEST(ChangesOfRanks, TellTheNearestBodies) {
  TwinWorlds twins;
  Random random(6);
  std::vector<Body> bodies;
  for (int i = 0; i < 80; ++i) {
    bodies.push_back(random_body(i % 2 == 0 ? "whole" : "convex", random));
    if (i % 10 == 0) bodies.push_back(bodies.back());
  }
  twins.add(bodies);
  twins.step();
  Random own(static_cast<std::uint64_t>(100 + twins.distributed.rank()));
  std::vector<SceneInstance> shapes;
  for (int i = 0; i < 12; ++i) shapes.push_back({random_convex_model(own), random_place("convex", own)});
  shapes.push_back({Point{}, random_place("convex", own)});
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  for (const auto& [k, max_distance] :
       {std::pair<std::size_t, double>{0, everywhere}, {1, everywhere}, {7, everywhere}, {500, everywhere}, {9, 0.5}}) {
    const auto found = twins.distributed.nearest_bodies_each(shapes, k, max_distance);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      EXPECT_EQ(found[i], nearest_of_all(twins, shapes[i], k, max_distance)) << k << " of shape " << i;
  }
  expect_message([&] { static_cast<void>(twins.distributed.nearest_bodies_each(shapes, 1, -1)); },
                 "rank 0: shape 0: the greatest distance is -1");
}

namespace fs = std::filesystem;

/// The same name on all ranks, which share a machine; there is nothing yet.
fs::path new_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("toccata-{}-of-{}", name, our_ranks().count());
  if (our_ranks().rank() == 0) fs::remove_all(folder);
  static_cast<void>(gathered(std::vector<int>{}));
  return folder;
}

void let_live(TwinWorlds& twins, Random& random, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    twins.step();
    for (const BodyId id : twins.world.bodies()) {
      const std::uint64_t chance = random.below(12);
      if (chance == 0) twins.replace(id, random_body("any", random));
      if (chance > 8) twins.move(id, random_place("any", random));
    }
  }
}

/// What is loaded goes on as what was saved, on as many ranks and on fewer.
TEST(ChangesOfRanks, ComeBackFromAFolder) {
  Random random(8);
  TwinWorlds twins;
  std::vector<Body> bodies;
  for (int i = 0; i < 60; ++i) bodies.push_back(random_body("any", random));
  twins.add(bodies);
  twins.step();
  const std::vector<BodyId> ids = twins.world.bodies();
  twins.set_rule({ids[0], ids[59], false, 30});
  twins.set_rule({ids[1], ids[2], true});
  let_live(twins, random, 5);
  expect_message([&] { twins.distributed.save(new_folder("early")); }, "changes are noted that no step has made");
  twins.step();
  const fs::path folder = new_folder("checkpoint");
  twins.distributed.save(folder);
  const std::vector<ToldPair> saved = TwinWorlds::all_told(twins.distributed.pairs());
  const int rank = our_ranks().rank(), count = our_ranks().count();
  const bool takes_part = rank < std::max(1, count / 2);
  MPI_Comm fewer = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, takes_part ? 0 : 1, rank, &fewer);
  std::vector<ToldPair> own_persist;
  if (takes_part) {
    DistributedWorld loaded = DistributedWorld::load({MPI_Comm_c2f(fewer)}, folder);
    EXPECT_TRUE(loaded.last_step().begin.empty());
    loaded.step();
    EXPECT_TRUE(loaded.last_step().begin.empty() && loaded.last_step().end.empty());
    own_persist = TwinWorlds::own_told(loaded.last_step().persist);
  }
  std::vector<ToldPair> all = gathered(own_persist);
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, saved);
  MPI_Comm_free(&fewer);
  expect_message([&] { twins.distributed.save(folder); }, "there is something already");
  // From here on it lives on as if it had never been away.
  twins.distributed = DistributedWorld::load(all_ranks(), folder);
  let_live(twins, random, 4);
}

/// Half of the ranks have all bodies and save them; all ranks load them.
TEST(ChangesOfRanks, ComeBackOnMoreRanks) {
  const int rank = our_ranks().rank(), count = our_ranks().count();
  const bool takes_part = rank < std::max(1, count / 2);
  const fs::path folder = new_folder("of-fewer");
  MPI_Comm fewer = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, takes_part ? 0 : 1, rank, &fewer);
  std::vector<ToldPair> own_saved;
  if (takes_part) {
    Random random(12);
    DistributedWorld saved({MPI_Comm_c2f(fewer)});
    for (GlobalId id = 0; id < 60; ++id) {
      const GlobalBody body{7 * id, random_body("any", random)};
      if (rank == 0) saved.add({&body, 1});
    }
    const GlobalPairRule far{0, 7 * 59, false, 30};
    if (rank == 0) saved.set_rules({&far, 1});
    saved.step();
    saved.save(folder);
    own_saved = TwinWorlds::own_told(saved.pairs());
  }
  std::vector<ToldPair> expected = gathered(own_saved);
  std::sort(expected.begin(), expected.end());
  MPI_Comm_free(&fewer);
  DistributedWorld loaded = DistributedWorld::load(all_ranks(), folder);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(TwinWorlds::all_told(loaded.pairs()), expected);
  EXPECT_EQ(gathered(loaded.bodies()).size(), 60U);
  EXPECT_EQ(gathered(std::vector<int>(loaded.bodies().empty() ? 0 : 1)).size(), static_cast<std::size_t>(count))
      << "each rank has some";
  loaded.step();
  EXPECT_TRUE(loaded.last_step().begin.empty() && loaded.last_step().end.empty());
  EXPECT_EQ(TwinWorlds::all_told(loaded.last_step().persist), expected);
}

TEST(ChangesOfRanks, RefuseADamagedFolder) {
  TwinWorlds twins;
  twins.add(row_of_spheres(9));
  twins.step();
  const fs::path folder = new_folder("damaged");
  const auto load = [&] { static_cast<void>(DistributedWorld::load(all_ranks(), folder)); };
  expect_message(load, "index.toccata: there is no such file that can be read");
  twins.distributed.save(folder);
  const fs::path part = folder / "bodies-00000.toccata";
  const auto on_first = [&](const std::function<void()>& damage) {
    if (our_ranks().rank() == 0) damage();
    static_cast<void>(gathered(std::vector<int>{}));
  };
  on_first([&] {
    std::fstream file(part, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-3, std::ios::end);
    file.put('x');
  });
  expect_message(load, "bodies-00000.toccata: it is damaged");
  on_first([&] { fs::resize_file(part, fs::file_size(part) - 1); });
  expect_message(load, "bodies-00000.toccata: it ends too early");
  on_first([&] { std::ofstream(part) << "no checkpoint, but a file that is long enough to be looked at"; });
  expect_message(load, "bodies-00000.toccata: this is no checkpoint");
}

}  // namespace
}  // namespace toccata::test
