#include "broad/tile_split.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// How many boxes fit side by side along each axis, about.
std::array<double, 3> widths_of(std::span<const FlatBox> sample) {
  std::array<double, 3> widths{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = infinity, high = -low, sizes = 0;
    for (const FlatBox& box : sample) {
      low = std::min(low, double{box.lower[axis]});
      high = std::max(high, double{box.lower[axis]});
      sizes += double{box.upper[axis]} - double{box.lower[axis]};
    }
    const double size = sizes / static_cast<double>(sample.size());
    widths[axis] = high > low ? std::min((high - low) / std::max(size, 1e-300), 1e9) : 0;
  }
  return widths;
}

struct TileCut {
  std::size_t axis;
  double slabs;
};

/// Along the axis that is to be cut into most slabs, when `tiles` in all are to be as wide along each.
TileCut best_cut(const std::array<double, 3>& widths, double tiles) {
  std::array<bool, 3> used{true, true, true};
  for (int round = 0; round < 3; ++round) {
    double product = 1;
    int axes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (used[axis]) {
        product *= std::max(widths[axis], 1e-9);
        ++axes;
      }
    const double share = std::pow(tiles / product, 1.0 / std::max(axes, 1));
    bool all_cut = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (used[axis] && axes > 1 && widths[axis] * share < 1.5) {
        used[axis] = false;
        all_cut = false;
      }
    if (!all_cut) continue;
    std::size_t best = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (used[axis] && (!used[best] || widths[axis] > widths[best])) best = axis;
    return {best, std::min(widths[best] * share, tiles)};
  }
  const auto widest = static_cast<std::size_t>(std::max_element(widths.begin(), widths.end()) - widths.begin());
  return {widest, tiles};
}

}  // namespace

TileSplit::TileSplit(std::span<FlatBox> sample, std::size_t count, std::size_t tile_size,
                     const std::array<float, 3>& corner) {
  constexpr double most_shared = 0.35;  // of the boxes that may lie in more than one slab
  cuts_.fill(std::numeric_limits<float>::infinity());
  if (count <= tile_size || sample.empty()) return;
  const std::array<double, 3> widths = widths_of(sample);
  const TileCut cut = best_cut(widths, static_cast<double>(count) / static_cast<double>(tile_size));
  axis_ = cut.axis;
  const double wanted = std::min(std::ceil(cut.slabs - 0.25), 1 + most_shared * widths[axis_]);
  const auto slabs = static_cast<std::size_t>(std::clamp(wanted, 1.0, double{most_slabs}));
  if (slabs < 2) return;
  std::sort(sample.begin(), sample.end(),
            [axis = axis_](const FlatBox& a, const FlatBox& b) { return a.lower[axis] < b.lower[axis]; });
  // What begins before the corner has been cut there already.
  float last = std::max(sample.front().lower[axis_], corner[axis_]);
  for (std::size_t slab = 1; slab < slabs; ++slab) {
    const float at = sample[slab * sample.size() / slabs].lower[axis_];
    if (at <= last) continue;
    cuts_[slabs_ - 1] = at;
    last = at;
    ++slabs_;
  }
}

}  // namespace toccata
