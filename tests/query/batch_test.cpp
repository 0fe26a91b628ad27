#include "toccata/query/batch.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

std::vector<PairQuery> random_queries(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<PairQuery> queries;
  for (std::size_t i = 0; i < count; ++i)
    queries.push_back(test::random_poses(test::pose_families()[i % test::pose_families().size()], random));
  return queries;
}

Model soup(std::uint64_t seed) {
  Random random(seed);
  return Model(test::random_soup(random, 40, 0.2, 8));
}

TEST(Batch, AnswersAsTheSingleQuestionsForAnyNumberOfThreads) {
  const Model a = soup(1), b = soup(2);
  const std::vector<PairQuery> queries = random_queries(3, 60);
  for (const int threads : {1, 2, 5}) {
    const BatchOptions options{.threads = threads};
    const auto overlaps = overlap_each({a, b, queries}, options);
    const auto relations = relation_each({a, b, queries}, options);
    const auto found = contacts_each({a, b, queries}, options);
    const auto counts = count_contacts_each({a, b, queries}, options);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SCOPED_TRACE("query " + std::to_string(i) + ", threads " + std::to_string(threads));
      const auto single = contacts(a, b, queries[i]);
      EXPECT_EQ(overlaps[i], overlap(a, b, queries[i]));
      EXPECT_EQ(relations[i], relation(a, b, queries[i]));
      EXPECT_TRUE(test::same(found[i], single));
      EXPECT_EQ(counts[i], (ContactCount{single.size(), single.size()})) << "every triangle is a face here";
      hits += single.empty() ? 0 : 1;
    }
    EXPECT_GT(hits, 5U);
    EXPECT_LT(hits, queries.size());
  }
}

TEST(Batch, SolidsAreTakenAsEachQuerySays) {
  const Model box(test::box_between({0, 0, 0}, {1, 1, 1})), small(test::box_between({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}));
  const std::vector<PairQuery> queries{{}, {.solid_a = Solid::none}};
  EXPECT_EQ(overlap_each({box, small, queries}), (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(relation_each({box, small, queries})[0].containment, Containment::b_in_a);
  EXPECT_EQ(relation_each({box, small, queries})[1].kind, RelationKind::apart);
}

TEST(Batch, FacesAreCountedOnce) {
  PolygonMesh square;
  square.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.corners = {0, 1, 2, 3};
  square.first = {0, 4};
  const Model quad(triangulate(square)),
      blade(TriangleMesh({{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.7, 0.9, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(count_contacts_each({quad, blade, std::vector<PairQuery>(1)}), (std::vector<ContactCount>{{2, 1}}));
}

TEST(Batch, NothingAsked) {
  const Model a = soup(1);
  EXPECT_TRUE(overlap_each({a, a, {}}).empty());
  EXPECT_TRUE(count_contacts_each({a, a, {}}).empty());
}

TEST(Batch, AnErrorNamesTheLeastQueryThatIsWrong) {
  const Model a = soup(1);
  std::vector<PairQuery> queries(40);
  queries[7].pose_b.offset.x = std::numeric_limits<double>::infinity();
  queries[8].solid_a = Solid::all;
  queries[31].pose_a.linear[0].x = std::numeric_limits<double>::quiet_NaN();
  for (const int threads : {1, 2, 4}) {
    try {
      (void)overlap_each({a, a, queries}, {.threads = threads});
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, 17), "query 7: model b:");
    }
  }
}

TEST(Batch, QueriesAreMadeWhenTheirTurnComes) {
  const Model a = soup(1), b = soup(2);
  std::vector<PairQuery> queries = random_queries(3, 60);
  std::vector<std::atomic<int>> made(queries.size());
  const auto make = [&](std::size_t i) {
    ++made[i];
    return queries[i];
  };
  for (const int threads : {1, 4}) {
    const Batch<PairQuery> batch(a, b, queries.size(), make);
    EXPECT_EQ(overlap_each(batch, {.threads = threads}), overlap_each({a, b, queries}));
    for (auto& times : made) EXPECT_EQ(times.exchange(0), 1);
  }
  queries[7].pose_b.offset.x = std::numeric_limits<double>::infinity();
  try {
    (void)overlap_each(Batch<PairQuery>(a, b, queries.size(), make));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 17), "query 7: model b:");
  }
}

TEST(Batch, ProgressIsToldAndMayCancel) {
  const Model a = soup(1);
  const std::vector<PairQuery> queries = random_queries(5, 30);
  std::size_t calls = 0, last = 0;
  const auto count = [&](std::size_t done, std::size_t total) {
    ++calls;
    last = done;
    EXPECT_EQ(total, queries.size());
  };
  (void)overlap_each({a, a, queries}, {.threads = 2, .progress = count});
  EXPECT_EQ(calls, queries.size());
  EXPECT_EQ(last, queries.size());
  const auto cancel = [](std::size_t, std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW((void)overlap_each({a, a, queries}, {.threads = 2, .progress = cancel}), std::runtime_error);
}

}  // namespace
}  // namespace toccata
