#include "toccata/methods/cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "methods/cost/cost_walk.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

/// Flat triangles of side 1 in the plane z = `height`, one for each place along x.
TriangleMesh row_of_triangles(const std::vector<double>& places, double height) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (const double x : places) {
    const auto first = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), {{x, 0, height}, {x + 1, 0, height}, {x, 1, height}});
    triangles.push_back({first, first + 1, first + 2});
  }
  return {vertices, triangles};
}

CostOptions only(CostWorkload workload, CostVolume volume, int arity, BvhMethod method, Index leaf_size) {
  CostOptions options;
  options.workloads = {workload};
  options.volumes = {volume};
  options.arities = {arity};
  options.methods = {method};
  options.leaf_size = leaf_size;
  return options;
}

std::vector<PairQuery> some_queries(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<PairQuery> queries;
  for (std::size_t i = 0; i < count; ++i)
    queries.push_back(test::random_poses(i % 2 == 0 ? "rigid" : "snapped", random));
  return queries;
}

/// Two triangles far apart against the same two moved by (0, 0.25, 0): root against root, the root of a is split first,
/// each child meets the root of b, and each of b's leaves is tried; the two pairs that lie on each other meet.
TEST(Cost, CountsOfATinyTreeAreThoseByHand) {
  const TriangleMesh mesh = row_of_triangles({0, 10}, 0);
  const std::vector<PairQuery> queries{{Pose{}, Pose::translation(0, 0.25, 0)}};
  CostOptions options = only(CostWorkload::rigid, cost_volume<Aabb>, 2, BvhMethod::median, 1);
  options.task = CostTask::contacts;
  const CostTable table = measure_costs(mesh, mesh, queries, options);
  ASSERT_EQ(table.rows.size(), 1U);
  const CostRow& row = table.rows[0];
  EXPECT_EQ(row.counts.volumes_updated, 3U) << "all of b's; a stays where it is";
  EXPECT_EQ(row.counts.volume_tests, 7U);
  EXPECT_EQ(row.counts.items, 2U);
  EXPECT_EQ(row.nodes, 6U);
  EXPECT_EQ(row.greatest_depth, 1);
  EXPECT_EQ(table.answers, std::vector<double>{2});
}

TEST(Cost, MeshesApartCostOneTestOfTheRoots) {
  const TriangleMesh mesh = row_of_triangles({0, 10, 20, 30}, 0);
  const std::vector<PairQuery> queries{{Pose{}, Pose::translation(0, 0, 5)}, {Pose{}, Pose::translation(0, 0, 9)}};
  CostOptions options;
  options.volumes = {cost_volume<Aabb>, cost_volume<Obb>, cost_volume<Kdop<26>>, cost_volume<HullBound>};
  const CostTable table = measure_costs(mesh, mesh, queries, options);
  for (const CostRow& row : table.rows) {
    EXPECT_EQ(row.counts.items, 0U);
    EXPECT_EQ(row.counts.volume_tests, row.queries);
    const bool rigid = row.workload == CostWorkload::rigid;
    EXPECT_EQ(row.counts.volumes_updated, rigid ? 2U : row.nodes) << "the root of b, twice; or all volumes";
  }
  EXPECT_EQ(table.answers, (std::vector<double>{0, 0}));
}

TEST(Cost, FIsTheSumOfItsPartsAndRowsAreSorted) {
  Random random(3);
  const TriangleMesh a = test::random_soup(random, 30, 0.3, 4), b = test::random_soup(random, 25, 0.3, 0);
  for (const CostTask task : {CostTask::overlap, CostTask::distance}) {
    CostOptions options;
    options.task = task;
    options.arities = {2, 8};
    options.methods = {BvhMethod::heuristic};
    const CostTable table = measure_costs(a, b, some_queries(4, 2), options);
    EXPECT_EQ(table.rows.size(), 3U * 13 * 2 + 3) << "all of them, and the library's own tree";
    EXPECT_EQ(table.task, task);
    for (const CostRow& row : table.rows) {
      const double queries = static_cast<double>(row.queries);
      const auto cost = [&](std::size_t count, double each) { return static_cast<double>(count) * each / queries; };
      EXPECT_DOUBLE_EQ(row.cost(), cost(row.counts.volumes_updated, row.update_ns) +
                                       cost(row.counts.volume_tests, row.test_ns) +
                                       cost(row.counts.items, row.item_ns));
      EXPECT_TRUE(std::isfinite(row.cost()) && row.cost() >= 0);
      EXPECT_GT(row.measured_ns, 0);
      EXPECT_GT(row.build_ns, 0);
      EXPECT_GT(row.bytes, 0U);
    }
    EXPECT_TRUE(std::is_sorted(table.rows.begin(), table.rows.end(), [](const CostRow& x, const CostRow& y) {
      return x.workload != y.workload ? x.workload < y.workload : x.cost() < y.cost();
    }));
  }
}

