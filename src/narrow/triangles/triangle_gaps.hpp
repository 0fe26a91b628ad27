#pragma once

#include <array>
#include <cstddef>

#include "narrow/triangles/triangle_pair_block.hpp"

namespace toccata {

/// For every lane of a block numbers between which the distance of its two triangles lies, as narrow as doubles get
/// them: mostly to some 2⁻⁴⁶ of the triangles' and the gap's size. Where coordinates are so large or small that plain
/// arithmetic leaves its range, `lower` is 0 and `upper` infinite.
struct TriangleGaps {
  using Lanes = std::array<double, TrianglePairBlock::lanes>;
  alignas(64) Lanes lower;
  alignas(64) Lanes upper;
  // Where the points lie that `upper` is about: on the edges i of a and j of b, of number 3 i + j; at a's vertex i and
  // on b's face, 9 + i; or at b's vertex i and on a's face, 12 + i. The shares are along the edges, of a's first, or
  // along the two edges from the face's vertex 0.
  alignas(64) Lanes features;
  alignas(64) Lanes share;
  alignas(64) Lanes other_share;

  struct Points {
    double features = 0;
    double share = 0;
    double other_share = 0;
  };
  [[nodiscard]] Points points(std::size_t lane) const { return {features[lane], share[lane], other_share[lane]}; }
  void set_points(std::size_t lane, const Points& points) {
    features[lane] = points.features;
    share[lane] = points.share;
    other_share[lane] = points.other_share;
  }
};

/// The block's corners are in the world. The same bits at every SIMD level.
void bound_gaps(const TrianglePairBlock& block, TriangleGaps& gaps);

/// Narrower bounds of every lane, in numbers of twice as many digits, from the points that `bound_gaps` found; the
/// block is still the same, or holds the same pairs in the same order. `lower` is 0 and `upper` infinite where they do
/// not tell. The same bits at every SIMD level, whichever lane a pair is in.
void refine_gaps(const TrianglePairBlock& block, TriangleGaps& gaps);

}  // namespace toccata
