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

  void start(const WideBvh& tree, const WideProbe& probe, const FunctionRef<bool(Index)>& visit) {
    tree_ = &tree;
    probe_ = &probe;
    visit_ = &visit;
  }

  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& /*when*/) const {
    const Floats d;
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
      const std::int32_t child = tree_->blocks[number].child[static_cast<std::size_t>(std::countr_zero(items))];
      has_ended_ = !(*visit_)(tree_->items[static_cast<std::size_t>(~child)]);
    }
  }

 private:
  const WideBvh* tree_;
  const WideProbe* probe_;
  const FunctionRef<bool(Index)>* visit_;
  bool has_ended_ = false;
};

void run_probe(const WideBvh& tree, const WideProbe& probe, FunctionRef<bool(Index)> visit) {
  BlockWalk<ProbeSearch> walk;
  walk.start(tree, tree, probe, visit);
  walk.run();
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
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_probe)(tree, probe, visit);
}

}  // namespace toccata
#endif
