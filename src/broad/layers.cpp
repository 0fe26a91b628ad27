#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "broad/box_sweep.hpp"
#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "broad/packed_bvh.hpp"
#include "core/empty_list.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// Boxes at rest in a tree that is not touched, and movers that are tested against it and swept among themselves. Pairs
/// of two at rest are those of before. A box that moves leaves the tree for good; when too many that once moved rest
/// again, or too many move, the tree is made anew, from those that rest, once it is worth while.
class Layers final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    const std::size_t most_movers = now.boxes.size() / 8;
    if (now.changed.size() > most_movers) {
      if (is_first(now)) return find_and_make(now, std::move(storage));
      if (!everything_) forget_layers();
      return everything_->find(now, std::move(storage));
    }
    const bool is_made = !everything_ && !roles_.empty();
    everything_.reset();
    if (is_made) take_movers(now);
    if (!is_made || movers_.size() > most_movers || wasted_ > now.boxes.size()) make(now.boxes, now.changed);
    wasted_ += movers_.size() - now.changed.size();
    find_new(now);
    // Those of movers are found anew.
    return with_new_pairs(now.before, new_pairs_, std::move(storage), [&](const IndexPair& pair) {
      const bool first_moves = roles_[pair.first] == Role::mover, second_moves = roles_[pair.second] == Role::mover;
      return !(first_moves | second_moves);
    });
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = (everything_ ? everything_->bytes() : 0) + resting_.bytes() + moving_.bytes() + sweep_.bytes() +
                      roles_.capacity() + (places_.capacity() + movers_.capacity()) * sizeof(Index) +
                      flat_movers_.capacity() * sizeof(FlatBox) + new_pairs_.capacity() * sizeof(IndexPair);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    if (everything_) return everything_->cells(boxes);
    BroadPhaseCells cells;
    resting_.add_cells(frame_, cells);
    if (has_moving_tree()) {
      moving_.add_cells(frame_, cells);
      return cells;
    }
    std::vector<Aabb> movers;
    for (const Index number : movers_) movers.push_back(boxes[number]);
    add_intervals(cells, movers, sweep_.axis());
    return cells;
  }

 private:
  static constexpr std::size_t parts = 16;
  static constexpr std::size_t updates_of_order = 32;
  static constexpr std::size_t most_swept = 8192;
  enum class Role : std::uint8_t { none, resting, mover };

  void take_movers(const BoxesNow& now) {
    roles_.resize(now.boxes.size(), Role::none);
    places_.resize(now.boxes.size());
    for (const Index number : now.changed) {
      if (roles_[number] == Role::mover) continue;
      if (roles_[number] == Role::resting) resting_.forget(places_[number]);
      roles_[number] = Role::mover;
      movers_.push_back(number);
    }
  }

  [[nodiscard]] bool is_first(const BoxesNow& now) const {
    return !now.is_only && !everything_ && roles_.empty() && now.changed.size() == now.boxes.size();
  }
  /// What has come is expected to rest, until it moves: so no later update has to make the tree of all at once.
  PairList find_and_make(const BoxesNow& now, PairList storage) {
    PairList pairs = make_kd_tiles()->find(now, std::move(storage));
    make(now.boxes, {});
    return pairs;
  }

  /// They are out of date, and would be twice the memory.
  void forget_layers() {
    everything_ = make_kd_tiles();
    resting_ = {};
    moving_ = {};
    free_list(roles_);
    free_list(places_);
    free_list(movers_);
    free_list(flat_movers_);
  }

  void make(std::span<const Aabb> boxes, std::span<const Index> movers) {
    wasted_ = 0;
    updates_since_order_ = 0;
    roles_.assign(boxes.size(), Role::none);
    places_.resize(boxes.size());
    movers_.assign(movers.begin(), movers.end());
    for (const Index number : movers_) roles_[number] = Role::mover;
    frame_ = FloatFrame(finite_bounds(boxes));
    resting_.build(frame_, boxes, [&](Index number) { return roles_[number] == Role::none; });
    resting_.drop_scratch();
    for (std::size_t place = 0; place < resting_.size(); ++place) {
      const Index number = resting_.number(place);
      roles_[number] = Role::resting;
      places_[number] = static_cast<Index>(place);
    }
  }

  void flatten_movers(const BoxesNow& now) {
    flat_movers_.clear();
    constexpr std::size_t ahead = 16;
    for (std::size_t i = 0; i < movers_.size(); ++i) {
      // They lie anywhere.
      if (i + ahead < movers_.size()) __builtin_prefetch(&now.boxes[movers_[i + ahead]]);
      const Aabb& box = now.boxes[movers_[i]];
      if (!is_empty(box)) flat_movers_.push_back(flat_box(frame_, box, movers_[i]));
    }
  }

  /// Movers that are asked about one after the other shall be near each other, so that they find the same part of the
  /// tree in the cache. They move little from one time to the next.
  void order_movers(const BoxesNow& now) {
    if (updates_since_order_++ % updates_of_order != 0) return;
    flatten_movers(now);
    sort_along_curve(flat_movers_);
    std::erase_if(movers_, [&](Index number) { return !is_empty(now.boxes[number]); });
    for (const FlatBox& mover : flat_movers_) movers_.push_back(mover.number);
  }

  /// A sweep along one axis looks at n^(5/3) pairs of n movers.
  [[nodiscard]] bool has_moving_tree() const { return flat_movers_.size() > most_swept; }

  /// All pairs of movers, with each other and with what rests.
  void find_new(const BoxesNow& now) {
    order_movers(now);
    flatten_movers(now);
    if (has_moving_tree())
      moving_.build(flat_movers_, PackingOrder::morton);
    else
      sweep_.lay_out(flat_movers_, sweep_axis(flat_movers_));
    const EvenParts chunks(flat_movers_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      if (has_moving_tree())
        moving_.add_pairs(now.boxes.data(), chunks.begin(part), chunks.end(part), found_[part]);
      else
        sweep_.add_pairs(now.boxes, chunks.begin(part), chunks.end(part), found_[part]);
      const std::span<const FlatBox> movers =
          std::span(flat_movers_).subspan(chunks.begin(part), chunks.end(part) - chunks.begin(part));
      resting_.add_pairs_with(now.boxes.data(), movers, found_[part]);
    });
    new_pairs_ = sorted_pairs(found_, now.boxes.size(), now.threads, std::move(new_pairs_));
  }

  std::unique_ptr<PairFinder> everything_;  ///< while too many move: then there are no layers
  std::size_t wasted_ = 0;                  ///< how often a mover was looked for that had not moved
  std::size_t updates_since_order_ = 0;
  FloatFrame frame_;
  PackedBvh resting_;
  PackedBvh moving_;           ///< of many movers
  std::vector<Role> roles_;    ///< by number
  std::vector<Index> places_;  ///< in the tree, by number
  std::vector<Index> movers_;
  std::vector<FlatBox> flat_movers_;
  BoxSweep sweep_;
  std::vector<PairBuffer> found_{parts};
  PairList new_pairs_;
};

}  // namespace

std::unique_ptr<PairFinder> make_layers() { return std::make_unique<Layers>(); }

}  // namespace toccata
