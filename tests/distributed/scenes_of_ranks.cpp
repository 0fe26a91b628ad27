#include <limits>
#include <string>
#include <vector>

#include "distributed/twin_worlds.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "world/random_bodies.hpp"

namespace toccata::test {
namespace {

using Parts = std::vector<std::vector<SceneInstance>>;

/// Meshes, boxes and others, near each other; now and then a part without a model, and models of one group.
Parts random_parts(std::size_t count, Random& random) {
  const Model knot(icosphere_mesh(0.7, 2)), block(box_mesh({0.5, 0.5, 0.5}));
  Parts parts(count);
  for (std::size_t part = 0; part < count; ++part)
    for (std::uint64_t i = random.below(4); i > 0; --i) {
      const std::uint64_t kind = random.below(3);
      parts[part].push_back({kind == 0   ? knot
                             : kind == 1 ? block
                                         : random_convex_model(random),
                             random_place("convex", random)});
      parts[part].back().name = fmt::format("model {} of part {}", i, part);
      if (random.below(5) == 0) parts[part].back().group = "frame";
    }
  return parts;
}

std::vector<SceneInstance> all_of(const Parts& parts) {
  std::vector<SceneInstance> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

DistributedScene scene_of(const Parts& parts) {
  return {all_ranks(), parts.size(), [&parts](std::size_t part) { return parts[part]; }, 300};
}

void expect_equal(const PairAnswer& found, const PairAnswer& expected) {
  ASSERT_EQ(std::pair(found.a, found.b), std::pair(expected.a, expected.b));
  EXPECT_EQ(found.relation, expected.relation);
  ASSERT_EQ(found.contacts.size(), expected.contacts.size());
  for (std::size_t i = 0; i < found.contacts.size(); ++i) {
    EXPECT_EQ(found.contacts[i].element_a, expected.contacts[i].element_a);
    EXPECT_EQ(found.contacts[i].face_b, expected.contacts[i].face_b);
    EXPECT_EQ(found.contacts[i].intersection, expected.contacts[i].intersection);
  }
  EXPECT_EQ(found.penetration, expected.penetration);
  EXPECT_EQ(found.depth_end, expected.depth_end);
  EXPECT_EQ(found.manifold, expected.manifold);
  ASSERT_EQ(found.manifolds.size(), expected.manifolds.size());
  for (std::size_t i = 0; i < found.manifolds.size(); ++i)
    EXPECT_EQ(found.manifolds[i].manifold, expected.manifolds[i].manifold);
  EXPECT_EQ(found.regions, expected.regions);
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_EQ(found.kind, expected.kind);
  EXPECT_EQ(found.clearance, expected.clearance);
  EXPECT_EQ(found.piercing, expected.piercing);
  EXPECT_EQ(found.tolerance, expected.tolerance);
  EXPECT_EQ(found.local_depth, expected.local_depth);
  EXPECT_EQ(found.volume, expected.volume);
  EXPECT_EQ(found.common_point, expected.common_point);
  EXPECT_EQ(found.common_box.lower, expected.common_box.lower);
  EXPECT_EQ(found.common_box.upper, expected.common_box.upper);
}

/// Rank 0 tells what one process tells, and the others nothing.
void compare(const Parts& parts, const CheckOptions& options) {
  const CheckAnswer expected = check_all(all_of(parts), options);
  DistributedScene scene = scene_of(parts);
  const CheckAnswer found = scene.check(options);
  EXPECT_EQ(found.candidate_pairs, expected.candidate_pairs);
  EXPECT_EQ(scene.model_count(), all_of(parts).size());
  if (scene.rank() != 0) {
    EXPECT_TRUE(found.pairs.empty());
    return;
  }
  ASSERT_EQ(found.pairs.size(), expected.pairs.size());
  for (std::size_t i = 0; i < found.pairs.size(); ++i) expect_equal(found.pairs[i], expected.pairs[i]);
}

TEST(ScenesOfRanks, TellWhatOneProcessTells) {
  Random random(2);
  for (const std::size_t count : {0, 1, 2, 5, 24}) {
    SCOPED_TRACE(count);
    const Parts parts = random_parts(count, random);
    CheckOptions options;
    options.threads = own_thread;
    compare(parts, options);
    options.contacts = options.penetration = true;
    options.clearance = 0.25;
    compare(parts, options);
  }
}

TEST(ScenesOfRanks, HeedClearancesOfPairsTolerancesAndVolumes) {
  Random random(7);
  const Parts parts = random_parts(16, random);
  const std::vector<SceneInstance> models = all_of(parts);
  CheckOptions options;
  options.threads = own_thread;
  options.volume = true;
  options.tolerance = 0.2;
  for (Index i = 0; i + 3 < models.size(); i += 3)
    if (models[i].group.empty() || models[i].group != models[i + 3].group)
      options.pair_clearances.push_back({i + 3, i, 0.5 * i});
  compare(parts, options);
}

/// One clearance of one pair lets distances be told of all, on all ranks.
TEST(ScenesOfRanks, TellDistancesWhereverOneIsAsked) {
  Parts parts;
  for (int i = 0; i < 24; ++i) parts.push_back({{Box({0.6, 0.6, 0.6}), Pose::translation(i, 0, 0)}});
  CheckOptions options;
  options.pair_clearances = {{0, 1, 0.5}};
  compare(parts, options);
}

TEST(ScenesOfRanks, ReadOnlyWhatTheirPairsNeed) {
  Parts parts;
  for (int i = 0; i < 64; ++i) parts.push_back({{Box({0.6, 0.6, 0.6}), Pose::translation(i, 0, 0)}});
  DistributedScene scene = scene_of(parts);
  static_cast<void>(scene.check());
  const std::size_t ranks = static_cast<std::size_t>(our_ranks().count());
  EXPECT_LE(scene.costs().parts, 64 / ranks + 3);
  std::size_t candidates = 0;
  for (const std::size_t one : gathered(std::vector{scene.costs().candidates})) candidates += one;
  EXPECT_EQ(candidates, 63U);
}

TEST(ScenesOfRanks, TellAllRanksOfAPartThatCannotBeRead) {
  const std::size_t ranks = static_cast<std::size_t>(our_ranks().count());
  const std::string message = message_of([&] {
    DistributedScene scene(all_ranks(), 2 * ranks, [&](std::size_t part) -> std::vector<SceneInstance> {
      if (part + 1 == 2 * ranks) throw Error("gear.stl: it ends too early");
      return {{Sphere(1)}};
    });
  });
  EXPECT_EQ(message, fmt::format("rank {}: gear.stl: it ends too early", ranks - 1));
}

/// Also of pairs that are far from each other, and whichever rank would decide them.
TEST(ScenesOfRanks, RefuseTheClearancesThatOneProcessRefuses) {
  const Parts parts{{{.model = Model(Sphere(1)), .name = "a"}, {.model = Model(Sphere(1)), .group = "rack"}},
                    {{.model = Model(Sphere(1)), .pose = Pose::translation(90, 0, 0), .group = "rack"}}};
  const std::vector<SceneInstance> models = all_of(parts);
  DistributedScene scene = scene_of(parts);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<PairClearance>> wrong{
      {{0, 3, 1}}, {{1, 1, 1}}, {{0, 1, nan}}, {{0, 2, -1}}, {{0, 2, 1}, {2, 0, 2}}, {{1, 2, 1}}};
  for (const std::vector<PairClearance>& clearances : wrong) {
    CheckOptions options;
    options.pair_clearances = clearances;
    const std::string expected = message_of([&] { static_cast<void>(check_all(models, options)); });
    EXPECT_NE(expected, "nothing was thrown");
    EXPECT_EQ(message_of([&] { static_cast<void>(scene.check(options)); }), expected);
  }
  // And it goes on.
  static_cast<void>(scene.check());
}

}  // namespace
}  // namespace toccata::test
