#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle/rational.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/wide_cull.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/simd_levels.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata {
namespace {

using oracle::exact;

std::vector<Contact> copied(std::span<const Contact> contacts) { return {contacts.begin(), contacts.end()}; }

TriangleMesh one_triangle(const Triangle& t) { return {{t[0], t[1], t[2]}, {{0, 1, 2}}}; }

oracle::Rational dot_of(const std::array<float, 3>& form, const std::array<oracle::Rational, 3>& q) {
  return (exact(static_cast<double>(form[0])) * q[0] + exact(static_cast<double>(form[1])) * q[1]) +
         exact(static_cast<double>(form[2])) * q[2];
}

/// A local point in a tree's units, as a real number.
std::array<oracle::Rational, 3> in_tree(const WideBvh& tree, const Vec3& x) {
  const auto one = [&](double value, double origin) {
    return oracle::Rational((exact(value) - exact(origin)) / exact(tree.unit));
  };
  return {one(x.x, tree.origin.x), one(x.y, tree.origin.y), one(x.z, tree.origin.z)};
}

/// How far the number of one axis is from the truth for two points that are one in the world, against its pad. What the
/// floats of the walk round is not part of it.
double error_ratio(const WideAxes& axes, std::size_t axis, const std::array<oracle::Rational, 3>& own,
                   const std::array<oracle::Rational, 3>& other) {
  const oracle::Rational at_own = axis < WideAxes::straight ? own[axis] : dot_of(axes.slanted[axis].own, own);
  oracle::Rational at_other = exact(axes.offset[axis]);
  for (std::size_t i = 0; i < 3; ++i) at_other += exact(axes.other[i][axis]) * other[i];
  const oracle::Rational error = at_own > at_other ? at_own - at_other : at_other - at_own;
  // The form of a slanted axis itself is rounded to floats, which the walk's slack covers.
  const double slack = axis < WideAxes::straight ? 0 : 0x1p-20 * static_cast<double>(axes.own_size[axis]);
  return static_cast<double>(oracle::Rational(error / (exact(static_cast<double>(axes.pad[axis])) + exact(slack))));
}

/// The worst over all axes, for meshes that have a world point in common: vertex 0 of both.
double worst_ratio(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const auto vertex = [&] { return Vec3{random.unit(), random.unit(), random.unit()}; };
  PairQuery query = test::random_poses(family, random);
  const Vec3 x = vertex(), y = vertex();
  const PosedMesh a(Model(one_triangle({x, vertex(), vertex()})), query.pose_a);
  // B is moved so that the two world vertices are about one; what is left is taken off exactly below.
  query.pose_b.offset = transform(query.pose_a, x) - transform({query.pose_b.linear, {}}, y);
  const PosedMesh b(Model(one_triangle({y, vertex(), vertex()})), query.pose_b);
  if (!(a.vertex(0) == b.vertex(0))) return 0;
  const WideCull cull = wide_cull(PairCull(a, b), a, b);
  const auto q = in_tree(a.model().wide_bvh(), x), p = in_tree(b.model().wide_bvh(), y);
  double worst = 0;
  for (std::size_t i = 0; i < cull.of_a.count; ++i)
    if (std::isfinite(cull.of_a.pad[i])) worst = std::max(worst, error_ratio(cull.of_a, i, q, p));
  for (std::size_t i = 0; i < cull.of_b.count; ++i)
    if (std::isfinite(cull.of_b.pad[i])) worst = std::max(worst, error_ratio(cull.of_b, i, p, q));
  return worst;
}

TEST(WideCull, ThePadsCoverTheRounding) {
  double worst = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const double ratio = worst_ratio(family, seed);
      EXPECT_LT(ratio, 1) << family << ", seed " << seed;
      worst = std::max(worst, ratio);
    }
  RecordProperty("worst_ratio_of_error_and_pad", std::to_string(worst));
  EXPECT_GT(worst, 0.001) << "the pads are far too large, or no pair had a vertex in common";
}

