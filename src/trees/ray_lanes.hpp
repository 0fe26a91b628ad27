// What floats tell of a ray and the boxes and triangles of a block: docs/design/rays.md, which has the proofs.
// Included once for every SIMD level, so its guard toggles with Highway's.
#if defined(TOCCATA_TREES_RAY_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_RAY_LANES_HPP
#undef TOCCATA_TREES_RAY_LANES_HPP
#else
#define TOCCATA_TREES_RAY_LANES_HPP
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "trees/block_walk.hpp"
#include "trees/wide_ray.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Float lanes_from(const LaneFloats& of, std::size_t first) { return hn::Load(Floats(), of.data() + first); }

/// Times are products with a reciprocal, off by less than that, relatively.
constexpr float of_times = 1 + 0x1p-20F;

/// The ray as the boxes are asked about it.
class RaySlabs {
 public:
  void set(const WideRay& ray) {
    // Motions along an axis that are too small to tell anything are made larger; the pad covers it, as it does what is
    // rounded in a sum of a few numbers that are at most 8.
    constexpr float least = 0x1p-30F, of_sums = 0x1p-18F;
    pad_ = ray.pad + of_sums;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float motion = ray.motion[axis];
      inverse_[axis] = 1 / (std::fabs(motion) >= least ? motion : least);
      steep_[axis] = std::fabs(inverse_[axis]);
      start_[axis] = ray.origin[axis] * inverse_[axis];
      around_[axis] = pad_ * steep_[axis];
    }
  }

  [[nodiscard]] float pad() const { return pad_; }

  /// Which lanes are met no later than `limit`, and when. What is not a number keeps the lane.
  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, float limit, LaneFloats& when) const {
    const Span x = within(block, 0, first), y = within(block, 1, first), z = within(block, 2, first);
    const Float enter = hn::Max(hn::Max(x.enter, y.enter), hn::Max(z.enter, hn::Zero(Floats())));
    const Float leave = hn::Min(hn::Min(x.leave, y.leave), hn::Min(z.leave, all<Float>(limit)));
    hn::Store(enter, Floats(), when.data() + first);
    return ~bits_of(Floats(), hn::Gt(enter, hn::Mul(leave, all<Float>(of_times))));
  }

 private:
  struct Span {
    Float enter, leave;
  };

  HWY_INLINE Span within(const WideBlock& block, std::size_t axis, std::size_t first) const {
    const Float middle =
        hn::MulSub(lanes_from(block.centre[axis], first), all<Float>(inverse_[axis]), all<Float>(start_[axis]));
    const Float reach =
        hn::MulAdd(lanes_from(block.extent[axis], first), all<Float>(steep_[axis]), all<Float>(around_[axis]));
    return {hn::Sub(middle, reach), hn::Add(middle, reach)};
  }

  std::array<float, 3> inverse_, steep_, start_, around_;
  float pad_;
};

/// The ray's line as triangles are asked about it: seen along it, across the axis of its greatest motion, which is the
/// last (S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection", 2013; the bounds are ours).
class RayLine {
 public:
  void set(const WideRay& ray, float pad) {
    constexpr float shortest = 0x1p-60F, greatest_lean = 0x1p-10F;
    const auto size = [&](std::size_t axis) { return std::fabs(ray.motion[axis]); };
    std::size_t along = size(0) >= size(1) ? 0 : 1;
    if (size(2) > size(along)) along = 2;
    axis_ = {along == 0 ? std::size_t{1} : 0, along == 2 ? std::size_t{1} : 2, along};
    for (std::size_t i = 0; i < 3; ++i) origin_[i] = ray.origin[axis_[i]];
    usable_ = size(along) >= shortest && ray.lean <= greatest_lean;
    per_depth_ = 1 / ray.motion[along];
    lean_ = {ray.motion[axis_[0]] * per_depth_, ray.motion[axis_[1]] * per_depth_};
    off_ = 2 * ray.pad + 5 * ray.lean;
    spare_ = 16 * pad;
  }

  /// It can tell anything.
  [[nodiscard]] bool usable() const { return usable_; }

  /// A corner, from the ray's origin: where it is seen, and how far away along the last axis.
  struct Corner {
    Float x, y, depth;
  };

  HWY_INLINE Corner corner(const TriangleLanes& triangles, std::size_t number, std::size_t first) const {
    const auto from = [&](std::size_t i) HWY_ATTR {
      return hn::Sub(lanes_from(triangles.corner[number][axis_[i]], first), all<Float>(origin_[i]));
    };
    const Float depth = from(2);
    return {hn::NegMulAdd(all<Float>(lean_[0]), depth, from(0)), hn::NegMulAdd(all<Float>(lean_[1]), depth, from(1)),
            depth};
  }

  /// Twice the areas that the line sees of a triangle opposite to its corners, and what they are off by at most.
  struct Areas {
    Float a, b, c, off, size;
  };

  HWY_INLINE Areas areas(const WideBlock& block, const Corner& a, const Corner& b, const Corner& c,
                         std::size_t first) const {
    const Float extents = hn::Add(hn::Add(lanes_from(block.extent[0], first), lanes_from(block.extent[1], first)),
                                  lanes_from(block.extent[2], first));
    const float factor = 7 * off_;
    const Float size = hn::MulAdd(all<Float>(2), extents, all<Float>(spare_));
    return {area(b, c), area(c, a), area(a, b), hn::MulAdd(all<Float>(factor), size, all<Float>(factor * off_)), size};
  }

  HWY_INLINE FloatMask missed(const Areas& of) const {
    const Float least = hn::Min(hn::Min(of.a, of.b), of.c), most = hn::Max(hn::Max(of.a, of.b), of.c);
    return hn::And(hn::Lt(least, hn::Neg(of.off)), hn::Gt(most, of.off));
  }

  /// Of lanes that are not missed.
  struct Times {
    FloatMask agree;  ///< the line certainly passes through the triangle, within these times
    Float lower, upper;
  };

  HWY_INLINE Times times(const Areas& of, const Corner& a, const Corner& b, const Corner& c) const {
    const Float whole = hn::Add(hn::Add(of.a, of.b), of.c), off = hn::Mul(all<Float>(6), of.off);
    const Float least = hn::Min(hn::Min(of.a, of.b), of.c), most = hn::Max(hn::Max(of.a, of.b), of.c);
    const Float inverse = hn::Div(all<Float>(1), whole);
    const Float depth = hn::MulAdd(of.a, a.depth, hn::MulAdd(of.b, b.depth, hn::Mul(of.c, c.depth)));
    const Float time = hn::Mul(hn::Mul(depth, inverse), all<Float>(per_depth_));
    const Float share = hn::Mul(hn::Mul(off, of.size), hn::Abs(inverse));
    const Float wide = hn::Mul(hn::Add(share, all<Float>(4 * off_)), all<Float>(std::fabs(per_depth_)));
    const FloatMask one_sign = hn::Or(hn::Gt(least, of.off), hn::Lt(most, hn::Neg(of.off)));
    return {hn::And(one_sign, hn::Ge(hn::Abs(whole), off)), hn::Sub(time, wide), hn::Add(time, wide)};
  }

 private:
  HWY_INLINE static Float area(const Corner& p, const Corner& q) { return hn::MulSub(p.x, q.y, hn::Mul(p.y, q.x)); }

  std::array<std::size_t, 3> axis_;
  std::array<float, 3> origin_;
  std::array<float, 2> lean_;
  float per_depth_;
  float off_;    ///< by how much a corner, seen along the line, is off at most
  float spare_;  ///< what a box may be farther from a line that meets it
  bool usable_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
