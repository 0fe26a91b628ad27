#pragma once

#include <array>
#include <cstddef>

#include "narrow/triangle_pair_block.hpp"

namespace toccata {

/// For every lane of a block numbers between which the distance of its two triangles lies, as narrow as doubles get
/// them: mostly to some 2⁻⁴⁶ of the triangles' and the gap's size. Where coordinates are so large or small that plain
/// arithmetic leaves its range, `lower` is 0 and `upper` infinite.
struct TriangleGaps {
  alignas(64) std::array<double, TrianglePairBlock::lanes> lower;
  alignas(64) std::array<double, TrianglePairBlock::lanes> upper;
};

/// The block's corners are in the world. The same bits at every SIMD level.
void bound_gaps(const TrianglePairBlock& block, TriangleGaps& gaps);

}  // namespace toccata