/// Measured twice, and with the rows in another order.
TEST(Cost, CountsAndAnswersAreAlwaysTheSame) {
  Random random(5);
  const TriangleMesh a = test::random_soup(random, 40, 0.2, 0), b = test::random_soup(random, 40, 0.2, 4);
  CostOptions options;
  options.methods = {BvhMethod::heuristic, BvhMethod::insertion};
  options.arities = {4};
  options.task = CostTask::contacts;
  const auto counts_of = [](const CostTable& table) {
    std::set<std::tuple<CostWorkload, CostVolume, int, BvhMethod, std::size_t, std::size_t, std::size_t>> counts;
    for (const CostRow& row : table.rows)
      counts.insert({row.workload, row.volume, row.arity, row.method, row.counts.volumes_updated,
                     row.counts.volume_tests, row.counts.items});
    return counts;
  };
  const std::vector<PairQuery> queries = some_queries(6, 2);
  const CostTable once = measure_costs(a, b, queries, options);
  std::reverse(options.volumes.begin(), options.volumes.end());
  std::reverse(options.methods.begin(), options.methods.end());
  const CostTable again = measure_costs(a, b, queries, options);
  EXPECT_EQ(counts_of(once), counts_of(again));
  EXPECT_EQ(once.answers, again.answers);
}

TEST(Cost, AnswersAreThoseOfBruteForce) {
  Random random(7);
  const TriangleMesh a = test::random_soup(random, 30, 0.3, 4), b = test::random_soup(random, 30, 0.3, 0);
  const std::vector<PairQuery> queries = some_queries(8, 4);
  const auto world = [](const TriangleMesh& mesh, Index i, const Pose& pose) {
    const auto& corner = mesh.triangles()[i];
    return Triangle{{transform(pose, mesh.vertices()[corner[0]]), transform(pose, mesh.vertices()[corner[1]]),
                     transform(pose, mesh.vertices()[corner[2]])}};
  };
  CostOptions options;
  options.methods = {BvhMethod::heuristic};
  options.arities = {2};
  for (const CostTask task : {CostTask::overlap, CostTask::contacts, CostTask::distance}) {
    options.task = task;
    const CostTable table = measure_costs(a, b, queries, options);
    ASSERT_EQ(table.answers.size(), queries.size());
    for (std::size_t q = 0; q < queries.size(); ++q) {
      double pairs = 0, least = std::numeric_limits<double>::max();
      for (Index i = 0; i < a.triangle_count(); ++i)
        for (Index j = 0; j < b.triangle_count(); ++j) {
          const Triangle x = world(a, i, queries[q].pose_a), y = world(b, j, queries[q].pose_b);
          pairs += overlap(x, y) ? 1 : 0;
          if (task == CostTask::distance) least = std::min(least, distance(PosedPolytope(x), PosedPolytope(y)).upper);
        }
      const double expected = task == CostTask::overlap    ? std::min(pairs, 1.0)
                              : task == CostTask::contacts ? pairs
                                                           : least;
      EXPECT_NEAR(table.answers[q], expected, task == CostTask::distance ? 1e-11 : 0);
    }
  }
}

