// What goes wrong on one rank is told by all, and who stays away lets nobody wait for ever.
#include <chrono>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "distributed/before_mpi.hpp"
#include "distributed/twin_worlds.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::test {
namespace {

int last_rank() { return our_ranks().count() - 1; }

TEST(FaultsOfRanks, TellThatMpiIsNotInitialised) {
  EXPECT_EQ(told_before_mpi(), "MPI is not initialised: call MPI_Init or MPI_Init_thread first");
}

TEST(FaultsOfRanks, TellThatACommunicatorIsNone) {
  expect_message([] { DistributedWorld world(no_ranks()); }, "the communicator is none");
}

TEST(FaultsOfRanks, TellEachOptionThatDiffers) {
  using Change = std::function<void(DistributedOptions&)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"world.relation is 1 here and 0", [](DistributedOptions& one) { one.world.relation = true; }},
      {"world.distance is 1 here and 0", [](DistributedOptions& one) { one.world.distance = true; }},
      {"world.contacts is 1 here and 0", [](DistributedOptions& one) { one.world.contacts = true; }},
      {"world.manifold is 1 here and 0", [](DistributedOptions& one) { one.world.manifold = true; }},
      {"world.penetration is 1 here and 0", [](DistributedOptions& one) { one.world.penetration = true; }},
      {"world.kinematic_pairs is 0 here and 1", [](DistributedOptions& one) { one.world.kinematic_pairs = false; }},
      {"most_imbalance is 3 here and 1.2", [](DistributedOptions& one) { one.most_imbalance = 3; }}};
  for (const auto& [words, change] : changes) {
    DistributedOptions options;
    if (last_rank() > 0 && our_ranks().rank() == last_rank()) change(options);
    const std::string message = message_of([&] { DistributedWorld world(all_ranks(), options); });
    EXPECT_EQ(message, last_rank() == 0
                           ? "nothing was thrown"
                           : fmt::format("rank {}: {} on rank 0; give all ranks the same options", last_rank(), words));
  }
  // No answer depends on these.
  DistributedOptions options;
  options.world.threads = 1 + our_ranks().rank();
  options.patience_seconds = 200 + our_ranks().rank();
  options.world.broad_phase = our_ranks().rank() == 0 ? BroadPhaseMethod::automatic : BroadPhaseMethod::dynamic_tree;
  EXPECT_EQ(message_of([&] { DistributedWorld world(all_ranks(), options); }), "nothing was thrown");
}

TEST(FaultsOfRanks, RefuseOptionsThatAreNone) {
  DistributedOptions options;
  options.most_imbalance = 1;
  expect_message([&] { DistributedWorld world(all_ranks(), options); },
                 "rank 0: most_imbalance is 1; it has to be above 1");
  options = {};
  options.world.space_time = true;
  expect_message([&] { DistributedWorld world(all_ranks(), options); },
                 "rank 0: world.space_time is of one World alone");
}

/// Also where one rank has no memory left.
TEST(FaultsOfRanks, TellThatAPartFindsNoMemory) {
  const auto parts = static_cast<std::size_t>(2 * our_ranks().count());
  const auto make = [&] {
    DistributedScene scene(all_ranks(), parts, [&](std::size_t part) -> std::vector<SceneInstance> {
      if (part + 1 == parts) throw std::bad_alloc();
      return {{Sphere(1)}};
    });
  };
  EXPECT_EQ(message_of(make), fmt::format("rank {}: out of memory", last_rank()));
}

/// A file that was there when it was looked at, and is gone when its pairs are decided.
TEST(FaultsOfRanks, TellOfAPartThatIsGone) {
  bool is_gone = false;
  DistributedScene scene(all_ranks(), 40, [&](std::size_t part) -> std::vector<SceneInstance> {
    if (is_gone && part == 39) throw Error("rack.stl: there is no such file");
    return {{Box({0.6, 0.6, 0.6}), Pose::translation(static_cast<double>(part), 0, 0)}};
  });
  is_gone = true;
  const std::string message = message_of([&] { static_cast<void>(scene.check()); });
  EXPECT_NE(message.find(": rack.stl: there is no such file"), std::string::npos) << message;
  std::vector<char> letters(message.begin(), message.end()), others = gathered(letters);
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_EQ(others[i], letters[i % letters.size()]);
  is_gone = false;
  EXPECT_EQ(scene.check().pairs.size(), our_ranks().rank() == 0 ? 39U : 0U);
}

/// The report would be of two questions.
TEST(FaultsOfRanks, TellThatAScenesOptionsDiffer) {
  DistributedScene scene(all_ranks(), 4, [](std::size_t part) -> std::vector<SceneInstance> {
    return {{Box({0.6, 0.6, 0.6}), Pose::translation(static_cast<double>(part), 0, 0)}};
  });
  if (last_rank() == 0) return;
  const auto differ = [&](const auto& change) {
    CheckOptions options;
    options.threads = our_ranks().rank() + 1;  // each its own
    if (our_ranks().rank() == last_rank()) change(options);
    return message_of([&] { static_cast<void>(scene.check(options)); });
  };
  const std::string words = fmt::format("rank {} checks with other options than rank 0", last_rank());
  EXPECT_EQ(differ([](CheckOptions&) {}), "nothing was thrown");
  EXPECT_EQ(differ([](CheckOptions& options) { options.clearance = 0; }), words);
  EXPECT_EQ(differ([](CheckOptions& options) { options.tolerance = 1; }), words);
  EXPECT_EQ(differ([](CheckOptions& options) { options.volume = true; }), words);
  EXPECT_EQ(differ([](CheckOptions& options) { options.depth.precision = 0.2; }), words);
  EXPECT_EQ(differ([](CheckOptions& options) { options.pair_clearances = {{0, 1, 2}}; }), words);
}

/// The others say so after their patience, and after that at once.
TEST(FaultsOfRanks, DoNotWaitForEverForARankThatStaysAway) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  DistributedOptions options;
  options.patience_seconds = 1;
  DistributedWorld world(all_ranks(), options);
  const bool stays_away = last_rank() > 0 && our_ranks().rank() == last_rank();
  if (last_rank() > 0 && !stays_away) {
    const std::string words = fmt::format(
        "rank {}: the other ranks have not answered for 1 s: one of them has ended, or "
        "calls something else",
        our_ranks().rank());
    const GlobalBody body{static_cast<GlobalId>(our_ranks().rank()), {Sphere(1)}};
    world.add({&body, 1});
    const Clock::time_point begin = Clock::now();
    EXPECT_EQ(message_of([&] { world.step(); }), words);
    EXPECT_GE(seconds_since(begin), 1);
    EXPECT_LT(seconds_since(begin), 10);
    const Clock::time_point again = Clock::now();
    expect_message([&] { world.step(); }, "the other ranks have not answered for 1 s");
    expect_message([&] { static_cast<void>(world.within_each({}, 1)); }, "the other ranks have not answered for 1 s");
    EXPECT_LT(seconds_since(again), 0.9);
  }
  static_cast<void>(gathered(std::vector<int>{}));
}

}  // namespace
}  // namespace toccata::test
