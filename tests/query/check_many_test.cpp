#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "query/scenes/candidate_pairs.hpp"
#include "support/fewer_cases.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/distance.hpp"

namespace toccata {
namespace {

Vec3 random_place(Random& random, double size) {
  return {random.between(0, size), random.between(0, size), random.between(0, size)};
}

/// On a grid of halves, unturned: such neighbours often touch.
Pose snapped_pose(Random& random, std::uint64_t halves) {
  const auto coordinate = [&] { return 0.5 * static_cast<double>(random.below(halves)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return Pose::translation(x, y, z);
}

/// Instances of three meshes: a box, a tetrahedron and a sphere-like surface, in a cube of this size.
std::vector<SceneInstance> instances(std::size_t count, double size, std::uint64_t seed) {
  Random random(seed);
  const std::array models{Model(test::box_between({0, 0, 0}, {1, 0.5, 0.5})),
                          Model(test::tetrahedron_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})),
                          Model(test::sphere_mesh(0.5, 2))};
  std::vector<SceneInstance> posed;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t kind = random.below(3);
    const bool snapped = random.below(2) == 0;
    const Pose pose = snapped ? snapped_pose(random, static_cast<std::uint64_t>(2 * size))
                              : Pose{test::random_rotation(random), random_place(random, size)};
    const Solid solid = kind == 2 && i % 2 == 0 ? Solid::none : Solid::automatic;
    posed.push_back({models[kind], pose, solid, "", i % 7 == 0 ? "sevens" : ""});
  }
  return posed;
}

Aabb world_box(const SceneInstance& posed) {
  Aabb box;
  for (const Vec3& vertex : posed.model.mesh().vertices()) box = merge(box, transform(posed.pose, vertex));
  return box;
}

PairQuery query_of(const SceneInstance& a, const SceneInstance& b) { return {a.pose, b.pose, a.solid, b.solid}; }

/// Every pair whose world boxes overlap, asked alone.
std::vector<PairAnswer> answers_by_brute_force(const std::vector<SceneInstance>& models) {
  std::vector<Aabb> boxes;
  for (const SceneInstance& posed : models) boxes.push_back(world_box(posed));
  std::vector<PairAnswer> answers;
  for (const IndexPair& pair : overlapping_pairs_by_brute_force(boxes)) {
    const SceneInstance &a = models[pair.first], &b = models[pair.second];
    if (!a.group.empty() && a.group == b.group) continue;
    const Relation found = relation(a.model, b.model, query_of(a, b));
    if (found.kind != RelationKind::apart)
      answers.push_back({pair.first, pair.second, found, contacts(a.model, b.model, query_of(a, b))});
  }
  return answers;
}

void expect_same(const std::vector<PairAnswer>& found, const std::vector<PairAnswer>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].a, expected[i].a);
    ASSERT_EQ(found[i].b, expected[i].b);
    EXPECT_EQ(found[i].relation, expected[i].relation) << found[i].a << " and " << found[i].b;
    EXPECT_TRUE(test::same(found[i].contacts, expected[i].contacts)) << found[i].a << " and " << found[i].b;
  }
}

TEST(CheckMany, FiveThousandInstancesOfThreeMeshesAsByBruteForce) {
  const std::size_t count = test::fewer_under_tsan(std::size_t{5000});
  const std::vector<SceneInstance> models = instances(count, std::cbrt(9.33 * static_cast<double>(count)), 1);
  const std::vector<PairAnswer> expected = answers_by_brute_force(models);
  EXPECT_GT(expected.size(), count / 50);
  for (const int threads : {1, 2})
    expect_same(check_all(models, {.contacts = true, .threads = threads}).pairs, expected);
}

/// More pairs of one object than are looked at at once.
TEST(CheckMany, OneObjectUnderAllOthers) {
  Random random(2);
  const Model plate(test::box_between({-1, -1, -1}, {400, 400, 0})), part(test::box_between({0, 0, 0}, {1, 1, 1}));
  std::vector<SceneInstance> models{{plate, Pose{}}};
  for (int i = 0; i < 4200; ++i)
    models.push_back({part, Pose::translation(4.0 * (i % 100), 4.0 * std::floor(i / 100.0), i % 3 == 0 ? -0.5 : 0)});
  const CheckAnswer answer = check_all(models, {.threads = 2});
  ASSERT_EQ(answer.pairs.size(), 4200U);
  for (std::size_t i = 0; i < answer.pairs.size(); ++i) {
    EXPECT_EQ(answer.pairs[i].a, 0U);
    EXPECT_EQ(answer.pairs[i].b, i + 1);
    EXPECT_EQ(answer.pairs[i].relation.kind, i % 3 == 0 ? RelationKind::overlapping : RelationKind::touching);
  }
}

