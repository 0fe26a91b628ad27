#pragma once

#include <array>
#include <concepts>
#include <span>

#include "bounds/normals.hpp"
#include "bounds/upper_sum.hpp"
#include "math/constants.hpp"
#include "narrow/convex/gjk_simplex.hpp"
#include "toccata/bounds/all_volumes.hpp"

// Any two convex sets, by the least they need to tell. Whatever directions are tried, each gives a valid bound: so the
// search for a good one may be as rough as it likes.
namespace toccata {

template <class V>
concept HasNormals = requires(const V& v) {
  { face_normals(v) } -> std::same_as<Directions>;
};
/// A box that may be turned any way: its normals are its edges too.
template <class V>
concept IsOriented = HasNormals<V> && requires(const V& v) {
  {v.axes};
};

/// The least of (b − a) · direction over the points of both is at least this; −∞ when that is unknown.
template <class A, class B>
double separation(const A& a, const B& b, const Vec3& direction) {
  const Vec3 from = middle(a);
  // The sign of a sum of two doubles is not rounded.
  return -(support_bound(a, direction, from) + support_bound(b, -direction, from));
}

/// A lower bound of the distance by what one direction shows of it. Its components are at most 1 in magnitude.
template <class A, class B>
double gap_along(const A& a, const B& b, const Vec3& direction) {
  const double parted = separation(a, b, direction);
  return parted > 0 ? rounded_down(parted / length_bound(direction)) : 0;
}

/// The way from the box of a to that of b, along every axis: where the boxes are apart, the direction of their nearest
/// points.
inline Vec3 between(const Aabb& a, const Aabb& b) {
  Vec3 way;
  for (int axis = 0; axis < 3; ++axis)
    way[axis] = std::max(b.lower[axis] - a.upper[axis], 0.0) - std::max(a.lower[axis] - b.upper[axis], 0.0);
  return way;
}

/// Whether the first direction is that of the nearest points.
template <class V>
inline constexpr bool is_aligned = std::same_as<V, Aabb> || std::same_as<V, Cube> || std::same_as<V, PointVolume>;
template <class V>
inline constexpr bool is_round = std::same_as<V, Ball> || std::same_as<V, Pss> || std::same_as<V, PointVolume>;
template <class A, class B>
inline constexpr bool found_at_once = (is_aligned<A> && is_aligned<B>) || (is_round<A> && is_round<B>);

/// Whether the normals, and edges, are all directions that such volumes can be parted by, or that are meant to be
/// tried.
template <class A, class B>
inline constexpr bool parted_by_normals = (HasNormals<A> && HasNormals<B> && std::same_as<A, B>) ||
                                          (HasNormals<A> && std::same_as<B, PointVolume>) ||
                                          (std::same_as<A, PointVolume> && HasNormals<B>);

/// The one that is cheap to find; zero where there is none.
template <class A, class B>
Vec3 first_direction(const A& a, const B& b) {
  if constexpr (is_aligned<A> && is_aligned<B>)
    return scaled_direction(between(box_around(a), box_around(b)));
  else
    return scaled_direction(middle(b) - middle(a));
}

/// Calls `use(direction)` with the normals of both volumes, and with what is at right angles to an edge of each, until
/// it returns true; tells whether it did.
template <class A, class B, class Use>
bool any_normal(const A& a, const B& b, const Use& use) {
  const auto use_normals = [&](const auto& volume) {
    if constexpr (HasNormals<std::remove_cvref_t<decltype(volume)>>) {
      const Directions normals = face_normals(volume);
      for (const Vec3& normal : normals.span())
        if (use(normal) || use(-normal)) return true;
    }
    return false;
  };
  if (use_normals(a) || use_normals(b)) return true;
  if constexpr (IsOriented<A> && IsOriented<B>) {
    for (const Vec3& edge_a : a.axes.row)
      for (const Vec3& edge_b : b.axes.row) {
        // Nearly parallel edges give a direction that is mostly rounding: a try like any other.
        const Vec3 direction = scaled_direction(cross(edge_a, edge_b));
        if (!(direction == Vec3{}) && (use(direction) || use(-direction))) return true;
      }
  }
  return false;
}

/// A volume that is a core grown by a ball is searched by its core: the directions are the same, and a core with
/// corners needs fewer steps.
template <class V>
Vec3 search_point(const V& volume, const Vec3& direction) {
  if constexpr (requires { farthest_core_point(volume, direction); })
    return farthest_core_point(volume, direction);
  else
    return farthest_point(volume, direction);
}

/// Where the search of E. G. Gilbert, D. W. Johnson, S. S. Keerthi ("A fast procedure for computing the distance
/// between complex objects in three-dimensional space", 1988) leads, in doubles: the directions from a to b of ever
/// nearer points, handed to `use` until it returns true; a is moved before. quadric volumes need more steps than these
/// to reach the last place.
template <class A, class B, class Use>
void search_directions(const A& a, const B& b, const Vec3& a_moved, Vec3 direction, const Use& use) {
  constexpr int steps = 24;
  const Vec3 from = middle(a);
  double factor = 0;
  NearestFace face;
  GjkSimplex simplex;
  for (int step = 0; step < steps; ++step) {
    Vec3 point = (search_point(b, -direction) - from) - (search_point(a, direction) - from) - a_moved;
    if (factor == 0) factor = 1 / std::clamp(largest_magnitude(point), 0x1p-1000, 0x1p1000);
    point = factor * point;
    if (!is_finite(point)) return;
    // No point is nearer by more than this along the direction of the nearest.
    if (step > 0 && face.squared - dot(face.nearest, point) <= 1e-12 * face.squared) return;
    simplex.append(0, static_cast<Index>(step), point);
    face = nearest_face(simplex);
    direction = scaled_direction(face.nearest);
    if (face.kept == 15 || direction == Vec3{} || use(direction)) return;
    simplex.keep(face.kept);
  }
}

template <class A, class B>
requires VolumePair<A, B>
bool overlap(const A& a, const B& b) {
  if (is_empty(a) || is_empty(b)) return false;
  bool apart = false;
  const auto parts = [&](const Vec3& direction) { return apart = separation(a, b, direction) > 0; };
  const Vec3 first = first_direction(a, b);
  if (!(first == Vec3{}) && parts(first)) return false;
  if constexpr (found_at_once<A, B>) return true;
  if (any_normal(a, b, parts)) return false;
  if constexpr (!parted_by_normals<A, B>) search_directions(a, b, {}, {1, 0, 0}, parts);
  return !apart;
}

template <class A, class B>
requires VolumePair<A, B>
double gap(const A& a, const B& b) {
  if (is_empty(a) || is_empty(b)) return infinity;
  double best = 0;
  const auto look = [&](const Vec3& direction) {
    best = std::max(best, gap_along(a, b, direction));
    return false;
  };
  const Vec3 first = first_direction(a, b);
  if (!(first == Vec3{})) look(first);
  if constexpr (!found_at_once<A, B>) {
    search_directions(a, b, {}, first == Vec3{} ? Vec3{1, 0, 0} : first, look);
    // Where they are nearly in touch, the search may have met its rounding.
    if (best == 0) any_normal(a, b, look);
  }
  return best;
}

/// The times at which a, moved, may meet b: those that no direction has ruled out.
struct TimeSpan {
  double first = 0;
  double last = infinity;

