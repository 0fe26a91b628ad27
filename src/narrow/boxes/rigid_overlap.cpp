// Spheres, capsules, boxes and triangles under rigid poses, without posing them: formulas that answer nearly always.
// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/boxes/rigid_overlap.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstdint>

#include "narrow/boxes/rigid_poses.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "toccata/narrow/primitives.hpp"

// Nothing is said here unless both poses are rigid but for rounding (rigid_poses.hpp). The norm of RᵀR − I is below
// δ = 2^-40.9 then, the roundings of the check included: R = U H with U orthogonal and |H − I| < δ / 2.
//
// A sphere's centre c is the rounded world vertex. Box and triangle stay in their own frame, where the centre is
// l = Rᵀ(c − t). Let v be the magnitudes of what the shape is made of, w = c − t, u = 2^-53. Uᵀw, which is as far from
// H · (the shape) as c from R · (the shape) + t, differs from Rᵀw by δ / 2 · |w|, and l from that by 7u |w|. H · (the
// shape) differs from the shape by δ / 2 · |v|. The world vertices are rounded, which moves them by less than
// 32u (|v| + |t|) (rigid_box.cpp). So the distance in the shape's frame is off by less than 2^-41 (|w| + |v|) +
// 2^-48 |t|. What is not finite makes this bound NaN or infinite, and the answer unknown. Nothing here needs the same
// bits everywhere, so products may be fused.
HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

constexpr double frame_error = 0x1p-40, offset_error = 0x1p-48;  // the first is twice what is needed

#if HWY_TARGET <= HWY_AVX2
constexpr Coordinates four;
using FourCoordinates = hn::Vec<Coordinates>;

HWY_INLINE FourCoordinates load(const Vec3& v) { return in_one(v).xyz; }
HWY_INLINE FourCoordinates next(const FourCoordinates& v) { return next(OneVector{v}).xyz; }

/// Rᵀ v, of which the last number is 0.
HWY_INLINE FourCoordinates turned_back(const PoseRows& r, const Vec3& v) {
  return hn::MulAdd(r.x.xyz, hn::Set(four, v.x),
                    hn::MulAdd(r.y.xyz, hn::Set(four, v.y), hn::Mul(r.z.xyz, hn::Set(four, v.z))));
}

/// How far, squared, a point is beyond the box, given from the offset of its pose.
HWY_INLINE double squared_beyond(const Box& box, const Pose& pose, const Vec3& from_offset) {
  const FourCoordinates local = hn::Sub(turned_back(rows_of(pose), from_offset), load(box.centre()));
  const FourCoordinates beyond = hn::ZeroIfNegative(hn::Sub(hn::Abs(local), load(box.half_extents())));
  return hn::GetLane(hn::SumOfLanes(four, hn::Mul(beyond, beyond)));
}

/// A coordinate each of the three corners of a triangle, seen from the sphere's centre.
struct CornerRows {
  FourCoordinates x, y, z;
};

