#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "broad/box_lanes.hpp"
#include "broad/box_sample.hpp"
#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "broad/tile_split.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

using TileCorner = std::array<float, 3>;
constexpr std::size_t tile_size = 200;

/// Which part of space: of boxes that reach into it, those pairs are told whose greater lower corner lies in it.
struct TileRegion {
  TileCorner from, to;
};

/// The boxes of one tile, sorted into slices along an axis and swept.
class Tile {
 public:
  void add_pairs(std::span<const FlatBox> boxes, const TileCorner& corner, const Aabb* all, PairBuffer& pairs) {
    if (boxes.size() < 2) return;
    measure(boxes);
    count_.assign(slices_ + 1, 0);
    slice_of_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) ++count_[slice_of_[i] = slice_of(boxes[i].lower[axis_])];
    std::uint32_t sum = 0;
    for (std::uint32_t& start : count_) sum += std::exchange(start, sum);
    ends_.resize(boxes.size());
    sides_.resize(boxes.size() + slack);
    store_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) put(boxes[i], count_[slice_of_[i]]++, corner);
    // Each start is now its slice's end.
    for (std::size_t i = 0; i < boxes.size(); ++i) ends_[i] = count_[ends_[i]];
    add_overlaps_in_tile({store_.columns(), all}, sides_.data(), 0, boxes.size(), ends_.data(), pairs);
  }
  [[nodiscard]] std::size_t bytes() const {
    return store_.bytes() + (sides_.capacity() + ends_.capacity() + count_.capacity()) * sizeof(std::uint32_t) +
           slice_of_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::size_t slack = 16;

  /// Slices of equal width along the axis where fewest boxes lie side by side.
  void measure(std::span<const FlatBox> boxes) {
    TileCorner low = boxes.front().lower, high = low, size{};
    for (const FlatBox& box : boxes)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], box.lower[axis]);
        high[axis] = std::max(high[axis], box.lower[axis]);
        size[axis] += std::min(box.upper[axis] - box.lower[axis], 1e30F);
      }
    float best = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float range = std::min(high[axis] - low[axis], 1e38F), width = range / std::max(size[axis], 1e-38F);
      if (width <= best) continue;
      best = width;
      axis_ = axis;
      low_ = low[axis];
    }
    slices_ = std::bit_ceil(std::clamp<std::size_t>(boxes.size(), 64, 65536));
    const float range = std::min(high[axis_] - low_, 1e38F);
    per_slice_ = range > 1e-30F ? static_cast<float>(slices_ - 1) / range : 0;
  }
  /// Keeps the order of coordinates.
  [[nodiscard]] std::uint32_t slice_of(float coordinate) const {
    const float slice = (coordinate - low_) * per_slice_, last = static_cast<float>(slices_ - 1);
    // What is not above the first is in it, also what is no number: infinity times nothing.
    return static_cast<std::uint32_t>(slice > 0 ? std::min(slice, last) : 0);
  }
  void put(const FlatBox& box, std::uint32_t place, const TileCorner& corner) {
    store_.put(place, box);
    ends_[place] = slice_of(box.upper[axis_]);
    sides_[place] =
        (box.lower[0] < corner[0] ? 1U : 0) | (box.lower[1] < corner[1] ? 2U : 0) | (box.lower[2] < corner[2] ? 4U : 0);
  }

  std::size_t axis_ = 0, slices_ = 0;
  float low_ = 0, per_slice_ = 0;
  ColumnStore store_;
  std::vector<std::uint32_t> sides_, ends_, count_, slice_of_;
};

void take_sample(std::span<const FlatBox> boxes, std::vector<FlatBox>& sample) {
  const std::size_t wanted = std::clamp<std::size_t>(boxes.size() / 16, 64, 1024);
  sample.clear();
  visit_sample(boxes.size(), wanted, [&](std::size_t i) { sample.push_back(boxes[i]); });
}

TileRegion part_of(const TileRegion& whole, const TileSplit& split, std::size_t slab) {
  TileRegion part = whole;
  if (slab > 0) part.from[split.axis()] = split.begin_of(slab);
  if (slab + 1 < split.slabs()) part.to[split.axis()] = split.begin_of(slab + 1);
  return part;
}

