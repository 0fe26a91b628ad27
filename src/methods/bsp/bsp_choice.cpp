#include "methods/bsp/bsp_choice.hpp"

#include <algorithm>

namespace toccata {
namespace {

constexpr std::size_t most_sampled = 64;

}  // namespace

BspPlane BspChoice::of(std::span<const PooledFragment> cell, Candidate candidate) {
  take_sample(cell);
  BspPlane best = 0;
  double least = HUGE_VAL;
  const std::size_t candidates = std::min<std::size_t>(options_.candidates, sample_.size());
  for (std::size_t i = 0; i < candidates; ++i) {
    const BspPlane plane = candidate(sample_[i * sample_.size() / candidates]);
    const double cost = score(counted(planes_.rounded(plane)));
    if (i > 0 && !(cost < least)) continue;
    least = cost;
    best = plane;
  }
  std::optional<AxisPlane> across;
  for (int axis = 0; axis < 3 && options_.axis_planes && cell.size() > 1; ++axis) {
    const AxisPlane plane = middle_across(axis);
    const std::optional<double> cost = axis_score(plane);
    if (!cost || !(*cost < least)) continue;
    least = *cost;
    across = plane;
  }
  return across ? planes_.add(*across) : best;
}

void BspChoice::take_sample(std::span<const PooledFragment> cell) {
  const std::size_t count = std::min(cell.size(), most_sampled);
  sample_.clear();
  for (std::size_t i = 0; i < count; ++i) sample_.push_back(cell[i * cell.size() / count]);
}

/// What is undecided counts as in the plane.
BspChoice::Counts BspChoice::counted(const RoundedBspPlane& plane) const {
  Counts counts;
  const double slope = plane.slope();
  for (const PooledFragment& fragment : sample_) {
    bool front = false, back = false;
    for (std::size_t i = 0; i < fragment.count; ++i) {
      const BspCorner& corner = fragments_.corner(fragment, i);
      const double height = plane.height(corner.place), error = plane.bound + slope * corner.error;
      front |= height > error;
      back |= height < -error;
    }
    counts.front += front && !back;
    counts.back += back && !front;
    counts.cut += front && back;
  }
  return counts;
}

double BspChoice::score(const Counts& counts) const {
  const auto front = static_cast<double>(counts.front), back = static_cast<double>(counts.back);
  return std::fabs(front - back) + options_.split_weight * static_cast<double>(counts.cut);
}

/// None where one side would be empty, so that it would not be known what that cell is, or nearly all would remain on
/// one side.
std::optional<double> BspChoice::axis_score(const AxisPlane& plane) const {
  const Counts counts = counted(planes_.rounded(plane));
  if (counts.front == 0 || counts.back == 0) return {};
  if (5 * (std::max(counts.front, counts.back) + counts.cut) > 4 * sample_.size()) return {};
  return score(counts);
}

AxisPlane BspChoice::middle_across(int axis) {
  coordinates_.clear();
  for (const PooledFragment& fragment : sample_) coordinates_.push_back(coordinate(fragment, axis));
  const auto middle = coordinates_.begin() + static_cast<std::ptrdiff_t>(coordinates_.size() / 2);
  std::nth_element(coordinates_.begin(), middle, coordinates_.end());
  return {axis, *middle};
}

/// The coordinate of the fragment's first corner; exactly that of a vertex, so that what lies across an axis there is
/// not cut beside it.
double BspChoice::coordinate(const PooledFragment& fragment, int axis) const {
  const BspCorner& corner = fragments_.corner(fragment, 0);
  if (is_edge(corner.on[0]) && is_edge(corner.on[1]))
    return planes_.triangle(fragment.triangle)[static_cast<int>(corner.on[1])][axis];
  return frame_.world(corner.place)[axis];
}

}  // namespace toccata