HWY_INLINE CornerRows transposed(const FourCoordinates& a, const FourCoordinates& b, const FourCoordinates& c) {
  const FourCoordinates even = hn::InterleaveLower(four, a, b), odd = hn::InterleaveUpper(four, a, b);
  return {hn::ConcatLowerLower(four, c, even), hn::ConcatLowerLower(four, hn::InterleaveUpper(four, c, c), odd),
          hn::ConcatUpperUpper(four, c, even)};
}
HWY_INLINE CornerRows next(const CornerRows& v) { return {next(v.x), next(v.y), next(v.z)}; }
HWY_INLINE CornerRows minus(const CornerRows& u, const CornerRows& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
HWY_INLINE FourCoordinates dot(const CornerRows& u, const CornerRows& v) {
  return hn::MulAdd(u.x, v.x, hn::MulAdd(u.y, v.y, hn::Mul(u.z, v.z)));
}
HWY_INLINE CornerRows cross(const CornerRows& u, const CornerRows& v) {
  return {hn::MulSub(u.y, v.z, hn::Mul(u.z, v.y)), hn::MulSub(u.z, v.x, hn::Mul(u.x, v.z)),
          hn::MulSub(u.x, v.y, hn::Mul(u.y, v.x))};
}
HWY_INLINE FourCoordinates first_everywhere(const FourCoordinates& v) { return hn::Set(four, hn::GetLane(v)); }

HWY_INLINE unsigned bits_of_three(const hn::Mask<Coordinates>& mask) { return bits_of(four, mask) & 7U; }

/// The point of each edge that is nearest to the origin, and the normal: whichever of them proves something does, and
/// nothing has to be chosen. Only a foot within the face is not looked at.
HWY_INLINE Nearness nearness_of_corners(const FourCoordinates& a, const FourCoordinates& b, const FourCoordinates& c,
                                        double reach, double error) {
  const double inner = reach - error, outer = reach + error;
  const FourCoordinates near_squared = hn::Set(four, inner > 0 ? less_square * (inner * inner) : 0.0);
  const FourCoordinates far_squared = hn::Set(four, more_square * (outer * outer)), zero = hn::Zero(four);

  const CornerRows v = transposed(a, b, c), w = next(v), edge = minus(w, v);
  const FourCoordinates share = hn::Div(hn::Neg(dot(v, edge)), dot(edge, edge));
  const FourCoordinates within = hn::Min(hn::Max(share, zero), hn::Set(four, 1));  // NaN becomes 0
  const CornerRows foot{hn::MulAdd(within, edge.x, v.x), hn::MulAdd(within, edge.y, v.y),
                        hn::MulAdd(within, edge.z, v.z)};
  const FourCoordinates squared = dot(foot, foot);
  const FourCoordinates gap = hn::Min(hn::Min(dot(v, foot), dot(w, foot)), dot(next(w), foot));
  const auto apart = hn::And(hn::Gt(gap, zero), hn::Gt(hn::Mul(gap, gap), hn::Mul(far_squared, squared)));

  const CornerRows normals = cross(edge, next(edge));
  const CornerRows normal{first_everywhere(normals.x), first_everywhere(normals.y), first_everywhere(normals.z)};
  const FourCoordinates height = dot(v, normal), needed = hn::Mul(far_squared, dot(normal, normal));
  const unsigned high = bits_of_three(hn::Gt(hn::Mul(height, height), needed)),
                 above = bits_of_three(hn::Gt(height, zero));

  if (bits_of_three(apart) != 0 || (high == 7 && (above == 7 || above == 0))) return Nearness::apart;
  return bits_of_three(hn::Lt(squared, near_squared)) != 0 ? Nearness::meet : Nearness::unknown;
}

/// A sphere around `centre` and a triangle, in one frame, when all is off by `error` at most, what `judge` adds
/// included. The formula for feet within the face has many branches.
HWY_INLINE Nearness nearness_of_triangle(const FourCoordinates& centre, const Triangle& b, double reach, double error) {
  const Nearness found = nearness_of_corners(hn::Sub(load(b[0]), centre), hn::Sub(load(b[1]), centre),
                                             hn::Sub(load(b[2]), centre), reach, error);
  if (found != Nearness::unknown) return found;
  alignas(32) double p[4];
  hn::Store(centre, four, p);
  return nearness_of_point_triangle({p[0], p[1], p[2]}, b, reach, error);
}

HWY_INLINE FourCoordinates local_point(const Pose& pose, const Vec3& from_offset) {
  return turned_back(rows_of(pose), from_offset);
}

HWY_INLINE double sizes_of(const FourCoordinates& centre, const Triangle& b) {
  const FourCoordinates corners = hn::Add(hn::Abs(load(b[0])), hn::Add(hn::Abs(load(b[1])), hn::Abs(load(b[2]))));
  return hn::GetLane(hn::SumOfLanes(four, hn::Add(hn::Abs(centre), corners)));
}
#else
HWY_INLINE Vec3 turned_back(const Pose& pose, const Vec3& v) {
  return (v.x * pose.linear[0] + v.y * pose.linear[1]) + v.z * pose.linear[2];
}

HWY_INLINE Vec3 local_point(const Pose& pose, const Vec3& from_offset) { return turned_back(pose, from_offset); }

HWY_INLINE double sizes_of(const Vec3& centre, const Triangle& b) {
  return (sum_of_magnitudes(centre) + sum_of_magnitudes(b[0])) + (sum_of_magnitudes(b[1]) + sum_of_magnitudes(b[2]));
}

HWY_INLINE Nearness nearness_of_triangle(const Vec3& centre, const Triangle& b, double reach, double error) {
  return nearness_of_point_triangle(centre, b, reach, error);
}

HWY_INLINE double squared_beyond(const Box& box, const Pose& pose, const Vec3& from_offset) {
  const Vec3 local = turned_back(pose, from_offset) - box.centre();
  Vec3 beyond;
  for (int axis = 0; axis < 3; ++axis)
    beyond[axis] = clamped(std::fabs(local[axis]) - box.half_extents()[axis], 0, HUGE_VAL);
  return dot(beyond, beyond);
}
#endif

HWY_INLINE double size_of(const Box& box) {
  return sum_of_magnitudes(box.half_extents()) + sum_of_magnitudes(box.centre());
}

}  // namespace

