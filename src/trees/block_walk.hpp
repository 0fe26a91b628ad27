// One walk over a wide tree, for any search in it, and many such walks side by side. Included once for every SIMD
// level, like math/lanes.hpp.
#if defined(TOCCATA_TREES_BLOCK_WALK_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_BLOCK_WALK_HPP
#undef TOCCATA_TREES_BLOCK_WALK_HPP
#else
#define TOCCATA_TREES_BLOCK_WALK_HPP
#endif

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "core/prefetch.hpp"
#include "trees/block_lanes.hpp"
#include "trees/pending_stack.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

using LaneFloats = std::array<float, WideBlock::width>;

/// Which of a block's children comes first, and which memory is asked for before its turn comes.
enum class ChildOrder {
  any,              ///< the last one; that of all children that wait
  nearest_of_few,   ///< the nearest; that of all that wait, and of items, which are looked at a step later
  nearest_of_many,  ///< the nearest; that of the next block alone, and of its items
};

/// What a walk asks of a search:
///  - child_order;
///  - meet(block, first, when): of the lanes of a vector, from `first` on, which are of interest, as bits; `when` gets
///    their turns, none of them negative: the least comes first;
///  - wants(when): what has that turn is still of interest;
///  - opens(when), if it is there: that turn has come; the root's is not told;
///  - prefetch(number): asks for the memory of a block's items;
///  - see(number, lanes, when): looks at the items in these lanes of a block.
template <class S>
concept BlockSearch = requires(S& search, const WideBlock& block, std::size_t number, unsigned lanes,
                               LaneFloats& when) {
  { S::child_order } -> std::convertible_to<ChildOrder>;
  { search.meet(block, number, when) } -> std::same_as<unsigned>;
  { search.wants(0.0F) } -> std::same_as<bool>;
  search.prefetch(number);
  search.see(number, lanes, when);
};

/// Depth first through a tree; memory is asked for ahead.
template <BlockSearch Search>
class BlockWalk {
 public:
  /// Before the first step, and again after the last one. The tree is not empty; the rest is for the search.
  template <class... Parts>
  HWY_INLINE void start(const WideBvh& tree, Parts&&... parts) {
    start_at(tree, 0, parts...);
  }

  /// The same of what is below one block.
  template <class... Parts>
  HWY_INLINE void start_at(const WideBvh& tree, std::uint32_t block, Parts&&... parts) {
    blocks_ = tree.blocks.data();
    block_ = static_cast<std::int32_t>(block);
    items_ = 0;
    search_.start(parts...);
  }

  /// Opens a block, or looks at the items of the last one; false when there is nothing more.
  HWY_INLINE bool step() {
    if (items_ == 0) return open(blocks_[block_]) || next();
    search_.see(static_cast<std::size_t>(opened_), items_, when_);
    items_ = 0;
    return next();
  }

  void run() {
    while (step())
      if (asks_for_next && !pending_.empty()) ask_for(pending_.top().block);
  }

  /// Asks for the memory of the next block before its turn comes.
  HWY_INLINE void prefetch_next() const {
    if (asks_for_next) ask_for(block_);
  }

  [[nodiscard]] Search& search() { return search_; }

 private:
  static constexpr ChildOrder order = Search::child_order;
  static constexpr bool asks_for_next = order == ChildOrder::nearest_of_many;

  HWY_INLINE void tell_opened(float when) {
    if constexpr (requires { search_.opens(when); }) search_.opens(when);
  }

  HWY_INLINE void ask_for(std::int32_t block) const {
    prefetch(blocks_[block]);
    if (asks_for_next) search_.prefetch(static_cast<std::size_t>(block));
  }