TEST(Cost, EveryVolumeHoldsWhatIsDegenerate) {
  const auto triangle = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return TriangleMesh({p, q, r}, {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}});
  };
  const std::vector<TriangleMesh> meshes{
      triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),
      triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), triangle({0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0})};
  CostOptions options;
  options.arities = {2};
  options.methods = {BvhMethod::heuristic, BvhMethod::mean};
  for (const CostTask task : {CostTask::contacts, CostTask::distance})
    for (const TriangleMesh& mesh : meshes) {
      options.task = task;
      const std::vector<PairQuery> queries{{}, {Pose{}, Pose::translation(3, 0, 0)}};
      const CostTable table = measure_costs(mesh, mesh, queries, options);
      EXPECT_EQ(table.rows.size(), 3U * 13 * 2 + 3);
      EXPECT_EQ(table.answers[0], task == CostTask::contacts ? 9 : 0) << "each lies on itself";
      for (const CostRow& row : table.rows) EXPECT_TRUE(std::isfinite(row.cost()));
    }
  for (const TriangleMesh& mesh : meshes)
    for (const VolumeCost& cost : measure_volumes(mesh, options)) {
      EXPECT_TRUE(std::isfinite(cost.root_volume) && std::isfinite(cost.root_surface));
      EXPECT_TRUE(cost.fill >= 0 && cost.fill <= 1);
    }
}

/// What is left out depends on sizes alone, and is told.
TEST(Cost, WhatWouldTakeTooLongIsLeftOutAndTold) {
  const TriangleMesh mesh = row_of_triangles({0, 2, 4, 6, 8}, 0);
  const std::vector<PairQuery> queries{{}};
  CostOptions options;
  options.volumes = {cost_volume<Aabb>, cost_volume<HullBound>};
  options.methods = {BvhMethod::heuristic, BvhMethod::morton};
  options.arities = {2};
  options.most_work = 0;
  EXPECT_TRUE(measure_costs(mesh, mesh, queries, options).rows.empty());
  options.most_work = 50;
  const CostTable table = measure_costs(mesh, mesh, queries, options);
  EXPECT_EQ(table.rows.size(), 7U) << "boxes of each kind, and one hull";
  EXPECT_EQ(table.left_out, (std::vector<std::string>{"rigid hull would take too long: morton 2",
                                                      "refit hull would take too long: every builder and arity",
                                                      "rebuild hull would take too long: every builder and arity"}));
}

TEST(Cost, OfManyQueriesSomeAreChosen) {
  const TriangleMesh mesh = row_of_triangles({0, 2}, 0);
  const std::vector<PairQuery> queries(10);
  CostOptions options = only(CostWorkload::rigid, cost_volume<Ball>, 2, BvhMethod::mean, 1);
  options.most_rigid = 3;
  EXPECT_EQ(measure_costs(mesh, mesh, queries, options).rows[0].queries, 3U);
  EXPECT_EQ(measure_costs(mesh, mesh, queries, options).answers.size(), 3U);
}

