// Are poses rigid but for rounding, as nearly all are? For files of one pair at a time (lanes.hpp).
// Included once for every SIMD level, like lanes.hpp.
#if defined(TOCCATA_NARROW_RIGID_POSES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_RIGID_POSES_HPP
#undef TOCCATA_NARROW_RIGID_POSES_HPP
#else
#define TOCCATA_NARROW_RIGID_POSES_HPP
#endif

#include "math/world_vertex.hpp"
#include "narrow/pose_checks.hpp"
#include "narrow/triangles/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

// Every |RᵀR − I| is below 2^-42 in its diagonal and below 2^-43 beside it. Such a pose deforms nothing, is not
// singular, and is finite but for its offset. "No" says nothing.

#if HWY_TARGET <= HWY_AVX2
constexpr double rigid_bound = 0x1p-42;

struct Rows {
  Vector x, y, z;
};

HWY_INLINE Rows rows_of(const Pose& pose) {
  return {lanes_of(pose.linear[0]), lanes_of(pose.linear[1]), lanes_of(pose.linear[2])};
}

/// u · v of each column; nothing here needs the same bits everywhere, so products may be fused.
HWY_INLINE hn::Vec<Coordinates> products_of_columns(const Rows& u, const Rows& v) {
  return hn::MulAdd(u.x.xyz, v.x.xyz, hn::MulAdd(u.y.xyz, v.y.xyz, hn::Mul(u.z.xyz, v.z.xyz)));
}

/// Of each column the square of its length, less 1, and twice its product with the next: magnitudes.
HWY_INLINE hn::Vec<Coordinates> skew_of(const Rows& r) {
  alignas(32) static constexpr double ones[4] = {1, 1, 1, 0};
  const auto squares = products_of_columns(r, r), products = products_of_columns(r, {next(r.x), next(r.y), next(r.z)});
  return hn::Add(hn::Abs(hn::Sub(squares, hn::Load(Coordinates(), ones))), hn::Abs(hn::Add(products, products)));
}

/// The world vertices of a pose, bit by bit, all coordinates at once.
class Placing {
 public:
  HWY_INLINE explicit Placing(const Pose& pose) : offset_(lanes_of(pose.offset)) {
    const Rows r = rows_of(pose);
    constexpr Coordinates tag;
    const auto even = hn::InterleaveLower(tag, r.x.xyz, r.y.xyz), odd = hn::InterleaveUpper(tag, r.x.xyz, r.y.xyz);
    x_ = {hn::ConcatLowerLower(tag, r.z.xyz, even)};
    y_ = {hn::ConcatLowerLower(tag, hn::InterleaveUpper(tag, r.z.xyz, r.z.xyz), odd)};
    z_ = {hn::ConcatUpperUpper(tag, r.z.xyz, even)};
  }

  HWY_INLINE Vector operator()(const Vec3& v) const {
    return plus(plus(plus(times(all(v.x), x_), times(all(v.y), y_)), times(all(v.z), z_)), offset_);
  }

 private:
  Vector x_, y_, z_;  // the columns
  Vector offset_;
};

HWY_INLINE bool are_rigid(const Pose& a, const Pose& b) {
  const auto skew = hn::Add(skew_of(rows_of(a)), skew_of(rows_of(b)));
  return hn::AllTrue(Coordinates(), hn::Lt(skew, hn::Set(Coordinates(), rigid_bound)));
}
#else
class Placing {
 public:
  HWY_INLINE explicit Placing(const Pose& pose) : pose_(pose) {}
  HWY_INLINE Vector operator()(const Vec3& v) const { return lanes_of(world_vertex(pose_, v)); }

 private:
  const Pose& pose_;
};

HWY_INLINE bool are_rigid(const Pose& a, const Pose& b) {
  return is_surely_rigid(a.linear) && is_surely_rigid(b.linear);
}
#endif

/// The world vertex. Shapes are mostly around the origin of their frame.
HWY_INLINE Vec3 placed(const Pose& pose, const Vec3& local) {
  return local == Vec3{} ? pose.offset : world_vertex(pose, local);
}
HWY_INLINE Vector placed_lanes(const Pose& pose, const Vec3& local) {
  return local == Vec3{} ? lanes_of(pose.offset) : Placing(pose)(local);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
