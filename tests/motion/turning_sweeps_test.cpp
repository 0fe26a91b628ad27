#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "support/rigid_cases.hpp"

namespace toccata::test {
namespace {

const RigidFamily& family_of(const std::string& name) {
  for (const RigidFamily& family : rigid_families())
    if (family.name == name) return family;
  throw std::invalid_argument("there is no family of moving bodies '" + name + "'");
}

std::vector<RigidCase> drawn_cases(const std::string& family, int count) {
  Random random(31);
  std::vector<RigidCase> cases;
  for (int i = 0; i < count; ++i) cases.push_back(family_of(family).draw(random));
  return cases;
}

TEST(TurningSweeps, NeitherAMirrorNorAnotherOrderOfShapesAndVerticesChangesTheAnswer) {
  for (const RigidFamily& family : rigid_families())
    for (const RigidCase& pair : drawn_cases(family.name, 4)) {
      const auto changed = changed_sweep(pair, swept(pair));
      EXPECT_FALSE(changed) << family.name << ": " << *changed;
    }
}

TEST(TurningSweeps, HaveTheSameBitsOnAnyNumberOfThreads) {
  std::vector<RigidCase> pairs;
  for (const RigidFamily& family : rigid_families())
    for (const RigidCase& pair : drawn_cases(family.name, 4)) pairs.push_back(pair);
  std::vector<std::optional<ShapeHit>> alone;
  for (const RigidCase& pair : pairs) alone.push_back(swept(pair));
  for (const std::size_t count : {2U, 5U}) {
    std::vector<std::optional<ShapeHit>> together(pairs.size());
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < count; ++t)
      threads.emplace_back([&, t] {
        // What a thread keeps from one question to the next is another history in each.
        Workspace workspace;
        for (std::size_t i = t; i < pairs.size(); i += count) {
          const RigidCase& pair = pairs[i];
          together[i] =
              sweep(Model(pair.a.shape), pair.a.motion(), Model(pair.b.shape), pair.b.motion(), {}, workspace);
        }
      });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(together, alone) << count;
  }
}

/// A depth that is allowed is as if the plate lay so much lower: nothing else parts the two sooner.
TEST(TurningSweeps, WhatLandsAndTurnsSinksAsDeepAsItMay) {
  int hits = 0;
  for (const double depth : {0x1p-30, 0x1p-12, 0x1p-5})
    for (const RigidCase& landing : drawn_cases("landings", 6)) {
      RigidCase lower = landing;
      lower.b.start.offset.z = -depth;
      const std::optional<ShapeHit> hit = sweep(Model(landing.a.shape), landing.a.motion(), Model(landing.b.shape),
                                                landing.b.motion(), {.stop_before = -depth});
      const auto wrong = wrong_sweep(lower, hit);
      EXPECT_FALSE(wrong) << depth << ": " << *wrong;
      hits += hit.has_value();
    }
  EXPECT_GT(hits, 4);
}

TEST(TurningSweeps, AHalfSpaceThatTurnsIsMetAsTheOracleTells) {
  int hits = 0, free = 0;
  for (const RigidCase& pair : drawn_cases("half-spaces", 30)) {
    const RigidCase exchanged{pair.b, pair.a};
    for (const RigidCase& asked : {pair, exchanged}) {
      const std::optional<ShapeHit> hit = swept(asked);
      const auto wrong = wrong_sweep(asked, hit);
      EXPECT_FALSE(wrong) << *wrong;
      ++(hit.has_value() && hit->lower > 0 ? hits : free);
    }
  }
  EXPECT_GT(hits, 4);
  EXPECT_GT(free, 4);
}

TEST(TurningSweeps, BallsThatSpinCloseBesideEachOtherAreAnsweredAsTheOracleTells) {
  for (const RigidCase& pair : drawn_cases("spinning balls", 16)) {
    const std::optional<ShapeHit> hit = swept(pair);
    EXPECT_NE(hit->status, Status::not_converged);
    const auto wrong = wrong_sweep(pair, hit);
    EXPECT_FALSE(wrong) << *wrong;
  }
}

}  // namespace
}  // namespace toccata::test