class AnyPair final : public WideVisitor {
 public:
  bool visit(std::span<const ItemPair> pairs) override {
    count += pairs.size();
    return true;
  }
  std::size_t count = 0;
};

std::size_t candidates(const PosedMesh& a, const PosedMesh& b, double pad_scale) {
  const WideCull cull = wide_cull(PairCull(a, b, pad_scale), a, b);
  const WideWalk walk(a.model().wide_bvh(), b.model().wide_bvh(), cull);
  WideFrontier frontier;
  AnyPair found;
  walk.start(frontier, WideWalk::largest_batch);
  walk.run(frontier, found);
  return found.count;
}

TEST(WideCull, WithoutThePadsContactsAreLost) {
  int intersection = 0, lost_without_pads = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    // Tiny triangles far from the origin have world vertices in common only because their sums round alike.
    Pose pose_a{test::random_rotation(random), {1e6, -1e6, 1e6 * random.unit()}};
    const Pose pose_b{test::random_rotation(random), pose_a.offset};
    const auto vertex = [&] { return 1e-12 * Vec3{random.unit(), random.unit(), random.unit()}; };
    const PosedMesh a(Model(one_triangle({vertex(), vertex(), vertex()})), pose_a);
    const PosedMesh b(Model(one_triangle({vertex(), vertex(), vertex()})), pose_b);
    if (!overlap(a.triangle(0), b.triangle(0))) continue;
    ++intersection;
    EXPECT_EQ(candidates(a, b, 1), 1U) << "seed " << seed;
    if (candidates(a, b, 0) == 0) ++lost_without_pads;
  }
  EXPECT_GT(intersection, 100);
  EXPECT_GT(lost_without_pads, 10) << "this test no longer shows that the pads are needed";
}

/// Keeps what a walk finds.
class AllPairs final : public WideVisitor {
 public:
  bool visit(std::span<const ItemPair> found) override {
    pairs.insert(pairs.end(), found.begin(), found.end());
    return true;
  }
  std::vector<ItemPair> pairs;
};

TEST(WideWalk, OfATreeWithItselfFindsEveryPairOnceTheLesserFirst) {
  for (const Index triangles : {1U, 2U, 7U, 8U, 9U, 63U, 64U, 65U, 500U}) {
    Random random(triangles);
    const PosedMesh mesh(Model(test::random_soup(random, triangles, 0.3, 0)), Pose{});
    const WideBvh& tree = mesh.model().wide_bvh();
    const WideCull cull = wide_cull(PairCull(mesh, mesh), mesh, mesh);
    test::at_every_simd_level([&](SimdLevel level) {
      WideFrontier frontier;
      AllPairs all;
      WideWalk(tree, tree, cull).run_self(frontier, 8, all);
      std::sort(all.pairs.begin(), all.pairs.end());
      EXPECT_EQ(std::adjacent_find(all.pairs.begin(), all.pairs.end()), all.pairs.end()) << name_of(level);
      for (Index i = 0; i < triangles; ++i)
        for (Index j = i + 1; j < triangles; ++j)
          if (overlap(box_of(mesh.triangle(i)), box_of(mesh.triangle(j)))) {
            EXPECT_TRUE(std::binary_search(all.pairs.begin(), all.pairs.end(), ItemPair{i, j})) << i << ", " << j;
          }
      for (const ItemPair& pair : all.pairs) EXPECT_LT(pair.first, pair.second);
    });
  }
}