std::string message_of(const std::vector<PairQuery>& queries, const CostOptions& options) {
  const TriangleMesh mesh = row_of_triangles({0, 2}, 0);
  try {
    (void)measure_costs(mesh, mesh, queries, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Cost, BadInputIsToldInWords) {
  CostOptions options;
  EXPECT_NE(message_of({}, options).find("there is no query"), std::string::npos);
  options.arities = {2, 9};
  EXPECT_NE(message_of({{}}, options).find("2 to 8 children a node, not 9"), std::string::npos);
  options = {};
  options.volumes = {};
  EXPECT_NE(message_of({{}}, options).find("nothing is asked for"), std::string::npos);
  options = {};
  const Pose infinite = Pose::translation(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_NE(message_of({{Pose{}, infinite}}, options).find("not finite"), std::string::npos);
}

/// A row of which only the sizes of the terms are given.
CostRow row_of(CostVolume volume, std::size_t updates, std::size_t tests, std::size_t items) {
  CostRow row;
  row.volume = volume;
  row.queries = 2;
  row.counts = {updates, tests, items};
  row.update_ns = volume == cost_volume<Obb> ? 400 : 100;
  row.test_ns = volume == cost_volume<Obb> ? 60 : 10;
  row.item_ns = 50;
  row.measured_ns = 2e6;
  return row;
}

TEST(Cost, WordsTellTheWinnerAndWhy) {
  CostTable table;
  table.rows = {row_of(cost_volume<Aabb>, 40, 400, 80), row_of(cost_volume<Obb>, 30, 100, 20)};
  table.rows[1].arity = 4;
  table.rows[1].measured_ns = 1e6;
  EXPECT_EQ(
      explain_winner(table, CostWorkload::rigid),
      (std::vector<std::string>{
          "the cheapest is aabb with 2 children a node by heuristic: 6 us a query (2 ms as it ran), 33 % of it "
          "for updating volumes, 33 % for comparing them, 33 % for triangles",
          "obb with 4 children a node by heuristic costs 1.6 times as much: 0.75 times the updates at 4 times the "
          "time each, 0.25 times the tests of volumes at 6 times the time each, 0.25 times the triangle pairs",
          "as they ran, walk and all, the fastest was obb with 4 children a node by heuristic: 1 ms a query"}));
  EXPECT_TRUE(explain_winner(table, CostWorkload::refit).empty());
  table.rows.insert(table.rows.begin(), row_of(CostVolume::wide, 0, 200, 40));
  table.rows[0].item_ns = 0;
  const std::vector<std::string> lines = explain_winner(table, CostWorkload::rigid);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0],
            "the cheapest is the library's own tree (wide): 1 us a query (2 ms as it ran), 0 % of it for updating "
            "volumes, the rest is not taken apart");
  EXPECT_EQ(lines[1].substr(0, 59), "of the plain trees the cheapest is aabb with 2 children a n");
}

TEST(Cost, WordsTellEachThingOnce) {
  CostTable table;
  const CostRow best = row_of(cost_volume<Aabb>, 40, 400, 80);
  CostRow other = row_of(cost_volume<Aabb>, 40, 600, 80);
  other.arity = 4;
  other.method = BvhMethod::median;
  table.rows = {best, other};
  const std::string of_both =
      "aabb with 4 children a node by median costs 1.2 times as much: 1.5 times the tests of volumes";
  EXPECT_EQ(explain_winner(table, CostWorkload::rigid).size(), 2U) << "one rival of another arity and builder";
  EXPECT_EQ(explain_winner(table, CostWorkload::rigid).back(), of_both);
  table.rows.insert(table.rows.begin() + 1, row_of(cost_volume<Ball>, 40, 401, 80));
  EXPECT_EQ(explain_winner(table, CostWorkload::rigid).size(), 2U) << "nothing is told of one that costs the same";
  table.rows = {best, best};
  table.rows[1].volume = cost_volume<Ball>;
  EXPECT_EQ(explain_winner(table, CostWorkload::rigid).size(), 1U);
}

TEST(Cost, WhatIsNamedTwiceIsMeasuredOnce) {
  const TriangleMesh mesh = row_of_triangles({0, 2}, 0);
  CostOptions options = only(CostWorkload::rigid, cost_volume<Ball>, 2, BvhMethod::mean, 1);
  options.workloads.push_back(CostWorkload::rigid);
  options.volumes.push_back(cost_volume<Ball>);
  options.arities.push_back(2);
  options.methods.push_back(BvhMethod::mean);
  EXPECT_EQ(measure_costs(mesh, mesh, std::vector<PairQuery>{{}}, options).rows.size(), 1U);
  EXPECT_EQ(measure_volumes(mesh, options).size(), 1U);
}

TEST(Cost, VolumesOfAMeshAloneAreToldForEveryHierarchy) {
  const std::vector<VolumeCost> costs = measure_volumes(test::box_between({0, 0, 0}, {1, 2, 3}));
  EXPECT_EQ(costs.size(), 13U * 3 * 7);
  for (const VolumeCost& cost : costs) {
    SCOPED_TRACE(name_of(cost.volume));
    EXPECT_GT(cost.bytes, 0U);
    EXPECT_GT(cost.balance.leaves, 1U);
    EXPECT_GE(cost.root_volume, 6 * (1 - 1e-9));
    EXPECT_LE(cost.fill, 1);
    if (cost.volume == cost_volume<Aabb> || cost.volume == cost_volume<HullBound>) {
      EXPECT_NEAR(cost.root_volume, 6, 1e-9);
      EXPECT_NEAR(cost.root_surface, 22, 1e-9);
      EXPECT_NEAR(cost.fill, 1, 1e-9);
    }
    if (cost.volume == cost_volume<Cube>) {
      EXPECT_NEAR(cost.fill, 6.0 / 27, 1e-9);
    }
  }
}

TEST(Cost, ProgressGoesToTheEnd) {
  const TriangleMesh mesh = row_of_triangles({0, 2}, 0);
  CostOptions options;
  std::size_t last = 0, of = 0;
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(done, ++last);
    of = total;
  };
  (void)measure_costs(mesh, mesh, std::vector<PairQuery>{{}}, options);
  EXPECT_EQ(last, 21U);
  EXPECT_EQ(of, 21U);
}

}  // namespace
}  // namespace toccata
