#include <utility>
#include <vector>

#include "broad/box_sweep.hpp"
#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// All boxes sorted along one axis, anew in each update, and swept with vector instructions (D. Baraff, "Dynamic
/// simulation of non-penetrating rigid bodies", 1992, section 2.3, of which one axis is left).
class SortAndSweep final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    const FloatFrame frame(finite_bounds(now.boxes));
    flat_.clear();
    flat_.reserve(now.boxes.size());
    for (Index number = 0; number < now.boxes.size(); ++number)
      if (!is_empty(now.boxes[number])) flat_.push_back(flat_box(frame, now.boxes[number], number));
    sweep_.lay_out(flat_, sweep_axis(flat_));
    const EvenParts chunks(sweep_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      sweep_.add_pairs(now.boxes, chunks.begin(part), chunks.end(part), found_[part]);
    });
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = sweep_.bytes() + flat_.capacity() * sizeof(FlatBox);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    BroadPhaseCells cells;
    add_intervals(cells, boxes, sweep_.axis());
    return cells;
  }

 private:
  static constexpr std::size_t parts = 32;

  std::vector<FlatBox> flat_;
  BoxSweep sweep_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_sort_and_sweep() { return std::make_unique<SortAndSweep>(); }

}  // namespace toccata
