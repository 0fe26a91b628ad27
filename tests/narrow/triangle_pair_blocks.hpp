#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "narrow/triangle_pairs.hpp"
#include "narrow/triangles/triangle_pair_block.hpp"
#include "toccata/core/random.hpp"
#include "toccata/core/simd.hpp"

// Batches of pairs of triangles, classified at a SIMD level and compared with the answers for one pair.
namespace toccata::test {

struct PosedTrianglePairs {
  Pose pose_a;
  Pose pose_b;
  std::vector<TrianglePair> pairs;
};

/// The last block may be partial, and its free lanes hold `filler`.
inline std::vector<TrianglePairBlock> blocks_of(const std::vector<TrianglePair>& pairs, double filler = 0) {
  std::vector<TrianglePairBlock> blocks((pairs.size() + TrianglePairBlock::lanes - 1) / TrianglePairBlock::lanes);
  const Vec3 v{filler, filler, filler};
  for (TrianglePairBlock& block : blocks)
    for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; ++lane) set_pair(block, lane, {{v, v, v}}, {{v, v, v}});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    TrianglePairBlock& block = blocks[i / TrianglePairBlock::lanes];
    set_pair(block, block.count++, pairs[i].a, pairs[i].b);
  }
  return blocks;
}

/// Classified at this level, which stays in use.
inline std::vector<TrianglePairBlock> classified(const PosedTrianglePairs& batch, SimdLevel level) {
  std::vector<TrianglePairBlock> blocks = blocks_of(batch.pairs);
  use_simd_level(level);
  classify_pairs(batch.pose_a, batch.pose_b, blocks);
  return blocks;
}

inline bool is_finite(const Triangle& t) {
  return toccata::is_finite(t[0]) && toccata::is_finite(t[1]) && toccata::is_finite(t[2]);
}

inline Triangle posed(const Pose& pose, const Triangle& t) {
  return {{transform(pose, t[0]), transform(pose, t[1]), transform(pose, t[2])}};
}

/// To the bit, but one NaN is like another.
inline bool same_bits(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
}

inline bool same_bits(const Triangle& s, const Triangle& t) {
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (!same_bits(s[i][axis], t[i][axis])) return false;
  return true;
}

inline bool has_bit(std::uint8_t bits, std::size_t lane) { return ((bits >> lane) & 1U) != 0; }

/// Empty, or what is wrong about the answer in a lane for the triangles a and b in the world.
inline std::string compare_lane(const TrianglePairBlock& block, std::size_t lane, const Triangle& a,
                                const Triangle& b) {
  if (!same_bits(triangle_a(block, lane), a) || !same_bits(triangle_b(block, lane), b)) return "world triangles";
  const bool meets = has_bit(block.intersection, lane), unknown = has_bit(block.unknown, lane);
  if (meets && unknown) return "both certain and unknown";
  if (unknown) return "";
  if (!is_finite(a) || !is_finite(b)) return "certain of infinite triangles";
  const Intersection truth = intersect(a, b);
  if (meets != (truth.kind != IntersectionKind::none)) return meets ? "no intersection" : "not apart";
  if (meets && intersection_in(block, lane) != truth) return "another intersection";
  return "";
}

}  // namespace toccata::test
