// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/triangles/triangle_gaps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "math/lanes.hpp"
#include "narrow/triangles/triangle_gap_rounding.hpp"
#include "narrow/triangles/triangle_gaps.hpp"

#ifndef TOCCATA_NARROW_TRIANGLE_GAPS_ONCE
#define TOCCATA_NARROW_TRIANGLE_GAPS_ONCE
namespace toccata {

// What the levels share. It is defined here, before any level's instructions are switched on.
inline const double* lanes_at(const TrianglePairBlock::Corners& corners, std::size_t corner, std::size_t axis) {
  return corners[corner][axis].data();
}

}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

// The nearest points of two triangles are a point of an edge of each, or a vertex of one and a point of the other's
// face (C. Ericson, "Real-Time Collision Detection", 2005, section 5.1). Every difference looked at is one of points of
// the triangles, whatever its shares are, so the least is never too small but for rounding; how much too large it may
// be, the heights of the vertices along it tell. Bounds: docs/methods/mesh-distance.md.

HWY_INLINE Vector corner(const TrianglePairBlock::Corners& corners, std::size_t i, std::size_t lane) {
  return {hn::Load(tag, lanes_at(corners, i, 0) + lane), hn::Load(tag, lanes_at(corners, i, 1) + lane),
          hn::Load(tag, lanes_at(corners, i, 2) + lane)};
}

/// A triangle seen from somewhere, with its edges.
struct SeenTriangle {
  std::array<Vector, 3> vertex;
  std::array<Vector, 3> edge;  ///< from vertex i to the next
  std::array<Number, 3> inverse_squared;
};

HWY_INLINE SeenTriangle seen_from(const TrianglePairBlock::Corners& corners, std::size_t lane, const Vector& origin) {
  SeenTriangle side;
  for (std::size_t i = 0; i < 3; ++i) side.vertex[i] = minus(corner(corners, i, lane), origin);
  for (std::size_t i = 0; i < 3; ++i) {
    side.edge[i] = minus(side.vertex[(i + 1) % 3], side.vertex[i]);
    side.inverse_squared[i] = hn::Div(all(1), dot(side.edge[i], side.edge[i]));
  }
  return side;
}

/// The least difference so far, from a point of b to one of a.
struct LeastOfFeatures {
  Vector difference;
  Number squared, features, share, other_share;

  HWY_INLINE void see(const Vector& other, double its_features, const Number& its_share,
                      const Number& its_other_share) {
    const Number other_squared = dot(other, other);
    const Mask less = hn::Lt(other_squared, squared);
    difference = select(less, other, difference);
    squared = hn::IfThenElse(less, other_squared, squared);
    features = hn::IfThenElse(less, all(its_features), features);
    share = hn::IfThenElse(less, its_share, share);
    other_share = hn::IfThenElse(less, its_other_share, other_share);
  }
};

/// x + s·u.
HWY_INLINE Vector moved(const Vector& x, const Number& s, const Vector& u) { return plus(x, times(s, u)); }

HWY_INLINE void see_edges(const SeenTriangle& a, const SeenTriangle& b, std::size_t i, std::size_t j,
                          LeastOfFeatures& least) {
  const Vector between = minus(a.vertex[i], b.vertex[j]);
  const Vector &u = a.edge[i], &v = b.edge[j];
  const Number uv = dot(u, v), ur = dot(u, between), vr = dot(v, between);
  // With w = uv / vv the nearest points of the lines are at s = (w·vr − ur) / (uu − w·uv).
  const Number w = hn::Mul(uv, b.inverse_squared[j]);
  const Number across = hn::Sub(dot(u, u), hn::Mul(w, uv));
  const Number s = clamped_share(hn::Div(hn::Sub(hn::Mul(w, vr), ur), across));
  const Number t = clamped_share(hn::Mul(hn::Add(vr, hn::Mul(s, uv)), b.inverse_squared[j]));
  const Number again = clamped_share(hn::Mul(hn::Sub(hn::Mul(t, uv), ur), a.inverse_squared[i]));
  const Vector on_b = times(t, v);
  least.see(minus(moved(between, again, u), on_b), static_cast<double>(3 * i + j), again, t);
}

/// What a face is asked with.
struct AskedFace {
  Vector first, second;  ///< edges from vertex 0
  Number first_squared, second_squared, both, inverse;
};

HWY_INLINE AskedFace face_of(const SeenTriangle& side) {
  AskedFace face{side.edge[0], negative(side.edge[2]), all(0), all(0), all(0), all(0)};
  face.first_squared = dot(face.first, face.first);
  face.second_squared = dot(face.second, face.second);
  face.both = dot(face.first, face.second);
  face.inverse =
      hn::Div(all(1), hn::Sub(hn::Mul(face.first_squared, face.second_squared), hn::Mul(face.both, face.both)));
  return face;
}

