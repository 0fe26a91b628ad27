#include "toccata/trees/wide_bvh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "math/constants.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "trees/chunks.hpp"
#include "trees/float_box.hpp"
#include "trees/wide_boxes.hpp"
#include "trees/wide_frame.hpp"
#include "trees/wide_refit.hpp"

namespace toccata {
namespace {

// Work is divided by these numbers and never by threads.
constexpr std::size_t triangles_per_task = 32768;
constexpr std::size_t vertices_per_task = 16384;
constexpr std::size_t blocks_per_task = 2048;

using FloatPoints = std::unique_ptr<Float4[]>;

/// Where the vertices are: once, or at the start and at the end of their ways.
template <std::size_t count>
using Frames = std::array<std::span<const Vec3>, count>;

/// Grows with points; two coordinates at a time.
struct GrowingBox {
  using Double2 [[gnu::vector_size(16)]] = double;
  Double2 least_xy{infinity, infinity};
  Double2 greatest_xy{-infinity, -infinity};
  Double2 least_z{infinity, infinity};  ///< of z and of −z

  void add(const Vec3& point) {
    const Double2 xy{point.x, point.y}, z{point.z, -point.z};
    least_xy = xy < least_xy ? xy : least_xy;
    greatest_xy = xy > greatest_xy ? xy : greatest_xy;
    least_z = z < least_z ? z : least_z;
  }
  [[nodiscard]] Aabb box() const {
    return {{least_xy[0], least_xy[1], least_z[0]}, {greatest_xy[0], greatest_xy[1], -least_z[1]}};
  }
};

/// Around the corners of all triangles; vertices that none uses do not matter.
template <std::size_t count>
Aabb box_around(std::span<const std::array<Index, 3>> triangles, const Frames<count>& frames, int threads) {
  const Chunks chunks{triangles.size(), triangles_per_task};
  std::vector<Aabb> around(chunks.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    GrowingBox part;
    for (const auto& corners : chunks.of(triangles, chunk))
      for (const Index corner : corners)
        for (const auto& vertices : frames) part.add(vertices[corner]);
    around[chunk] = part.box();
  });
  Aabb all;
  for (const Aabb& part : around) all = merge(all, part);
  return all;
}

/// The float nearest to (x − origin) / unit, to less than the step to the next one.
float to_frame(const WideFrame& frame, double x, double origin) {
  return static_cast<float>((x - origin) * frame.inverse);
}

Float4 to_frame(const WideFrame& frame, const Vec3& v) {
  return Float4{to_frame(frame, v.x, frame.origin.x), to_frame(frame, v.y, frame.origin.y),
                to_frame(frame, v.z, frame.origin.z), 0};
}

/// Vertex by vertex, where it is in each frame. What no triangle uses may lie outside the tree's box and is made
/// anything.
template <std::size_t count>
FloatPoints points_of(const WideFrame& frame, const Frames<count>& frames, int threads) {
  const std::size_t vertex_count = frames[0].size();
  FloatPoints points = std::make_unique_for_overwrite<Float4[]>(count * vertex_count);
  const Chunks chunks{vertex_count, vertices_per_task};
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    const std::size_t first = chunks.first(chunk), last = std::min(first + chunks.piece, vertex_count);
    for (std::size_t v = first; v < last; ++v)
      for (std::size_t k = 0; k < count; ++k) points[count * v + k] = to_frame(frame, frames[k][v]);
  });
  return points;
}

/// The next float up, by its bits.
Float4 next_up(Float4 x) {
  const Float4 without_minus_zero = x + 0.0F;
  const Int4 step = 1 + 2 * (without_minus_zero < 0);
  return std::bit_cast<Float4>(std::bit_cast<Int4>(without_minus_zero) + step);
}

/// Around three points and all that they may have been rounded from.
FloatBox box_around(Float4 a, Float4 b, Float4 c) {
  return {-next_up(-least(least(a, b), c)), next_up(greatest(greatest(a, b), c))};
}

/// The triangles of a mesh in a tree's order, with their corners as floats in each frame.
template <std::size_t frame_count>
struct ItemTriangles {
  std::span<const Index> items;
  std::span<const std::array<Index, 3>> triangles;
  const Float4* point;

  [[nodiscard]] const std::array<Index, 3>& corners(const WideBlock& block, std::size_t lane) const {
    return triangles[items[block.item_place(lane)]];
  }
  [[nodiscard]] FloatBox box(const WideBlock& block, std::size_t lane) const {
    const std::array<Index, 3>& corner = corners(block, lane);
    const auto in_frame = [&](std::size_t k) {
      return box_around(point[frame_count * corner[0] + k], point[frame_count * corner[1] + k],
                        point[frame_count * corner[2] + k]);
    };
    FloatBox all = in_frame(0);
    for (std::size_t k = 1; k < frame_count; ++k) all.add(in_frame(k));
    return all;
  }

