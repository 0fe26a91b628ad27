#include <utility>
#include <vector>

#include "broad/finders.hpp"
#include "broad/packed_bvh.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// A packed tree over all boxes, built anew in each update; each box is looked for among those behind it.
class RebuiltBvh final : public PairFinder {
 public:
  explicit RebuiltBvh(PackingOrder order) : order_(order) {}

  PairList find(const BoxesNow& now, PairList storage) override {
    frame_ = FloatFrame(finite_bounds(now.boxes));
    if (order_ == PackingOrder::morton)
      tree_.build(frame_, now.boxes, [](Index) { return true; });
    else
      build_tiles(now.boxes);
    const EvenParts chunks(tree_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      tree_.add_pairs(now.boxes.data(), chunks.begin(part), chunks.end(part), found_[part]);
    });
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = tree_.bytes() + flat_.capacity() * sizeof(FlatBox);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> /*boxes*/) const override {
    BroadPhaseCells cells;
    tree_.add_cells(frame_, cells);
    return cells;
  }

 private:
  static constexpr std::size_t parts = 32;

  void build_tiles(std::span<const Aabb> boxes) {
    flat_.clear();
    for (Index number = 0; number < boxes.size(); ++number)
      if (!is_empty(boxes[number])) flat_.push_back(flat_box(frame_, boxes[number], number));
    tree_.build(flat_, order_);
  }

  PackingOrder order_;
  FloatFrame frame_;
  std::vector<FlatBox> flat_;
  PackedBvh tree_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_morton_tree() { return std::make_unique<RebuiltBvh>(PackingOrder::morton); }
std::unique_ptr<PairFinder> make_packed_r_tree() { return std::make_unique<RebuiltBvh>(PackingOrder::sort_and_tile); }

}  // namespace toccata