  [[nodiscard]] bool is_empty() const { return !(first <= last); }

  /// Before the motion (b − a) · direction ≥ parted for all points, and it shrinks by at most rate · t. So the two do
  /// not meet at t unless rate · t ≥ parted.
  void cut(double parted, double rate) {
    if (parted > 0 && !(rate > 0))
      last = -1;
    else if (parted > 0)
      first = std::max(first, rounded_down(parted / rate));
    else if (rate < 0)
      last = std::min(last, rounded_up(parted / rate));
  }
};

/// Cuts by planes that touch the volumes where they are nearest, first at the start and then where the last cuts have
/// led: for quadric volumes that is Newton's method, and stays before the meeting as they are convex.
template <class A, class B>
requires VolumePair<A, B>
double sweep_entry(const A& a, const Vec3& motion, const B& b) {
  constexpr double never = infinity;
  constexpr int rounds = 8;
  if (is_empty(a) || is_empty(b)) return never;
  TimeSpan times;
  const auto cut = [&](const Vec3& direction) {
    UpperSum rate;
    rate.add(direction, motion);
    times.cut(separation(a, b, direction), rate.bound());
    return times.is_empty();
  };
  const Vec3 first = first_direction(a, b);
  if (!(first == Vec3{}) && cut(first)) return never;
  if (any_normal(a, b, cut)) return never;
  for (int round = 0; round < rounds; ++round) {
    const double before = times.first;
    search_directions(a, b, before * motion, {1, 0, 0}, cut);
    if (times.is_empty()) return never;
    if (!(times.first > before)) break;
  }
  return times.first;
}

/// The box around anything.
template <SupportedVolume V>
Aabb box_by_supports(const V& volume) {
  if (is_empty(volume)) return {};
  const Vec3 from = middle(volume);
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 direction;
    direction[axis] = 1;
    UpperSum upper, lower;
    upper.add(1, from[axis]);
    upper.add(1, support_bound(volume, direction, from));
    lower.add(-1, from[axis]);
    lower.add(1, support_bound(volume, -direction, from));
    box.upper[axis] = upper.bound();
    box.lower[axis] = -lower.bound();
  }
  return box;
}

/// Makes the questions about pairs of one type of volume, and of it and a point.
#define TOCCATA_INSTANTIATE_VOLUME(V)                                     \
  template double gap(const V&, const V&);                                \
  template double gap(const V&, const PointVolume&);                      \
  template double gap(const PointVolume&, const V&);                      \
  template bool overlap(const V&, const V&);                              \
  template bool overlap(const V&, const PointVolume&);                    \
  template bool overlap(const PointVolume&, const V&);                    \
  template double sweep_entry(const V&, const Vec3&, const V&);           \
  template double sweep_entry(const V&, const Vec3&, const PointVolume&); \
  template double sweep_entry(const PointVolume&, const Vec3&, const V&); \
  static_assert(BoundingVolume<V>)

}  // namespace toccata