TEST(CheckMany, AllInOnePlace) {
  const Model part(test::sphere_mesh(1, 2));
  const CheckAnswer answer =
      check_all(std::vector<SceneInstance>(100, SceneInstance{part, Pose::translation(1, 2, 3)}));
  EXPECT_EQ(answer.candidate_pairs, 4950U);
  ASSERT_EQ(answer.pairs.size(), 4950U);
  for (const PairAnswer& pair : answer.pairs) EXPECT_EQ(pair.relation.containment, Containment::equal);
}

/// Two million pairs of the group overlap and are not asked about, nor kept.
TEST(CheckMany, OneGroupInOnePlaceWithOneThatIsNotOfIt) {
  const Model part(test::tetrahedron_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  std::vector<SceneInstance> models(2000, SceneInstance{part, Pose{}, Solid::automatic, "", "one"});
  models[1234].group.clear();
  const CheckAnswer answer = check_all(models, {.threads = 2});
  EXPECT_EQ(answer.candidate_pairs, 1999U);
  ASSERT_EQ(answer.pairs.size(), 1999U);
  for (Index i = 0; i < 1999; ++i) {
    EXPECT_EQ(answer.pairs[i].a, std::min(i, Index{1234}));
    EXPECT_EQ(answer.pairs[i].b, i < 1234 ? 1234 : i + 1);
  }
}

TEST(CheckMany, CandidatesComeInRunsAscendingWithTheOthersBetween) {
  Random random(4);
  std::vector<Aabb> boxes(400);
  for (Aabb& box : boxes) {
    const Vec3 lower = random_place(random, 8);
    box = {lower, lower + Vec3{2, 2, 2}};
  }
  boxes[17] = {{0, 0, 0}, {9, 9, 9}};
  const PairFilter wanted = [](const IndexPair& pair) { return pair.second % 4 != 0; };
  const std::vector<IndexPair> others{{0, 4}, {17, 20}, {17, 396}, {397, 399}};
  std::vector<IndexPair> expected = overlapping_pairs_by_brute_force(boxes);
  std::erase_if(expected, [&](const IndexPair& pair) { return !wanted(pair); });
  expected.insert(expected.end(), others.begin(), others.end());
  std::sort(expected.begin(), expected.end());
  for (const std::size_t pairs_in_run : {1U, 50U, 1'000'000U}) {
    CandidatePairs candidates(boxes, wanted, others, 2, pairs_in_run);
    EXPECT_EQ(candidates.count(), expected.size());
    std::vector<IndexPair> found;
    std::size_t runs = 0;
    for (auto run = candidates.next(); !run.empty(); run = candidates.next(), ++runs)
      found.insert(found.end(), run.begin(), run.end());
    EXPECT_EQ(found, expected);
    EXPECT_EQ(runs > 1, pairs_in_run < expected.size());
  }
}

/// Some pairs have lengths of their own: also infinite ones, and lesser ones than all others.
TEST(CheckMany, ClearancesOfPairsAsByBruteForce) {
  std::vector<SceneInstance> models = instances(300, 14, 5);
  Random random(6);
  CheckOptions options{.clearance = 0.25, .threads = 2};
  std::vector<std::vector<double>> lengths(models.size(), std::vector<double>(models.size(), 0.25));
  for (int i = 0; i < 200; ++i) {
    const auto a = static_cast<Index>(random.below(300)), b = static_cast<Index>(random.below(300));
    if (a == b || (a % 7 == 0 && b % 7 == 0) || lengths[a][b] != 0.25) continue;
    const double length = std::array{0.0, 3.0, std::numeric_limits<double>::infinity()}[random.below(3)];
    lengths[a][b] = lengths[b][a] = length;
    options.pair_clearances.push_back({a, b, length});
  }
  std::vector<IndexPair> expected, found;
  for (Index a = 0; a < models.size(); ++a)
    for (Index b = a + 1; b < models.size(); ++b)
      if ((a % 7 != 0 || b % 7 != 0) &&
          within_distance(models[a].model, models[b].model, lengths[a][b], query_of(models[a], models[b])))
        expected.push_back({a, b});
  for (const PairAnswer& pair : check_all(models, options).pairs) found.push_back({pair.a, pair.b});
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace toccata
