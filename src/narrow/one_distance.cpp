// One pair at a time, in the one lane of vectors: they select without a branch.
// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/one_distance.cpp"
#define TOCCATA_MOST_LANES 1
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/grown_cores.hpp"
#include "narrow/pair_distances.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Vector lanes_of(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE double first_of(const Number& value) { return hn::GetLane(value); }
HWY_INLINE Vec3 first_of(const Vector& v) { return {first_of(v.x), first_of(v.y), first_of(v.z)}; }

HWY_INLINE Distance answer_of(const Found& found) {
  return {first_of(found.lower), first_of(found.upper), first_of(found.on_a), first_of(found.on_b), Status::exact};
}

HWY_INLINE Distance one(const RoundPoint& a, const RoundPoint& b) {
  return answer_of(found_of(Ball{lanes_of(a.at), all(a.radius)}, Ball{lanes_of(b.at), all(b.radius)}));
}

HWY_INLINE Distance one(const RoundPoint& a, const RoundSegment& b) {
  const NearPoints near = near_of_point_segment(lanes_of(a.at), lanes_of(b.start), lanes_of(b.end));
  return answer_of(grown(near, all(a.radius), all(b.radius)));
}

HWY_INLINE Distance one(const RoundPoint& a, const RoundTriangle& b) {
  const NearPoints near =
      near_of_point_triangle(lanes_of(a.at), lanes_of(b.core[0]), lanes_of(b.core[1]), lanes_of(b.core[2]));
  return answer_of(grown(near, all(a.radius), all(b.radius)));
}

HWY_INLINE Distance one(const RoundPoint& a, const RoundBox& b) {
  const auto corner = [&](std::size_t i) {
    return Vector{all(b.corner[0][i]), all(b.corner[1][i]), all(b.corner[2][i])};
  };
  const Vector p = lanes_of(a.at);
  const BoxSides sides = sides_of(p, corner(0), {corner(1), corner(2), corner(4)});
  std::size_t nearest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) nearest |= std::size_t{hn::AllTrue(Tag(), sides.far[axis])} << axis;
  Corners corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = corner(i ^ nearest);
  return answer_of(grown(near_of_point_corners(p, corners, sides.inverse_squared), all(a.radius), all(b.radius)));
}

HWY_INLINE Distance one(const RoundSegment& a, const RoundSegment& b) {
  return answer_of(found_of(Rod{lanes_of(a.start), lanes_of(a.end), all(a.radius)},
                            Rod{lanes_of(b.start), lanes_of(b.end), all(b.radius)}));
}

}  // namespace

Distance points(const RoundPoint& a, const RoundPoint& b) { return one(a, b); }
Distance point_segment(const RoundPoint& a, const RoundSegment& b) { return one(a, b); }
Distance point_triangle(const RoundPoint& a, const RoundTriangle& b) { return one(a, b); }
Distance point_box(const RoundPoint& a, const RoundBox& b) { return one(a, b); }
Distance segments(const RoundSegment& a, const RoundSegment& b) { return one(a, b); }

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(points);
HWY_EXPORT(point_segment);
HWY_EXPORT(point_triangle);
HWY_EXPORT(point_box);
HWY_EXPORT(segments);

Distance formula_distance(const RoundPoint& a, const RoundPoint& b) { return HWY_DYNAMIC_DISPATCH(points)(a, b); }
Distance formula_distance(const RoundPoint& a, const RoundSegment& b) {
  return HWY_DYNAMIC_DISPATCH(point_segment)(a, b);
}
Distance formula_distance(const RoundPoint& a, const RoundTriangle& b) {
  return HWY_DYNAMIC_DISPATCH(point_triangle)(a, b);
}
Distance formula_distance(const RoundPoint& a, const RoundBox& b) { return HWY_DYNAMIC_DISPATCH(point_box)(a, b); }
Distance formula_distance(const RoundSegment& a, const RoundSegment& b) { return HWY_DYNAMIC_DISPATCH(segments)(a, b); }

}  // namespace toccata
#endif
