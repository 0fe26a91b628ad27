#pragma once

#include <span>
#include <vector>

#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/bounds/swept_sphere.hpp"
#include "toccata/broad/broad_phase.hpp"

// The broad phase of other bounds than boxes along the axes: boxes around them are compared first, then they
// themselves.
namespace toccata {

/// A closed piece of a line.
struct LineInterval {
  double lower = 0;
  double upper = 0;
};

/// All pairs of intervals, rectangles, balls or oriented boxes that overlap, first < second, ascending, each once;
/// touching counts. The answer is exact for intervals, rectangles and balls; of oriented boxes no pair is missing, and
/// pairs that are apart by a rounding error may be among them. Empty ones overlap nothing. Throws Error naming an
/// interval whose ends, a rectangle whose numbers, or a ball or oriented box whose centre, extent or axes are no such.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const LineInterval> intervals,
                                                       const BroadPhaseOptions& options = {});
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Rectangle> rectangles,
                                                       const BroadPhaseOptions& options = {});
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Ball> balls,
                                                       const BroadPhaseOptions& options = {});
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Obb> boxes,
                                                       const BroadPhaseOptions& options = {});

}  // namespace toccata
