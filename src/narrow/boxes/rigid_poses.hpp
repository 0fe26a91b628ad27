// Are poses rigid but for rounding, as nearly all are? For one pair at a time (one_lane.hpp).
// Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_RIGID_POSES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_RIGID_POSES_HPP
#undef TOCCATA_NARROW_RIGID_POSES_HPP
#else
#define TOCCATA_NARROW_RIGID_POSES_HPP
#endif

#include "math/world_vertex.hpp"
#include "narrow/pose_checks.hpp"
#include "narrow/triangles/one_lane.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

// Every |RᵀR − I| is below 2^-42 in its diagonal and below 2^-43 beside it. Such a pose deforms nothing, is not
// singular, and is finite but for its offset. "No" says nothing.

#if HWY_TARGET <= HWY_AVX2
constexpr double most_skew_of_rigid = 0x1p-42;

struct PoseRows {
  OneVector x, y, z;
};

HWY_INLINE PoseRows rows_of(const Pose& pose) {
  return {in_one(pose.linear[0]), in_one(pose.linear[1]), in_one(pose.linear[2])};
}

/// u · v of each column; nothing here needs the same bits everywhere, so products may be fused.
HWY_INLINE hn::Vec<Coordinates> products_of_columns(const PoseRows& u, const PoseRows& v) {
  return hn::MulAdd(u.x.xyz, v.x.xyz, hn::MulAdd(u.y.xyz, v.y.xyz, hn::Mul(u.z.xyz, v.z.xyz)));
}

/// For each column the square of its length, less 1, and twice its product with the next: the sum of their magnitudes.
HWY_INLINE hn::Vec<Coordinates> skew_of(const PoseRows& r) {
  alignas(32) static constexpr double ones[4] = {1, 1, 1, 0};
  const auto squares = products_of_columns(r, r), products = products_of_columns(r, {next(r.x), next(r.y), next(r.z)});
  return hn::Add(hn::Abs(hn::Sub(squares, hn::Load(Coordinates(), ones))), hn::Abs(hn::Add(products, products)));
}

/// The world vertices of a pose, bit by bit, all coordinates at once.
class Placing {
 public:
  HWY_INLINE explicit Placing(const Pose& pose) : offset_(in_one(pose.offset)) {
    const PoseRows r = rows_of(pose);
    constexpr Coordinates four;
    const auto even = hn::InterleaveLower(four, r.x.xyz, r.y.xyz), odd = hn::InterleaveUpper(four, r.x.xyz, r.y.xyz);
    x_ = {hn::ConcatLowerLower(four, r.z.xyz, even)};
    y_ = {hn::ConcatLowerLower(four, hn::InterleaveUpper(four, r.z.xyz, r.z.xyz), odd)};
    z_ = {hn::ConcatUpperUpper(four, r.z.xyz, even)};
  }

  HWY_INLINE OneVector operator()(const Vec3& v) const {
    return plus(
        plus(plus(times(all<OneNumber>(v.x), x_), times(all<OneNumber>(v.y), y_)), times(all<OneNumber>(v.z), z_)),
        offset_);
  }

 private:
  OneVector x_, y_, z_;  // the columns
  OneVector offset_;
};

HWY_INLINE bool are_rigid(const Pose& a, const Pose& b) {
  const auto skew = hn::Add(skew_of(rows_of(a)), skew_of(rows_of(b)));
  return hn::AllTrue(Coordinates(), hn::Lt(skew, hn::Set(Coordinates(), most_skew_of_rigid)));
}
#else
class Placing {
 public:
  HWY_INLINE explicit Placing(const Pose& pose) : pose_(pose) {}
  HWY_INLINE OneVector operator()(const Vec3& v) const { return in_one(world_vertex(pose_, v)); }

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
HWY_INLINE OneVector placed_in_one(const Pose& pose, const Vec3& local) {
  return local == Vec3{} ? in_one(pose.offset) : Placing(pose)(local);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
