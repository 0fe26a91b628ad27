#include "toccata/broad/bound_pairs.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "broad/own_bounds.hpp"
#include "math/constants.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// No less than the exact sum.
double end_of(double start, double length) {
  const double sum = start + length;
  return length == 0 ? sum : std::nextafter(sum, infinity);
}

Aabb box_around(const LineInterval& interval) { return {{interval.lower, 0, 0}, {interval.upper, 0, 0}}; }
Aabb box_around(const Rectangle& r) { return {{r.x, r.y, 0}, {end_of(r.x, r.width), end_of(r.y, r.height), 0}}; }

bool is_sound(const LineInterval& interval) { return interval.lower <= interval.upper; }
bool is_sound(const Rectangle& r) {
  return std::isfinite(r.x) && std::isfinite(r.y) && r.width >= 0 && std::isfinite(r.width) && r.height >= 0 &&
         std::isfinite(r.height);
}

/// The pairs of the boxes around them.
template <class Bound>
std::vector<IndexPair> candidates(std::span<const Bound> bounds, const BroadPhaseOptions& options) {
  std::vector<Aabb> boxes;
  boxes.reserve(bounds.size());
  for (const Bound& bound : bounds) boxes.push_back(box_around(bound));
  return overlapping_pairs(boxes, options);
}

bool do_overlap(const Rectangle& a, const Rectangle& b) { return overlap(a, b); }
template <class Bound>
bool do_overlap(const Bound& a, const Bound& b) {
  return bounds_overlap(a, b);
}

/// The pairs without those that do not overlap themselves.
template <class Bound>
std::vector<IndexPair> cleaned(std::vector<IndexPair> pairs, std::span<const Bound> bounds) {
  std::erase_if(pairs, [&](const IndexPair& pair) { return !do_overlap(bounds[pair.first], bounds[pair.second]); });
  return pairs;
}

template <class Bound>
void require_sound(std::span<const Bound> bounds, const char* what) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (!is_sound(bounds[i])) throw Error(fmt::format(fmt::runtime(what), i));
}

template <class Bound>
void require_no_complaint(std::span<const Bound> bounds, std::string_view what) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (const std::string complaint = complaint_about(bounds[i]); !complaint.empty())
      throw Error(fmt::format("{} {}: {}", what, i, complaint));
}

}  // namespace

std::vector<IndexPair> overlapping_pairs(std::span<const LineInterval> intervals, const BroadPhaseOptions& options) {
  require_sound(intervals, "interval {}: its lower end must not be above its upper one");
  return candidates(intervals, options);
}

std::vector<IndexPair> overlapping_pairs(std::span<const Rectangle> rectangles, const BroadPhaseOptions& options) {
  require_sound(rectangles, "rectangle {}: its numbers must be finite, its width and height not negative");
  return cleaned(candidates(rectangles, options), rectangles);
}

std::vector<IndexPair> overlapping_pairs(std::span<const Ball> balls, const BroadPhaseOptions& options) {
  require_no_complaint(balls, "ball");
  return cleaned(candidates(balls, options), balls);
}

std::vector<IndexPair> overlapping_pairs(std::span<const Obb> boxes, const BroadPhaseOptions& options) {
  require_no_complaint(boxes, "oriented box");
  return cleaned(candidates(boxes, options), boxes);
}

}  // namespace toccata
