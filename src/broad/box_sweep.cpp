#include "broad/box_sweep.hpp"

#include <algorithm>

#include "broad/key_sort.hpp"

namespace toccata {

std::size_t sweep_axis(std::span<const FlatBox> boxes) {
  std::size_t best = 0;
  double best_spread = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0, squares = 0, sizes = 0;
    for (const FlatBox& box : boxes) {
      const double lower = double{box.lower[axis]}, upper = double{box.upper[axis]};
      sum += lower + upper;
      squares += (lower + upper) * (lower + upper);
      sizes += upper - lower;
    }
    const double count = static_cast<double>(boxes.size());
    const double variance = std::max(squares / count - (sum / count) * (sum / count), 0.0);
    const double spread = variance / (1e-300 + (sizes / count) * (sizes / count));
    if (spread > best_spread) {
      best = axis;
      best_spread = spread;
    }
  }
  return best;
}

void BoxSweep::lay_out(std::span<const FlatBox> boxes, std::size_t axis) {
  axis_ = axis;
  std::vector<Keyed<std::uint32_t>> keyed(boxes.size()), scratch;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    keyed[i] = {ordered(boxes[i].lower[axis]), static_cast<std::uint32_t>(i)};
  sort_by_key(keyed, scratch);
  store_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) store_.put(i, boxes[keyed[i].place]);
  ends_.resize(boxes.size());
  const float* lower = store_.columns().lower[axis];
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const float reach = store_.upper(axis, i);
    std::size_t first = i + 1, step = 1;
    while (first + step < boxes.size() && lower[first + step] <= reach) {
      first += step;
      step *= 2;
    }
    const std::size_t last = std::min(first + step, boxes.size());
    ends_[i] = static_cast<std::uint32_t>(std::upper_bound(lower + std::min(first, last), lower + last, reach) - lower);
  }
}

void BoxSweep::add_pairs(std::span<const Aabb> all, std::size_t begin, std::size_t end, PairBuffer& pairs) const {
  add_overlaps_behind({store_.columns(), all.data()}, begin, end, ends_.data() + begin, pairs);
}

std::size_t BoxSweep::bytes() const { return store_.bytes() + ends_.capacity() * sizeof(std::uint32_t); }

}  // namespace toccata