  /// The inner children of interest wait for their turn. True where it is clear what the next step is.
  HWY_INLINE bool open(const WideBlock& block) {
    unsigned met = 0;
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes)
      met |= search_.meet(block, first, when_) << first;
    met &= lanes_in_use(block);
    const unsigned items = items_of(block) & met, inner = met & ~items;
    if (items != 0) {
      see_or_wait(items);
      if (inner != 0) wait(block, inner);
      return order == ChildOrder::nearest_of_few;
    }
    if (inner == 0) return false;
    const unsigned others = inner & (inner - 1);
    const bool two_at_most = (others & (others - 1)) == 0;
    if (order != ChildOrder::any && two_at_most) {
      go_to_first_of_two(block, inner);
      return true;
    }
    wait(block, inner);
    return false;
  }

  HWY_INLINE void see_or_wait(unsigned items) {
    const auto number = static_cast<std::size_t>(block_);
    if constexpr (order == ChildOrder::nearest_of_few) {
      items_ = items;
      opened_ = block_;
      search_.prefetch(number);
    } else {
      search_.see(number, items, when_);
    }
  }

  /// Goes to the one of two inner children that comes first, or to the only one. Which of them it is cannot be
  /// foreseen, so nothing branches on it.
  HWY_INLINE void go_to_first_of_two(const WideBlock& block, unsigned inner) {
    const auto one = static_cast<std::size_t>(std::countr_zero(inner));
    const auto other = static_cast<std::size_t>(std::bit_width(inner) - 1);
    const bool other_first = when_[other] < when_[one];
    const std::size_t near = other_first ? other : one, far = other_first ? one : other;
    block_ = block.child[near];
    tell_opened(when_[near]);
    if (!asks_for_next) ask_for(block_);
    if (near == far) return;
    if (!asks_for_next) ask_for(block.child[far]);
    pending_.make_room();
    pending_.put(0, {when_[far], block.child[far]});
    pending_.claim(1);
  }

  HWY_INLINE void wait(const WideBlock& block, unsigned inner) {
    pending_.make_room();
    if constexpr (order == ChildOrder::nearest_of_many) return wait_ranked(block, inner);
    for (std::size_t count = 0; inner != 0; inner &= inner - 1, ++count) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(inner));
      const std::int32_t child = block.child[lane];
      ask_for(child);
      if constexpr (order == ChildOrder::any)
        pending_.insert({0, child}, 0);
      else
        pending_.insert({when_[lane], child}, count);
    }
  }

  /// Sorted without branches, which could not be foreseen: each is put where the number of later ones says. Those that
  /// do not wait come last, and are not claimed. The last bits of the turns give way to the lanes' numbers.
  HWY_INLINE void wait_ranked(const WideBlock& block, unsigned inner) {
    const LaneIntegers d;
    const hn::Rebind<float, LaneIntegers> f;
    alignas(64) std::array<std::int32_t, WideBlock::width> key, place;
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const auto lane = hn::Iota(d, static_cast<std::int32_t>(first));
      const auto bits = hn::And(hn::BitCast(d, hn::Load(f, when_.data() + first)), hn::Set(d, 0x7FFFFFF8));
      const auto bit = hn::Load(d, lane_bit.data() + first);
      const auto waits = hn::Eq(hn::And(hn::Set(d, static_cast<std::int32_t>(inner)), bit), bit);
      hn::Store(hn::IfThenElse(waits, hn::Or(bits, lane), hn::Not(lane)), d, key.data() + first);
    }
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const auto own = hn::Load(d, key.data() + first);
      auto later = hn::Zero(d);
      for (const std::int32_t other : key) later = hn::Sub(later, hn::VecFromMask(d, hn::Gt(hn::Set(d, other), own)));
      hn::Store(later, d, place.data() + first);
    }
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane)
      pending_.put(static_cast<std::size_t>(place[lane]), {when_[lane], block.child[lane]});
    pending_.claim(static_cast<std::size_t>(std::popcount(inner)));
  }

  /// The next that waits and is still of interest.
  HWY_INLINE bool next() {
    while (!pending_.empty()) {
      const Pending one = pending_.pop();
      block_ = one.block;
      if (!search_.wants(one.when)) continue;
      tell_opened(one.when);
      return true;
    }
    return false;
  }

  const WideBlock* blocks_;
  Search search_;
  std::int32_t block_, opened_;
  unsigned items_;               ///< of the block that was opened last: those of interest
  alignas(64) LaneFloats when_;  ///< and when their turns are
  PendingStack pending_;
};

/// Many walks, of which a few are under way at a time, a step each in turn: while one waits for memory, another is
/// worked on. `start(walk, place, i)` starts the i-th in the place of one that is done, and `end(walk, place)` is
/// called as it ends.
template <class Walk, std::size_t most, class Start, class End>
HWY_INLINE void walk_abreast(std::size_t count, const Start& start, const End& end) {
  std::array<Walk, most> walks;
  std::array<Walk*, most> walking;
  const auto place_of = [&](const Walk* walk) { return static_cast<std::size_t>(walk - walks.data()); };
  std::size_t next = 0, under_way = 0;
  for (; next < most && next < count; ++next) {
    walking[under_way++] = &walks[next];
    start(walks[next], next, next);
  }
  while (under_way > 0)
    for (std::size_t i = 0; i < under_way; ++i) {
      Walk* const walk = walking[i];
      if (walk->step()) {
        walk->prefetch_next();
        continue;
      }
      end(*walk, place_of(walk));
      if (next < count)
        start(*walk, place_of(walk), next++);
      else
        walking[i--] = walking[--under_way];
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
