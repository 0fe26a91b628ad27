// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/primitives/pair_distances.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/primitives/column_lanes.hpp"
#include "narrow/primitives/offset_cores.hpp"
#include "narrow/primitives/pair_distances.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

struct SphereSphereDistance {
  HWY_INLINE Found<Vector> operator()(const PairColumns& pairs, std::size_t i) const {
    return found_of(OffsetPoint<Vector>{load_vector(pairs.a, 0, i), load(pairs.a, 3, i)},
                    OffsetPoint<Vector>{load_vector(pairs.b, 0, i), load(pairs.b, 3, i)});
  }
};

struct SphereTriangleDistance {
  HWY_INLINE Found<Vector> operator()(const PairColumns& pairs, std::size_t i) const {
    const NearPoints<Vector> near = near_of_point_triangle(load_vector(pairs.a, 0, i), load_vector(pairs.b, 0, i),
                                                           load_vector(pairs.b, 3, i), load_vector(pairs.b, 6, i));
    return offset_outward(near, load(pairs.a, 3, i), hn::Zero(tag));
  }
};

/// Exchanges corners that are neighbours along an edge, where the mask is set.
HWY_INLINE void turn(BoxVertices<Vector>& corner, std::size_t axis, const Mask& mask) {
  for (std::size_t i = 0; i < 8; ++i) {
    if ((i >> axis & 1) != 0) continue;
    const std::size_t j = i | std::size_t{1} << axis;
    const Vector kept = corner[i];
    corner[i] = select(mask, corner[j], kept);
    corner[j] = select(mask, kept, corner[j]);
  }
}

struct SphereBoxDistance {
  HWY_INLINE Found<Vector> operator()(const PairColumns& pairs, std::size_t i) const {
    const Vector p = load_vector(pairs.a, 0, i);
    BoxVertices<Vector> corner;
    for (std::size_t k = 0; k < 8; ++k)
      corner[k] = {load(pairs.b, k, i), load(pairs.b, 8 + k, i), load(pairs.b, 16 + k, i)};
    const BoxSides<Vector> sides = sides_of(p, corner[0], {corner[1], corner[2], corner[4]});
    for (std::size_t axis = 0; axis < 3; ++axis) turn(corner, axis, sides.far[axis]);
    return offset_outward(near_of_point_corners(p, corner, sides), load(pairs.a, 3, i), hn::Zero(tag));
  }
};

struct CapsuleCapsuleDistance {
  HWY_INLINE Found<Vector> operator()(const PairColumns& pairs, std::size_t i) const {
    const OffsetSegment<Vector> a{load_vector(pairs.a, 0, i), load_vector(pairs.a, 3, i), load(pairs.a, 6, i)};
    const OffsetSegment<Vector> b{load_vector(pairs.b, 0, i), load_vector(pairs.b, 3, i), load(pairs.b, 6, i)};
    return found_of(a, b);
  }
};

HWY_INLINE void write(const Found<Vector>& found, Distance* distances) {
  alignas(64) double rows[8][most_lanes];
  const Number* const columns[8] = {&found.lower,  &found.upper,  &found.on_a.x, &found.on_a.y,
                                    &found.on_a.z, &found.on_b.x, &found.on_b.y, &found.on_b.z};
  for (std::size_t k = 0; k < 8; ++k) hn::StoreU(*columns[k], tag, rows[k]);
  for (std::size_t i = 0; i < hn::Lanes(tag); ++i)
    distances[i] = {rows[0][i],
                    rows[1][i],
                    {rows[2][i], rows[3][i], rows[4][i]},
                    {rows[5][i], rows[6][i], rows[7][i]},
                    Status::exact};
}

template <class Kernel>
HWY_INLINE std::size_t for_all(const PairColumns& pairs, Distance* distances, const Kernel& kernel) {
  std::size_t i = 0;
  for (; i + hn::Lanes(tag) <= pairs.count; i += hn::Lanes(tag)) write(kernel(pairs, i), distances + i);
  return i;
}

}  // namespace

std::size_t sphere_sphere_distances(const PairColumns& pairs, Distance* distances) {
  return for_all(pairs, distances, SphereSphereDistance{});
}
std::size_t sphere_triangle_distances(const PairColumns& pairs, Distance* distances) {
  return for_all(pairs, distances, SphereTriangleDistance{});
}
std::size_t sphere_box_distances(const PairColumns& pairs, Distance* distances) {
  return for_all(pairs, distances, SphereBoxDistance{});
}
std::size_t capsule_capsule_distances(const PairColumns& pairs, Distance* distances) {
  return for_all(pairs, distances, CapsuleCapsuleDistance{});
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(sphere_sphere_distances);
HWY_EXPORT(sphere_triangle_distances);
HWY_EXPORT(sphere_box_distances);
HWY_EXPORT(capsule_capsule_distances);

DistanceKernels distance_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(sphere_sphere_distances), &HWY_DYNAMIC_DISPATCH(sphere_triangle_distances),
          &HWY_DYNAMIC_DISPATCH(sphere_box_distances), &HWY_DYNAMIC_DISPATCH(capsule_capsule_distances)};
}

}  // namespace toccata
#endif
