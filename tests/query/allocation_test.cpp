#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/methods.hpp"
#include "toccata/toccata.hpp"

// Every operator new of this program is counted. The sanitizers bring their own.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

std::atomic<std::size_t> of_all_threads = 0;
thread_local std::size_t of_this_thread = 0;  // idle threads of earlier tests may allocate at any time

void* allocate(std::size_t size, std::size_t alignment) {
  ++of_all_threads;
  ++of_this_thread;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return operator new(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace toccata {
namespace {

enum class Counted { this_thread, all_threads };

template <class Call>
std::size_t allocations_of(const Call& call, Counted counted = Counted::this_thread) {
  const auto now = [&] { return counted == Counted::this_thread ? of_this_thread : of_all_threads.load(); };
  const std::size_t before = now();
  call();
  return now() - before;
}

/// Asks once with a new workspace, and counts what the next times take; at every SIMD level.
template <class Ask>
void expect_none_when_warm(const std::string& what, const Ask& ask, Counted counted = Counted::this_thread) {
  test::at_every_simd_level([&](SimdLevel level) {
    Workspace workspace;
    EXPECT_GT(allocations_of([&] { Workspace fresh; }), 0U) << "the counter counts";
    ask(workspace);
    for (int again = 0; again < 3; ++again)
      EXPECT_EQ(allocations_of([&] { ask(workspace); }, counted), 0U) << what << ", level " << name_of(level);
  });
}

/// Poses of B for which the meshes below are apart, meet, and lie one within the other.
struct Meshes {
  Model ring{torus_mesh({.radius = 1, .tube_radius = 0.25})};
  Model ball{icosphere_mesh(0.9, 4)};
  Model small{icosphere_mesh(0.2, 2)};
  PairQuery apart{};
  PairQuery meeting{.pose_b = Pose::translation(0.3, 0.1, 0)};
  PairQuery apart_surfaces{.solid_a = Solid::none, .solid_b = Solid::none};
  PairQuery intersecting_surfaces{
      .pose_b = Pose::translation(0.3, 0.1, 0), .solid_a = Solid::none, .solid_b = Solid::none};
};

TEST(Allocation, AWarmWorkspaceAnswersWithoutForMeshes) {
  const Meshes m;
  expect_none_when_warm("overlap, apart", [&](Workspace& w) { EXPECT_FALSE(overlap(m.ring, m.small, m.apart, w)); });
  expect_none_when_warm("overlap, meeting", [&](Workspace& w) { EXPECT_TRUE(overlap(m.ring, m.ball, m.meeting, w)); });
  expect_none_when_warm("overlap, nested", [&](Workspace& w) { EXPECT_TRUE(overlap(m.ball, m.small, m.apart, w)); });
  expect_none_when_warm("first contact",
                        [&](Workspace& w) { EXPECT_TRUE(first_contact(m.ring, m.ball, m.meeting, w)); });
  expect_none_when_warm("contacts",
                        [&](Workspace& w) { EXPECT_GT(contacts(m.ring, m.ball, m.meeting, w).size(), 100U); });
  const PairQuery apart_far{.pose_b = Pose::translation(5, 1, 0)};
  expect_none_when_warm("distance, apart",
                        [&](Workspace& w) { EXPECT_GT(distance(m.ring, m.ball, apart_far, w).lower, 1); });
  expect_none_when_warm("distance, nested surfaces",
                        [&](Workspace& w) { EXPECT_GT(distance(m.ball, m.small, m.apart_surfaces, w).lower, 0.5); });
  expect_none_when_warm("distance, meeting",
                        [&](Workspace& w) { EXPECT_EQ(distance(m.ring, m.ball, m.meeting, w).upper, 0); });
  expect_none_when_warm("relation of surfaces, meeting", [&](Workspace& w) {
    EXPECT_EQ(relation(m.ring, m.ball, m.intersecting_surfaces, w).kind, RelationKind::crossing);
  });
  expect_none_when_warm("relation of surfaces, apart", [&](Workspace& w) {
    EXPECT_EQ(relation(m.ring, m.small, m.apart_surfaces, w).kind, RelationKind::apart);
  });
}

TEST(Allocation, AWarmWorkspaceAnswersWithoutOnTwoThreads) {
  const Model a(icosphere_mesh(1, 5)), b(icosphere_mesh(1, 5));
  const PairQuery crossing{.pose_b = Pose::translation(0.3, 0.1, 0), .threads = 2};
  EXPECT_GT(contacts(a, b, crossing).size(), 500U);
  const auto expect_none = [](const std::string& what, const auto& ask) {
    expect_none_when_warm(what, ask, Counted::all_threads);
  };
  expect_none("contacts", [&](Workspace& w) { static_cast<void>(contacts(a, b, crossing, w)); });
  // Every triangle meets its twin and its neighbours in special position: all meetings are kept.
  const Model c(icosphere_mesh(1, 3));
  const PairQuery equal{.threads = 2};
  EXPECT_GT(contacts(c, c, equal).size(), 10'000U);
  expect_none("contacts of equal meshes", [&](Workspace& w) { static_cast<void>(contacts(c, c, equal, w)); });
}

TEST(Allocation, AWarmWorkspaceAnswersWithoutForMeshesInSpecialPosition) {
  const Model box(test::box_between({0, 0, 0}, {1, 1, 1}));
  expect_none_when_warm("overlap", [&](Workspace& w) { EXPECT_TRUE(overlap(box, box, {}, w)); });
  expect_none_when_warm("contacts", [&](Workspace& w) { EXPECT_GT(contacts(box, box, {}, w).size(), 12U); });
}

TEST(Allocation, AWarmWorkspaceAnswersWithoutWithinOneMesh) {
  Random random(1);
  const Model soup(test::random_soup(random, 200, 0.2, 8));
  const Pose pose = Pose::translation(1, 2, 3);
  expect_none_when_warm("self_overlap", [&](Workspace& w) { EXPECT_TRUE(self_overlap(soup, pose, w)); });
  expect_none_when_warm("self_contacts", [&](Workspace& w) { EXPECT_GT(self_contacts(soup, pose, w).size(), 10U); });
}

TEST(Allocation, AWarmWorkspaceAnswersWithoutForOtherShapes) {
  const Meshes m;
  const Model box(Box{{0.5, 0.5, 0.5}}), floor(HalfSpace{{0, 0, 0}, {0, 0, 1}});
  const std::vector<CompoundPart> parts{{Sphere{0.3}, Pose::translation(1, 0, 0)}, {Box{{0.2, 0.2, 0.2}}, Pose{}}};
  const Model pieces{Compound(parts)};
  const PairQuery query{.pose_b = Pose::translation(0.6, 0.1, 0.05)};
  for (const Model* b : {&box, &floor, &pieces}) {
    const std::string name(name_of(b->shape()));
    expect_none_when_warm("overlap of the ring and a " + name,
                          [&](Workspace& w) { EXPECT_TRUE(overlap(m.ring, *b, query, w)); });
    expect_none_when_warm("contacts of the ring and a " + name,
                          [&](Workspace& w) { EXPECT_FALSE(contacts(m.ring, *b, query, w).empty()); });
    expect_none_when_warm("overlap of a box and a " + name,
                          [&](Workspace& w) { EXPECT_TRUE(overlap(box, *b, query, w)); });
    expect_none_when_warm("contacts of a box and a " + name,
                          [&](Workspace& w) { EXPECT_FALSE(contacts(box, *b, query, w).empty()); });
  }
}

TEST(Allocation, AWarmWorkspaceAnswersWithoutForRoundSides) {
  const Meshes m;
  const Model egg(Ellipsoid({0.2, 0.3, 0.4}));
  const PairQuery above{.pose_a = Pose::translation(0, 0, 3)}, beside{.pose_b = Pose::translation(0, 0.1, 1.5)};
  expect_none_when_warm("cast of an egg", [&](Workspace& w) {
    EXPECT_TRUE(cast_shape(egg, {0.9, 0.1, -4}, m.ring, above, w));
  });
  expect_none_when_warm("distance of an egg",
                        [&](Workspace& w) { EXPECT_GT(distance(m.ring, egg, beside, w).lower, 0.5); });
}

TEST(Allocation, ABatchAllocatesNoMoreForMoreQueries) {
  const Meshes m;
  const auto count = [&](std::size_t queries) {
    const std::vector<PairQuery> poses(queries, m.meeting);
    const BatchOptions options{.threads = 1};
    return std::array{allocations_of([&] {
                        static_cast<void>(overlap_each({m.ring, m.ball, poses}, options));
                      }),
                      allocations_of([&] {
                        static_cast<void>(count_contacts_each({m.ring, m.ball, poses}, options));
                      })};
  };
  static_cast<void>(count(1));  // what the models find out once
  EXPECT_EQ(count(10), count(40));
}

}  // namespace
}  // namespace toccata

#endif