TEST(WideSearch, EveryLevelAndThreadCountFindsTheSameAtTheSameCost) {
  for (const std::string& family : test::pose_families()) {
    Random random(5);
    const Model a(test::random_soup(random, 500, 0.2, 0)), b(test::random_soup(random, 400, 0.2, 0));
    PairQuery query = test::random_poses(family, random);
    query.solid_a = query.solid_b = Solid::none;
    Workspace workspace;
    const std::vector<Contact> expected = test::contacts_by_brute_force(a, b, query);
    std::vector<WalkCounts> counts;
    test::at_every_simd_level([&](SimdLevel level) {
      for (const int threads : {1, 2, 0}) {
        query.threads = threads;
        EXPECT_TRUE(test::same(copied(contacts(a, b, query, workspace)), expected)) << family << ", " << name_of(level);
        counts.push_back(workspace.counts());
      }
      for (const WalkCounts& count : counts) EXPECT_EQ(count, counts.front()) << family << ", " << name_of(level);
      EXPECT_EQ(overlap(a, b, query, workspace), !expected.empty());
      const auto first = first_contact(a, b, query, workspace);
      EXPECT_TRUE(first.has_value() == !expected.empty() && (!first || test::same({*first}, {expected.front()})));
    });
  }
}

TEST(WideSearch, ManyContactsAreTheSameOnAnyNumberOfThreads) {
  Random random(12);
  const Model dense(test::random_soup(random, 450, 1.0, 16)), other(test::random_soup(random, 400, 1.0, 16));
  // The second time most triangles meet in special position.
  for (const Model& b : {other, dense}) {
    PairQuery query{Pose{}, Pose{}, Solid::none, Solid::none};
    const std::vector<Contact> expected = test::contacts_by_brute_force(dense, b, query);
    EXPECT_GT(expected.size(), 2000U);
    Workspace workspace;
    for (const int threads : {1, 2, 0, 7, 1}) {
      query.threads = threads;
      EXPECT_TRUE(test::same(copied(contacts(dense, b, query, workspace)), expected)) << threads;
    }
  }
}