/// What one part of the work needs, kept from update to update.
class TileWalker {
 public:
  /// The pairs of these boxes that have the greater of their lower corners in the part.
  void add_pairs(std::span<const FlatBox> boxes, const TileRegion& part, const Aabb* all) {
    descend(boxes, part, all, 0);
  }
  void clear(const PairFilter* wanted) {
    pairs_.clear(wanted);
    tiles_.clear();
  }
  [[nodiscard]] std::span<const TileRegion> tiles() const { return tiles_; }
  [[nodiscard]] PairBuffer& pairs() { return pairs_; }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = pairs_.bytes() + tile_.bytes() + tiles_.capacity() * sizeof(TileRegion) +
                      slabs_.capacity() * sizeof(std::array<std::uint8_t, 2>);
    for (const std::vector<FlatBox>& level : levels_) sum += level.capacity() * sizeof(FlatBox);
    return sum;
  }

 private:
  static constexpr std::size_t most_levels = 12;

  void sweep(std::span<const FlatBox> boxes, const TileRegion& part, const Aabb* all) {
    if (!boxes.empty()) tiles_.push_back(part);
    tile_.add_pairs(boxes, part.from, all, pairs_);
  }

  void descend(std::span<const FlatBox> boxes, const TileRegion& part, const Aabb* all, std::size_t level) {
    if (boxes.size() <= tile_size || level == most_levels) return sweep(boxes, part, all);
    take_sample(boxes, sample_);
    const TileSplit split(sample_, boxes.size(), tile_size, part.from);
    if (split.slabs() < 2) return sweep(boxes, part, all);
    std::array<std::size_t, TileSplit::most_slabs + 1> ends{};
    slabs_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      slabs_[i] = {split.first_slab(boxes[i]), split.last_slab(boxes[i])};
      for (std::size_t slab = slabs_[i][0]; slab <= slabs_[i][1]; ++slab) ++ends[slab];
    }
    std::size_t sum = 0;
    for (std::size_t& end : ends) sum += std::exchange(end, sum);
    // Where most boxes are in most slabs, cutting does not help.
    if (sum > boxes.size() + boxes.size() / 2) return sweep(boxes, part, all);
    std::vector<FlatBox>& parts = levels_[level];
    if (parts.size() < sum) resize_for_overwrite(parts, sum);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t slab = slabs_[i][0]; slab <= slabs_[i][1]; ++slab) parts[ends[slab]++] = boxes[i];
    for (std::size_t slab = 0, begin = 0; slab < split.slabs(); begin = ends[slab++])
      descend(std::span(parts).subspan(begin, ends[slab] - begin), part_of(part, split, slab), all, level + 1);
  }

  Tile tile_;
  PairBuffer pairs_;
  std::vector<TileRegion> tiles_;
  std::vector<FlatBox> sample_;
  std::vector<std::array<std::uint8_t, 2>> slabs_;
  std::array<std::vector<FlatBox>, most_levels> levels_;
};

/// Walkers that are lent out, so that there are no more than threads. Which walker found a pair does not show.
class WalkerPool {
 public:
  /// Clears all walkers, those to come included.
  void clear(const PairFilter* wanted) {
    wanted_ = wanted;
    for (const auto& walker : walkers_) walker->clear(wanted);
  }
  [[nodiscard]] std::size_t take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      free_.push_back(walkers_.size());
      walkers_.push_back(std::make_unique<TileWalker>());
      walkers_.back()->clear(wanted_);
    }
    const std::size_t index = free_.back();
    free_.pop_back();
    return index;
  }
  void give_back(std::size_t index) {
    const std::lock_guard lock(mutex_);
    free_.push_back(index);
  }
  [[nodiscard]] TileWalker& operator[](std::size_t index) {
    const std::lock_guard lock(mutex_);
    return *walkers_[index];
  }
  [[nodiscard]] const std::vector<std::unique_ptr<TileWalker>>& all() const { return walkers_; }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<TileWalker>> walkers_;
  std::vector<std::size_t> free_;
  const PairFilter* wanted_ = nullptr;
};

