#include <vector>

#include "broad/box_lanes.hpp"
#include "broad/finders.hpp"
#include "broad/float_boxes.hpp"
#include "broad/pair_buffer.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// Every box with all behind it, a vector of them at a time.
class BruteForce final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    const std::size_t count = lay_out(now.boxes);
    const LaidOut laid{store_.columns(), now.boxes.data()};
    ends_.assign(count, static_cast<std::uint32_t>(count));
    const EvenParts chunks(count, parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      const std::size_t begin = chunks.begin(part);
      add_overlaps_behind(laid, begin, chunks.end(part), ends_.data() + begin, found_[part]);
    });
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = store_.bytes() + ends_.capacity() * sizeof(std::uint32_t);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

 private:
  static constexpr std::size_t parts = 16;

  std::size_t lay_out(std::span<const Aabb> boxes) {
    const FloatFrame frame(finite_bounds(boxes));
    store_.resize(boxes.size());
    std::size_t count = 0;
    for (Index number = 0; number < boxes.size(); ++number)
      if (!is_empty(boxes[number])) store_.put(count++, flat_box(frame, boxes[number], number));
    return count;
  }

  ColumnStore store_;
  std::vector<std::uint32_t> ends_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_brute_force() { return std::make_unique<BruteForce>(); }

}  // namespace toccata
