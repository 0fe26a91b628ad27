// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/wide_probe.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/wide_probe.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <bit>

#include "trees/block_walk.hpp"
#include "trees/slanted_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

/// A search for what may meet a region.
class ProbeSearch {
 public:
  static constexpr ChildOrder child_order = ChildOrder::any;

  void start(const WideBlock* blocks, const WideProbe& probe, const FunctionRef<bool(Index)>& visit) {
    blocks_ = blocks;
    probe_ = &probe;
    visit_ = &visit;
  }

  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& /*when*/) {
    const Floats d;
    if (first == 0) tests_ += block.count;
    const BlockLanes lanes(block, first);
    unsigned apart = 0;
    for (std::size_t i = 0; i < probe_->count; ++i) {
      const WideProbe::Axis& axis = probe_->axes[i];
      apart |= bits_of(d, is_beyond_along(axis.form, lanes, axis.at, axis.reach));
    }
    return ~apart & part_mask;
  }
  [[nodiscard]] bool wants(float /*when*/) const { return !has_ended_; }
  void prefetch(std::size_t /*number*/) const {}

  void see(std::size_t number, unsigned items, const LaneFloats& /*when*/) {
    for (; items != 0 && !has_ended_; items &= items - 1) {
      const std::int32_t child = blocks_[number].child[static_cast<std::size_t>(std::countr_zero(items))];
      has_ended_ = !(*visit_)(static_cast<Index>(~child));
    }
  }

  [[nodiscard]] std::size_t tests() const { return tests_; }

 private:
  const WideBlock* blocks_;
  const WideProbe* probe_;
  const FunctionRef<bool(Index)>* visit_;
  std::size_t tests_ = 0;
  bool has_ended_ = false;
};

std::size_t run_probe(const WideBvh& tree, std::uint32_t block, const WideProbe& probe,
                      FunctionRef<bool(Index)> visit) {
  BlockWalk<ProbeSearch> walk;
  walk.start_at(tree, block, tree.blocks.data(), probe, visit);
  walk.run();
  return walk.search().tests();
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_probe);

}  // namespace

void walk_probe(const WideBvh& tree, const WideProbe& probe, FunctionRef<bool(Index)> visit) {
  if (tree.blocks.empty()) return;
  walk_probe_below(tree, 0, probe, [&](Index place) { return visit(tree.items[place]); });
}

std::size_t walk_probe_below(const WideBvh& tree, std::uint32_t block, const WideProbe& probe,
                             FunctionRef<bool(Index)> visit) {
  return HWY_DYNAMIC_DISPATCH(run_probe)(tree, block, probe, visit);
}

}  // namespace toccata
#endif