/// Space is cut along one axis after the other into slabs of as many boxes, until a tile is left with a few hundred,
/// which are swept. A box is in every tile that it reaches into; a pair is told by the tile in which the greater of its
/// two lower corners lies (after J.-P. Dittrich, B. Seeger, "Data redundancy and duplicate detection in spatial join
/// processing", 2000). Tiles follow the boxes: crowded places get small ones.
class KdTiles final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    split_at_top(now);
    pool_.clear(now.wanted);
    parallel_for(top_.slabs(), now.threads, [&](std::size_t slab) {
      const std::size_t begin = slab == 0 ? 0 : ends_[slab - 1];
      const std::size_t lent = pool_.take();
      pool_[lent].add_pairs(std::span(parts_).subspan(begin, ends_[slab] - begin), part_of(everywhere, top_, slab),
                            now.boxes.data());
      pool_.give_back(lent);
    });
    found_.clear();
    for (const auto& walker : pool_.all()) found_.push_back(&walker->pairs());
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> /*boxes*/) const override {
    std::vector<TileRegion> tiles;
    for (const auto& walker : pool_.all()) tiles.insert(tiles.end(), walker->tiles().begin(), walker->tiles().end());
    std::sort(tiles.begin(), tiles.end(), [](const TileRegion& a, const TileRegion& b) { return a.from < b.from; });
    BroadPhaseCells cells;
    CellsOfGroup group(cells, "tiles");
    for (const TileRegion& tile : tiles) group.add(box_of_floats(frame_, tile.from, tile.to));
    return cells;
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = parts_.capacity() * sizeof(FlatBox) + slabs_.capacity() * sizeof(slabs_[0]);
    for (const auto& walker : pool_.all()) sum += walker->bytes();
    return sum;
  }

 private:
  static constexpr float lowest = -std::numeric_limits<float>::infinity();
  static constexpr TileCorner nowhere{lowest, lowest, lowest};  ///< before everything
  static constexpr TileRegion everywhere{nowhere, {-lowest, -lowest, -lowest}};
  static constexpr std::size_t chunks_at_top = 16;
  static constexpr std::array<std::uint8_t, 2> no_slab{1, 0};

  void split_at_top(const BoxesNow& now) {
    const std::size_t count = now.boxes.size();
    std::vector<Aabb> chosen;
    visit_sample(count, 1024, [&](std::size_t i) {
      if (!is_empty(now.boxes[i])) chosen.push_back(now.boxes[i]);
    });
    frame_ = FloatFrame(finite_bounds(chosen));
    sample_.clear();
    for (const Aabb& box : chosen) sample_.push_back(flat_box(frame_, box, 0));
    top_ = TileSplit(sample_, count, tile_size, nowhere);
    slabs_.resize(count);
    std::size_t sum = find_slabs(now);
    if (sum > count + count / 2) {
      top_ = TileSplit({}, count, tile_size, nowhere);
      sum = find_slabs(now);
    }
    if (parts_.size() < sum) resize_for_overwrite(parts_, sum);
    const EvenParts chunks(count, chunks_at_top);
    parallel_for(chunks_at_top, now.threads, [&](std::size_t chunk) {
      auto& places = places_[chunk];
      for (std::size_t number = chunks.begin(chunk); number < chunks.end(chunk); ++number) {
        if (slabs_[number] == no_slab) continue;
        const FlatBox box = flat_box(frame_, now.boxes[number], static_cast<Index>(number));
        for (std::size_t slab = slabs_[number][0]; slab <= slabs_[number][1]; ++slab) parts_[places[slab]++] = box;
      }
    });
    ends_ = places_.back();
  }

  /// And the place of each chunk in each slab. Gives how many boxes are in all slabs together.
  std::size_t find_slabs(const BoxesNow& now) {
    places_.assign(chunks_at_top, {});
    const EvenParts chunks(now.boxes.size(), chunks_at_top);
    parallel_for(chunks_at_top, now.threads, [&](std::size_t chunk) {
      auto& counts = places_[chunk];
      for (std::size_t number = chunks.begin(chunk); number < chunks.end(chunk); ++number) {
        slabs_[number] = no_slab;
        if (is_empty(now.boxes[number])) continue;
        const FlatBox box = flat_box(frame_, now.boxes[number], 0);
        slabs_[number] = {top_.first_slab(box), top_.last_slab(box)};
        for (std::size_t slab = slabs_[number][0]; slab <= slabs_[number][1]; ++slab) ++counts[slab];
      }
    });
    std::size_t sum = 0;
    for (std::size_t slab = 0; slab < TileSplit::most_slabs; ++slab)
      for (auto& places : places_) sum += std::exchange(places[slab], sum);
    return sum;
  }

  FloatFrame frame_;
  TileSplit top_{{}, 0, tile_size, nowhere};
  std::vector<FlatBox> sample_;
  std::vector<std::array<std::uint8_t, 2>> slabs_;  ///< by number
  std::vector<std::array<std::size_t, TileSplit::most_slabs>> places_;
  std::array<std::size_t, TileSplit::most_slabs> ends_{};
  std::vector<FlatBox> parts_;  ///< by slab
  WalkerPool pool_;
  std::vector<const PairBuffer*> found_;
};

}  // namespace

std::unique_ptr<PairFinder> make_kd_tiles() { return std::make_unique<KdTiles>(); }

}  // namespace toccata