TEST(FoundPairs, AreSortedByTheirNumbers) {
  Random random(13);
  for (const std::size_t count : {0U, 1U, 2U, 99U, 100U, 101U, 5000U})
    for (const std::uint64_t most : {std::uint64_t{1} << 14, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
      std::vector<std::uint64_t> numbers;
      for (std::size_t i = 0; i < count; ++i) numbers.push_back(random.below(most));
      std::vector<FoundPair> pairs, spare(count);
      for (const std::uint64_t number : numbers) pairs.push_back({number, nullptr});
      std::sort(numbers.begin(), numbers.end());
      const auto found = sorted(std::span(pairs), std::span(spare));
      EXPECT_TRUE(std::equal(found.begin(), found.end(), numbers.begin(), numbers.end(),
                             [](const FoundPair& pair, std::uint64_t number) { return pair.number == number; }));
    }
}

TEST(WideSearch, SelfContactsAreTheSameAtEveryLevel) {
  Random random(6);
  const Model soup(test::random_soup(random, 800, 0.15, 8));
  const Pose pose = test::random_poses("sheared", random).pose_a;
  const std::vector<Contact> expected = self_contacts(soup, pose);
  EXPECT_FALSE(expected.empty());
  test::at_every_simd_level([&](SimdLevel level) {
    EXPECT_TRUE(test::same(self_contacts(soup, pose), expected)) << name_of(level);
    EXPECT_TRUE(self_overlap(soup, pose)) << name_of(level);
  });
}

TEST(WideSearch, AWalkMayBeEndedAndTheWorkspaceUsedAgain) {
  Random random(7);
  const Model many(test::random_soup(random, 500, 0.4, 0)), few(test::random_soup(random, 3, 0.1, 0));
  const PairQuery query{Pose{}, Pose{}, Solid::none, Solid::none};
  Workspace workspace;
  for (int round = 0; round < 3; ++round) {
    EXPECT_TRUE(overlap(many, many, query, workspace));
    const auto found = contacts(many, few, query, workspace);
    EXPECT_TRUE(test::same(copied(found), test::contacts_by_brute_force(many, few, query)));
  }
}

TEST(WideSearch, NothingIsAllocatedAfterTheFirstCall) {
  Random random(8);
  const Model a(test::random_soup(random, 600, 0.2, 0)), b(test::random_soup(random, 600, 0.2, 0));
  PairQuery query = test::random_poses("rigid", random);
  query.solid_a = query.solid_b = Solid::none;
  Workspace workspace;
  static_cast<void>(contacts(a, b, query, workspace));
  SearchScratch& scratch = workspace.scratch();
  const auto places = [&] {
    const WideFrontier& frontier = scratch.main->frontier;
    return std::vector<const void*>{frontier.blocks.data(),    frontier.boxes.data(), frontier.places[0].data(),
                                    frontier.places[1].data(), frontier.pairs.data(), scratch.contacts.data()};
  };
  const auto before = places();
  for (int round = 0; round < 3; ++round) {
    static_cast<void>(contacts(a, b, query, workspace));
    static_cast<void>(overlap(a, b, query, workspace));
    EXPECT_EQ(places(), before);
  }
}

TEST(WideSearch, TheFirstOfManySelfContactsEndsTheSearch) {
  // Clusters that meet within themselves and are far from each other, so that little is ever pending.
  Random random(10);
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (int cluster = 0; cluster < 500; ++cluster)
    for (int i = 0; i < 8; ++i) {
      const auto first = static_cast<Index>(vertices.size());
      for (int corner = 0; corner < 3; ++corner)
        vertices.push_back(Vec3{10.0 * cluster, 0, 0} + Vec3{random.unit(), random.unit(), random.unit()});
      triangles.push_back({first, first + 1, first + 2});
    }
  const PosedMesh mesh(Model(TriangleMesh(vertices, triangles)), Pose{});
  SearchScratch scratch;
  EXPECT_TRUE(intersects_itself(mesh, scratch));
  EXPECT_LT(scratch.counts.items, 500U);
}

TEST(WideSearch, CountsAreOfTheLastQuestion) {
  Random random(11);
  const Model soup(test::random_soup(random, 100, 0.3, 0));
  Workspace workspace;
  EXPECT_TRUE(overlap(soup, soup, {}, workspace));
  EXPECT_GT(workspace.counts().volume_tests, 0U);
  EXPECT_FALSE(overlap(soup, soup, {.pose_b = Pose::translation(100, 0, 0)}, workspace));
  EXPECT_EQ(workspace.counts(), WalkCounts{});
}

/// FNV-1a over the triangles and the extreme points of all contacts.
std::uint64_t hash_of(std::span<const Contact> contacts) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3U; };
  for (const Contact& contact : contacts) {
    add(contact.element_a);
    add(contact.element_b);
    for (std::size_t i = 0; i < contact.intersection.count; ++i) {
      const IntersectionPoint& point = contact.intersection.points[i];
      for (const Feature& feature : {point.on_a, point.on_b})
        add(static_cast<std::uint64_t>(feature.kind) * 8 + feature.index);
    }
  }
  return hash;
}

// The same under g++ and clang, at -O0 and -O2, at every SIMD level and for every thread count.
TEST(Golden, ContactsOfSoups) {
  Random random(9);
  const Model a(test::random_soup(random, 300, 0.3, 0)), b(test::random_soup(random, 300, 0.3, 8));
  std::uint64_t hash = 0;
  std::size_t count = 0;
  for (const std::string& family : test::pose_families()) {
    PairQuery query = test::random_poses(family, random);
    Workspace workspace;
    const std::uint64_t here = hash_of(contacts(a, b, query, workspace));
    test::at_every_simd_level([&](SimdLevel) {
      for (const int threads : {1, 2}) {
        query.threads = threads;
        EXPECT_EQ(hash_of(contacts(a, b, query, workspace)), here) << family;
      }
    });
    hash = hash * 31 + here;
    count += contacts(a, b, query, workspace).size();
  }
  EXPECT_EQ(count, 8772U);
  EXPECT_EQ(hash, 15508721471335367467U);
}

}  // namespace
}  // namespace toccata
