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

/// When rays are between two sides of boxes.
struct RaySpan {
  Float enter, leave;
};

/// The numbers of rays along an axis, as boxes are asked about them: of one ray in all lanes, or one in each.
struct SlabNumbers {
  Float inverse, steep, start, around;
};

HWY_INLINE RaySpan span_within(const SlabNumbers& rays, const Float& centre, const Float& extent) {
  const Float middle = hn::MulSub(centre, rays.inverse, rays.start);
  const Float reach = hn::MulAdd(extent, rays.steep, rays.around);
  return {hn::Sub(middle, reach), hn::Add(middle, reach)};
}

/// From when and until when rays are in boxes: not before, and not after `limit`.
HWY_INLINE RaySpan common_part(const RaySpan& x, const RaySpan& y, const RaySpan& z, const Float& limit) {
  return {hn::Max(hn::Max(x.enter, y.enter), hn::Max(z.enter, hn::Zero(Floats()))),
          hn::Min(hn::Min(x.leave, y.leave), hn::Min(z.leave, limit))};
}

/// Some is left, or what is not a number.
HWY_INLINE unsigned are_met(const RaySpan& span) {
  return ~bits_of(Floats(), hn::Gt(span.enter, hn::Mul(span.leave, all<Float>(of_times))));
}

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
    const auto within = [&](std::size_t axis) HWY_ATTR {
      return span_within(numbers(axis), lanes_from(block.centre[axis], first), lanes_from(block.extent[axis], first));
    };
    const RaySpan span = common_part(within(0), within(1), within(2), all<Float>(limit));
    hn::Store(span.enter, Floats(), when.data() + first);
    return are_met(span);
  }

  /// Its numbers, in a lane of others'.
  void put(std::size_t lane, std::array<std::array<LaneFloats, 4>, 3>& rows) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      rows[axis][0][lane] = inverse_[axis];
      rows[axis][1][lane] = steep_[axis];
      rows[axis][2][lane] = start_[axis];
      rows[axis][3][lane] = around_[axis];
    }
  }

 private:
  HWY_INLINE SlabNumbers numbers(std::size_t axis) const {
    return {all<Float>(inverse_[axis]), all<Float>(steep_[axis]), all<Float>(start_[axis]), all<Float>(around_[axis])};
  }

  std::array<float, 3> inverse_, steep_, start_, around_;
  float pad_;
};

/// The numbers of rays' lines as triangles are asked about them: of one in all lanes, or one in each. The axes are the
/// lines': the last is that along which they move most.
struct LineNumbers {
  std::array<Float, 3> origin;
  std::array<Float, 2> lean;
  Float per_depth;
  Float off;    ///< by how much a corner, seen along the line, is off at most
  Float spare;  ///< what a box may be farther from a line that meets it
};

/// What is told of lines and triangles, in each lane.
struct LinesTold {
  unsigned possible;   ///< the others are not met at a time from 0 to 1
  unsigned certain;    ///< met at a time between 0 and 1
  Float lower, upper;  ///< of the time
};

/// A corner, from the ray's origin: where it is seen along the line, and how far away along the last axis.
struct SeenCorner {
  Float x, y, depth;
};

HWY_INLINE SeenCorner seen_corner(const LineNumbers& line, const Float& x, const Float& y, const Float& along) {
  const Float depth = hn::Sub(along, line.origin[2]);
  return {hn::NegMulAdd(line.lean[0], depth, hn::Sub(x, line.origin[0])),
          hn::NegMulAdd(line.lean[1], depth, hn::Sub(y, line.origin[1])), depth};
}

/// Twice the area that the line sees of the triangle of two corners and the origin.
HWY_INLINE Float seen_area(const SeenCorner& p, const SeenCorner& q) { return hn::MulSub(p.x, q.y, hn::Mul(p.y, q.x)); }

/// What is told of the lanes in `among`, in which lines meet the boxes of triangles; `extents` are those of the boxes,
/// added up (S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection", 2013; the bounds are ours).
HWY_INLINE LinesTold told_of(const LineNumbers& line, const SeenCorner& a, const SeenCorner& b, const SeenCorner& c,
                             const Float& extents, unsigned among) {
  LinesTold told{0, 0, hn::Zero(Floats()), hn::Zero(Floats())};
  // What the areas opposite to the corners are off by at most.
  const Float factor = hn::Mul(all<Float>(7), line.off), size = hn::MulAdd(all<Float>(2), extents, line.spare);
  const Float off = hn::MulAdd(factor, size, hn::Mul(factor, line.off));
  const Float of_a = seen_area(b, c), of_b = seen_area(c, a), of_c = seen_area(a, b);
  const Float least = hn::Min(hn::Min(of_a, of_b), of_c), most = hn::Max(hn::Max(of_a, of_b), of_c);
  const unsigned kept = ~bits_of(Floats(), hn::And(hn::Lt(least, hn::Neg(off)), hn::Gt(most, off))) & among;
  if (kept == 0) return told;
  const Float whole = hn::Add(hn::Add(of_a, of_b), of_c), six_off = hn::Mul(all<Float>(6), off);
  const Float inverse = hn::Div(all<Float>(1), whole);
  const Float depth = hn::MulAdd(of_a, a.depth, hn::MulAdd(of_b, b.depth, hn::Mul(of_c, c.depth)));
  const Float time = hn::Mul(hn::Mul(depth, inverse), line.per_depth);
  const Float share = hn::Mul(hn::Mul(six_off, size), hn::Abs(inverse));
  const Float wide = hn::Mul(hn::Add(share, hn::Mul(all<Float>(4), line.off)), hn::Abs(line.per_depth));
  // The line certainly passes through the triangle, within these times.
  const FloatMask agree =
      hn::And(hn::Or(hn::Gt(least, off), hn::Lt(most, hn::Neg(off))), hn::Ge(hn::Abs(whole), six_off));
  const Float lower = hn::Sub(time, wide), upper = hn::Add(time, wide), zero = hn::Zero(Floats()), one = all<Float>(1);
  const unsigned passed = bits_of(Floats(), agree) & kept;
  const unsigned beside = bits_of(Floats(), hn::Or(hn::Gt(lower, one), hn::Lt(upper, zero))) & passed;
  told.possible = kept & ~beside;
  told.certain = bits_of(Floats(), hn::And(hn::Gt(lower, zero), hn::Lt(upper, one))) & passed;
  told.lower = hn::IfThenElseZero(agree, lower);
  told.upper = upper;
  return told;
}

/// The ray's line as triangles are asked about it.
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
  /// The last is that of the greatest motion.
  [[nodiscard]] const std::array<std::size_t, 3>& axes() const { return axis_; }

  HWY_INLINE LineNumbers numbers() const {
    return {{all<Float>(origin_[0]), all<Float>(origin_[1]), all<Float>(origin_[2])},
            {all<Float>(lean_[0]), all<Float>(lean_[1])},
            all<Float>(per_depth_),
            all<Float>(off_),
            all<Float>(spare_)};
  }

  /// The same, in a lane of others'.
  void put(std::size_t lane, std::array<LaneFloats, 8>& rows) const {
    for (std::size_t i = 0; i < 3; ++i) rows[i][lane] = origin_[i];
    for (std::size_t i = 0; i < 2; ++i) rows[3 + i][lane] = lean_[i];
    rows[5][lane] = per_depth_;
    rows[6][lane] = off_;
    rows[7][lane] = spare_;
  }

 private:
  std::array<std::size_t, 3> axis_;
  std::array<float, 3> origin_;
  std::array<float, 2> lean_;
  float per_depth_, off_, spare_;
  bool usable_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