  // Triangles and corners lie anywhere in memory: these have them brought while others are worked on.
  void fetch_corners(const WideBlock& block) const {
    for (std::size_t lane = 0; lane < block.count; ++lane)
      if (block.is_item(lane)) __builtin_prefetch(&corners(block, lane));
  }
  void fetch_points(const WideBlock& block) const {
    for (std::size_t lane = 0; lane < block.count; ++lane)
      if (block.is_item(lane))
        for (const Index corner : corners(block, lane)) __builtin_prefetch(point + frame_count * corner);
  }
};

/// The boxes of the lanes that hold single triangles; gives the box around these.
template <std::size_t frame_count>
FloatBox put_items(WideBlock& block, const ItemTriangles<frame_count>& triangles) {
  std::array<FloatBox, WideBlock::width> boxes{};
  FloatBox all = FloatBox::empty();
  for (std::size_t lane = 0; lane < block.count; ++lane)
    if (block.is_item(lane)) {
      boxes[lane] = triangles.box(block, lane);
      all.add(boxes[lane]);
    }
  set_boxes(block, boxes);
  return all;
}

template <std::size_t frame_count>
void put_items(std::span<WideBlock> blocks, const ItemTriangles<frame_count>& triangles, FloatBox* around) {
  constexpr std::size_t ahead = 8;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i + 2 * ahead < blocks.size()) triangles.fetch_corners(blocks[i + 2 * ahead]);
    if (i + ahead < blocks.size()) triangles.fetch_points(blocks[i + ahead]);
    around[i] = put_items(blocks[i], triangles);
  }
}

/// The boxes of the lanes that hold blocks, from the last block to the first. `around` has a box for each block, and of
/// these what lies in items.
void put_blocks(std::span<WideBlock> blocks, std::vector<FloatBox>& around) {
  for (std::size_t i = blocks.size(); i-- > 0;)
    for (std::size_t lane = 0; lane < blocks[i].count; ++lane) {
      if (blocks[i].is_item(lane)) continue;
      const FloatBox& below = around[static_cast<std::size_t>(blocks[i].child[lane])];
      set_box(blocks[i], lane, below);
      around[i].add(below);
    }
}

double half_area(const WideBlock& block, std::size_t lane) {
  const double x = block.extent[0][lane], y = block.extent[1][lane], z = block.extent[2][lane];
  return 4 * ((x * y + y * z) + z * x);
}

/// The geometric mean of the half areas of the boxes around several others, by logarithms: their sum would tell of the
/// largest alone, of a floor and not of all that stands upon it. What has no area counts as far less than any other. 0
/// where there are none.
double mean_half_area(std::span<const WideBlock> blocks) {
  constexpr double least = 0x1p-200;
  double product = 1, count = 0;
  std::int64_t octaves = 0;
  for (const WideBlock& block : blocks)
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (block.is_item(lane)) continue;
      int octave = 0;
      product = std::frexp(product * std::max(half_area(block, lane), least), &octave);
      octaves += octave;
      ++count;
    }
  return count > 0 ? std::exp2((static_cast<double>(octaves) + std::log2(product)) / count) : 0;
}

std::size_t lane_count(std::span<const WideBlock> blocks) {
  std::size_t lanes = 0;
  for (const WideBlock& block : blocks) lanes += block.count;
  return lanes;
}

void move_to(WideBvh& tree, const WideFrame& frame) {
  const double ratio = tree.unit / frame.unit;
  tree.built_size *= ratio * ratio;
  tree.origin = frame.origin;
  tree.unit = frame.unit;
}

template <std::size_t count>
Refit refit_to(WideBvh& tree, std::span<const std::array<Index, 3>> triangles, const Frames<count>& frames,
               int threads) {
  if (tree.items.size() != triangles.size())
    throw Error("a tree over " + std::to_string(tree.items.size()) + " triangles is to be refitted to a mesh of " +
                std::to_string(triangles.size()) + ": build one for that mesh");
  if (tree.built_size < 0) tree.built_size = mean_half_area(tree.blocks);
  tree.box = box_around(triangles, frames, threads);
  const WideFrame frame = frame_around(tree.box);
  move_to(tree, frame);
  const FloatPoints points = points_of(frame, frames, threads);
  std::vector<FloatBox> around(tree.blocks.size());
  const ItemTriangles<count> items{tree.items, triangles, points.get()};
  const Chunks chunks{tree.blocks.size(), blocks_per_task};
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    put_items(chunks.of(std::span(tree.blocks), chunk), items, around.data() + chunks.first(chunk));
  });
  put_blocks(tree.blocks, around);
  const double size = mean_half_area(tree.blocks);
  return {lane_count(tree.blocks), size == tree.built_size ? 1 : size / tree.built_size};
}

}  // namespace

Refit refit(WideBvh& tree, const TriangleMesh& mesh, int threads) {
  return refit_to<1>(tree, mesh.triangles(), {mesh.vertices()}, threads);
}

Refit refit_to_ways(WideBvh& tree, std::span<const std::array<Index, 3>> triangles, std::span<const Vec3> start,
                    std::span<const Vec3> end, int threads) {
  return refit_to<2>(tree, triangles, {start, end}, threads);
}

}  // namespace toccata
