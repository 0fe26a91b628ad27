#include "trees/wide_ray.hpp"

#include "trees/pending_stack.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/wide_ray.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WideBlock::width>;
constexpr std::size_t lanes = std::min<std::size_t>(WideBlock::width, HWY_LANES(float));
constexpr std::size_t parts = WideBlock::width / lanes;
constexpr unsigned part_mask = (1U << lanes) - 1U;

/// A part of the way, as in docs/design/rays.md: times are off by that, relatively.
constexpr float of_times = 1 + 0x1p-20F;

/// The ray along one axis.
struct Along {
  float origin;
  float inverse;
};

/// Motions along an axis that are too small to tell anything are made larger; the pad covers it, as it does what is
/// rounded in a sum of a few numbers that are at most 8.
constexpr float of_sums = 0x1p-18F;

Along along(const WideRay& ray, std::size_t axis) {
  constexpr float least = 0x1p-30F;
  const float motion = ray.motion[axis];
  return {ray.origin[axis], 1 / (std::fabs(motion) >= least ? motion : least)};
}

struct Span {
  hn::Vec<Floats> enter, leave;
};

HWY_INLINE Span within(const Along& ray, hn::Vec<Floats> centre, hn::Vec<Floats> reach) {
  const Floats d;
  const auto middle = hn::Sub(centre, hn::Set(d, ray.origin)), inverse = hn::Set(d, ray.inverse);
  const auto s = hn::Mul(hn::Sub(middle, reach), inverse), t = hn::Mul(hn::Add(middle, reach), inverse);
  return {hn::Min(s, t), hn::Max(s, t)};
}

class RayWalk {
 public:
  RayWalk(const WideTree& tree, const WideRay& ray)
      : tree_(tree), ray_{along(ray, 0), along(ray, 1), along(ray, 2)}, pad_(ray.pad + of_sums) {}

  /// Opens a block or shows an item; false when there is nothing more.
  template <class Visit>
  HWY_INLINE bool step(const Visit& visit) {
    const bool leads_on = child_ >= 0 ? open(tree_.blocks[static_cast<std::size_t>(child_)], child_)
                                      : see(visit(~static_cast<Index>(child_)));
    return leads_on || next(child_);
  }

 private:
  /// What is of interest ends earlier now. Nothing follows from an item.
  bool see(float limit) {
    limit_ = std::min(limit_, limit);
    return false;
  }

  /// The earliest child that is met becomes the next; the others wait. False where none is met.
  bool open(const WideBlock& block, std::int32_t& child) {
    alignas(64) std::array<float, WideBlock::width> when;
    unsigned met = 0;
    for (std::size_t part = 0; part < parts; ++part) met |= meet(block, part * lanes, when) << part * lanes;
    met &= (1U << block.count) - 1U;
    if (met == 0) return false;
    const auto first = static_cast<std::size_t>(std::countr_zero(met));
    met &= met - 1;
    if (met == 0) {
      child = block.child[first];
      return true;
    }
    pending_.make_room();
    prefetch(block.child[first]);
    pending_.insert({when[first], block.child[first]}, 0);
    for (std::size_t count = 1; met != 0; met &= met - 1, ++count) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(met));
      prefetch(block.child[lane]);
      pending_.insert({when[lane], block.child[lane]}, count);
    }
    child = pending_.pop().child;
    return true;
  }

  /// Asks for the memory of a block before its turn comes.
  HWY_INLINE void prefetch(std::int32_t child) const {
    if (child < 0) return;
    const auto* bytes = reinterpret_cast<const char*>(&tree_.blocks[static_cast<std::size_t>(child)]);
    for (std::size_t line = 0; line < sizeof(WideBlock); line += 64) __builtin_prefetch(bytes + line);
  }

  /// The next that waits and is still of interest. None is when the limit is less than 0.
  bool next(std::int32_t& child) {
    while (!pending_.empty()) {
      const Pending one = pending_.pop();
      child = one.child;
      if (!(one.when > limit_ * of_times)) return limit_ >= 0;
    }
    return false;
  }

  /// Which lanes are met, and when. What is not a number keeps the lane.
  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, std::array<float, WideBlock::width>& when) const {
    const Floats d;
    const auto on = [&](std::size_t axis) HWY_ATTR {
      return within(ray_[axis], hn::Load(d, block.centre[axis].data() + first),
                    hn::Add(hn::Load(d, block.extent[axis].data() + first), hn::Set(d, pad_)));
    };
    const Span x = on(0), y = on(1), z = on(2);
    const auto enter = hn::Max(hn::Max(x.enter, y.enter), hn::Max(z.enter, hn::Zero(d)));
    const auto leave = hn::Min(hn::Min(x.leave, y.leave), hn::Min(z.leave, hn::Set(d, limit_)));
    hn::Store(enter, d, when.data() + first);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(enter, hn::Mul(leave, hn::Set(d, of_times))), bits);
    return ~static_cast<unsigned>(bits[0]) & part_mask;
  }

  const WideTree& tree_;
  std::array<Along, 3> ray_;
  float pad_;
  float limit_ = 1;
  std::int32_t child_ = 0;
  PendingStack pending_;
};

void run_ray(const WideTree& tree, const WideRay& ray, FunctionRef<float(Index)> visit) {
  RayWalk walk(tree, ray);
  while (walk.step(visit)) {
  }
}

/// So many walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
constexpr std::size_t abreast = 4;

/// Rays that walk side by side, the next one in the place of one that is done.
class RaysAbreast {
 public:
  RaysAbreast(const WideTree& tree, std::span<const WideRay> rays) : tree_(tree), rays_(rays) {}

  template <class Visit>
  void run(const Visit& visit) {
    for (Place& place : places_) start_next(place);
    while (walking_ > 0)
      for (Place& place : places_)
        if (place.walk && !place.walk->step([&](Index item) { return visit(place.ray, item); })) {
          place.walk.reset();
          --walking_;
          start_next(place);
        }
  }

 private:
  struct Place {
    std::optional<RayWalk> walk;
    std::size_t ray = 0;
  };

  void start_next(Place& place) {
    if (next_ == rays_.size()) return;
    place.walk.emplace(tree_, rays_[next_]);
    place.ray = next_++;
    ++walking_;
  }

  const WideTree& tree_;
  std::span<const WideRay> rays_;
  std::size_t next_ = 0, walking_ = 0;
  std::array<Place, abreast> places_;
};

void run_rays(const WideTree& tree, std::span<const WideRay> rays, FunctionRef<float(std::size_t, Index)> visit) {
  RaysAbreast(tree, rays).run(visit);
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_ray);
HWY_EXPORT(run_rays);

}  // namespace

void walk_ray(const WideTree& tree, const WideRay& ray, FunctionRef<float(Index)> visit) {
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_ray)(tree, ray, visit);
}

void walk_rays(const WideTree& tree, std::span<const WideRay> rays, FunctionRef<float(std::size_t, Index)> visit) {
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_rays)(tree, rays, visit);
}

}  // namespace toccata
#endif
