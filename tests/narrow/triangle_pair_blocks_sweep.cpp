#include "narrow/triangle_pair_blocks.hpp"
#include "support/sweep.hpp"
#include "toccata/math/pose.hpp"

// What the vector instructions say of pairs of triangles, compared at every SIMD level with the answers for one pair,
// under poses of every kind.
namespace toccata::test {
namespace {

using triangle_pairs::random_point;

Pose random_pose(Random& random) {
  const double distance = std::ldexp(1.0, static_cast<int>(random.below(8)) - 4);
  const Vec3 offset = distance * random_point(random);
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      return {};
    case 3:
    case 4: {
      const Vec3 axis = random_point(random);
      return {rotation_about(axis, random.between(-180, 180)), offset};
    }
    case 5:  // shears, mirrors and stretches
      return {{{random_point(random), random_point(random), random_point(random)}}, offset};
    case 6:  // flattens
      return {{{random_point(random), Vec3{}, random_point(random)}}, offset};
    default: {  // some of it becomes infinite or vanishes
      const double factor = std::ldexp(1.0, static_cast<int>(random.below(2100)) - 1050);
      return scaled({rotation_about(random_point(random), 10), factor * offset}, factor);
    }
  }
}

/// Mostly one pose for both, which leaves the family's kind of nearness in place.
PosedTrianglePairs random_batch(const std::string& family, Random& random, std::uint64_t count) {
  PosedTrianglePairs batch;
  batch.pose_a = random_pose(random);
  batch.pose_b = random.below(4) == 0 ? random_pose(random) : batch.pose_a;
  for (std::uint64_t i = 0; i < count; ++i) batch.pairs.push_back(triangle_pair(family, random));
  return batch;
}

struct LevelAnswer {
  SimdLevel level = SimdLevel::scalar;
  std::vector<TrianglePairBlock> blocks;
};

std::vector<LevelAnswer> answers_of_all_levels(const PosedTrianglePairs& batch) {
  std::vector<LevelAnswer> answers;
  for (const SimdLevel level : simd_levels()) answers.push_back({level, classified(batch, level)});
  return answers;
}

/// Empty, or what is wrong about one pair of the batch.
std::string check_triangle_pair_blocks(const PosedTrianglePairs& batch, const std::vector<LevelAnswer>& answers,
                                       std::size_t pair) {
  const std::size_t index = pair / TrianglePairBlock::lanes, lane = pair % TrianglePairBlock::lanes;
  const Triangle a = posed(batch.pose_a, batch.pairs[pair].a), b = posed(batch.pose_b, batch.pairs[pair].b);
  const TrianglePairBlock& first = answers.front().blocks[index];
  for (const LevelAnswer& of : answers) {
    const TrianglePairBlock& block = of.blocks[index];
    std::string wrong = compare_lane(block, lane, a, b);
    if (wrong.empty() && (block.unknown != first.unknown || block.intersection != first.intersection))
      wrong = "not as at the scalar level";
    if (!wrong.empty()) return wrong + " at " + std::string(name_of(of.level));
  }
  return "";
}

std::string describe(const PosedTrianglePairs& batch, std::size_t pair) {
  return ": a" + to_text(posed(batch.pose_a, batch.pairs[pair].a)) + ", b" +
         to_text(posed(batch.pose_b, batch.pairs[pair].b));
}

SweepResult run_triangle_pair_blocks(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  const SimdLevel level_before = simd_level();
  SweepResult result;
  Random random(Random(seed).bits() + 1);
  while (result.cases < cases) {
    const PosedTrianglePairs batch =
        random_batch(family, random, std::min<std::uint64_t>(cases - result.cases, 1 + random.below(40)));
    const std::vector<LevelAnswer> answers = answers_of_all_levels(batch);
    for (std::size_t pair = 0; pair < batch.pairs.size(); ++pair, ++result.cases) {
      const std::string wrong = check_triangle_pair_blocks(batch, answers, pair);
      if (wrong.empty()) continue;
      if (result.wrong++ == 0)
        result.first_failure = wrong + ", case " + std::to_string(result.cases) + describe(batch, pair);
    }
  }
  use_simd_level(level_before);
  return result;
}

const bool triangle_pair_blocks_known =
    register_sweep({"triangle-pair-blocks", triangle_pair_families(), 1'000'000, 1000, run_triangle_pair_blocks});

}  // namespace
}  // namespace toccata::test