/// From a point of a face, the foot of another point where that is one, to this; `from` is the point less vertex 0.
struct AboveFace {
  Vector difference;
  Number share, other_share;
};

HWY_INLINE AboveFace above_face(const AskedFace& face, const Vector& from) {
  const Number first = dot(from, face.first), second = dot(from, face.second);
  const Number s =
      clamped_share(hn::Mul(hn::Sub(hn::Mul(first, face.second_squared), hn::Mul(second, face.both)), face.inverse));
  const Number t =
      clamped_between(hn::Mul(hn::Sub(hn::Mul(second, face.first_squared), hn::Mul(first, face.both)), face.inverse),
                      hn::Zero(tag), hn::Sub(all(1), s));
  return {minus(minus(from, times(s, face.first)), times(t, face.second)), s, t};
}

HWY_INLINE LeastOfFeatures least_of_features(const SeenTriangle& a, const SeenTriangle& b) {
  const Vector first = minus(a.vertex[0], b.vertex[0]);
  LeastOfFeatures least{first, dot(first, first), all(0), all(0), all(0)};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) see_edges(a, b, i, j, least);
  const AskedFace face_a = face_of(a), face_b = face_of(b);
  for (std::size_t i = 0; i < 3; ++i) {
    const AboveFace of_a = above_face(face_b, minus(a.vertex[i], b.vertex[0]));
    const AboveFace of_b = above_face(face_a, minus(b.vertex[i], a.vertex[0]));
    least.see(of_a.difference, static_cast<double>(9 + i), of_a.share, of_a.other_share);
    least.see(negative(of_b.difference), static_cast<double>(12 + i), of_b.share, of_b.other_share);
  }
  return least;
}

/// The greatest coordinate; what is not a number stays one.
HWY_INLINE Number size_of(const SeenTriangle& a, const SeenTriangle& b) {
  Number size = greatest_of(b.vertex[0]), all_of_them = hn::Zero(tag);
  for (std::size_t i = 0; i < 3; ++i) {
    size = greater(size, greater(greatest_of(a.vertex[i]), greatest_of(b.vertex[i])));
    all_of_them = hn::Add(all_of_them, hn::Add(greatest_of(a.vertex[i]), greatest_of(b.vertex[i])));
  }
  return hn::Add(size, hn::Mul(all_of_them, hn::Zero(tag)));
}

HWY_INLINE void bound_lanes(const TrianglePairBlock& block, std::size_t lane, TriangleGaps& gaps) {
  const Vector origin = corner(block.a, 0, lane);
  const SeenTriangle a = seen_from(block.a, lane, origin), b = seen_from(block.b, lane, origin);
  const LeastOfFeatures least = least_of_features(a, b);
  const Vector& d = least.difference;
  std::array<Number, 3> above, below;
  for (std::size_t i = 0; i < 3; ++i) {
    above[i] = dot(d, a.vertex[i]);
    below[i] = dot(d, b.vertex[i]);
  }
  const Number length = hn::Sqrt(least.squared), size = size_of(a, b);
  const Number height =
      hn::Sub(lesser(lesser(above[0], above[1]), above[2]), greater(greater(below[0], below[1]), below[2]));
  const Number off = hn::Mul(all(triangle_gap_rounding), size), zero = hn::Zero(tag);
  const Mask plain = hn::And(hn::Gt(size, all(0x1p-200)), hn::Lt(size, all(0x1p200)));
  const Mask some = hn::And(plain, hn::Gt(length, off));
  hn::Store(hn::IfThenElseZero(some, greater(hn::Sub(hn::Div(height, length), off), zero)), tag,
            gaps.lower.data() + lane);
  hn::Store(least.features, tag, gaps.features.data() + lane);
  hn::Store(least.share, tag, gaps.share.data() + lane);
  hn::Store(least.other_share, tag, gaps.other_share.data() + lane);
  hn::Store(hn::IfThenElse(plain, hn::Add(length, off), hn::Inf(tag)), tag, gaps.upper.data() + lane);
}

}  // namespace

void bound_gaps_at_this_level(const TrianglePairBlock& block, TriangleGaps& gaps) {
  for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; lane += hn::Lanes(tag)) bound_lanes(block, lane, gaps);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(bound_gaps_at_this_level);

void bound_gaps(const TrianglePairBlock& block, TriangleGaps& gaps) {
  HWY_DYNAMIC_DISPATCH(bound_gaps_at_this_level)(block, gaps);
}

}  // namespace toccata
#endif