Nearness sphere_sphere_nearness(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return Nearness::unknown;
  return nearness_of_points(placed(pose_a, a.centre()), placed(pose_b, b.centre()), a.radius() + b.radius());
}

/// Compared with squares of radii that are larger or smaller by the error: the few roundings of these and of the sum
/// are less than what `frame_error` has to spare.
Nearness sphere_box_nearness(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return Nearness::unknown;
  const Vec3 from_offset = placed(pose_a, a.centre()) - pose_b.offset;
  const double squared = squared_beyond(b, pose_b, from_offset);
  const double sizes = (sum_of_magnitudes(from_offset) + size_of(b)) + a.radius();
  const double error = frame_error * sizes + (offset_error * sum_of_magnitudes(pose_b.offset) + nearness_floor);
  const double inner = a.radius() - error, outer = a.radius() + error;
  // Without a branch between the two: which of them it is, no processor foresees.
  const bool meets = (inner > 0) & (squared < inner * inner), apart = squared > outer * outer;
  if (!(meets | apart)) return Nearness::unknown;
  return meets ? Nearness::meet : Nearness::apart;
}

Nearness sphere_triangle_nearness(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return Nearness::unknown;
  const auto local = local_point(pose_b, placed(pose_a, a.centre()) - pose_b.offset);
  // What the formulas add, 2^-46 of the corners seen from the centre, is less than what `frame_error` has to spare.
  const double error = frame_error * (sizes_of(local, b) + a.radius()) +
                       (offset_error * sum_of_magnitudes(pose_b.offset) + nearness_floor);
  return nearness_of_triangle(local, b, a.radius(), error);
}

Nearness sphere_capsule_nearness(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return Nearness::unknown;
  return nearness_of_point_segment(placed(pose_a, a.centre()), world_vertex(pose_b, b.start()),
                                   world_vertex(pose_b, b.end()), a.radius() + b.radius());
}

Nearness capsule_capsule_nearness(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return Nearness::unknown;
  return nearness_of_segments(world_vertex(pose_a, a.start()), world_vertex(pose_a, a.end()),
                              world_vertex(pose_b, b.start()), world_vertex(pose_b, b.end()), a.radius() + b.radius());
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(sphere_sphere_nearness);
HWY_EXPORT(sphere_box_nearness);
HWY_EXPORT(sphere_triangle_nearness);
HWY_EXPORT(sphere_capsule_nearness);
HWY_EXPORT(capsule_capsule_nearness);

bool overlap(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  const Nearness found = HWY_DYNAMIC_DISPATCH(sphere_sphere_nearness)(a, pose_a, b, pose_b);
  if (found != Nearness::unknown) return found == Nearness::meet;
  return overlap(PosedSphere(a, pose_a), PosedSphere(b, pose_b));
}

bool overlap(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Nearness found = HWY_DYNAMIC_DISPATCH(sphere_box_nearness)(a, pose_a, b, pose_b);
  if (found != Nearness::unknown) return found == Nearness::meet;
  return overlap(PosedSphere(a, pose_a), PosedBox(b, pose_b));
}

bool overlap(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b) {
  const Nearness found = HWY_DYNAMIC_DISPATCH(sphere_triangle_nearness)(a, pose_a, b, pose_b);
  if (found != Nearness::unknown) return found == Nearness::meet;
  return overlap(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
}

bool overlap(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  const Nearness found = HWY_DYNAMIC_DISPATCH(sphere_capsule_nearness)(a, pose_a, b, pose_b);
  if (found != Nearness::unknown) return found == Nearness::meet;
  return overlap(PosedSphere(a, pose_a), PosedCapsule(b, pose_b));
}

bool overlap(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  const Nearness found = HWY_DYNAMIC_DISPATCH(capsule_capsule_nearness)(a, pose_a, b, pose_b);
  if (found != Nearness::unknown) return found == Nearness::meet;
  return overlap(PosedCapsule(a, pose_a), PosedCapsule(b, pose_b));
}

}  // namespace toccata
#endif
