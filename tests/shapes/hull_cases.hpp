#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/convex_hull.hpp"

// Points to make hulls of, and the certificate that a hull is that of its points.
namespace toccata::test {

inline const std::vector<std::string>& hull_families() {
  static const std::vector<std::string> families{"ball",    "sphere",    "grid",  "coarse-grid", "near-coplanar",
                                                 "tiny",    "denormal",  "huge",  "needle",      "flat",
                                                 "distant", "collinear", "equal", "mixed"};
  return families;
}

inline Vec3 in_cube(Random& random) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(-1, 1);
  return p;
}

inline Vec3 in_ball(Random& random) {
  for (;;)
    if (const Vec3 p = in_cube(random); dot(p, p) < 1 && dot(p, p) > 0) return p;
}

inline Vec3 on_grid(Random& random, std::uint64_t width) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(random.below(width));
  return p;
}

inline Vec3 next_to(const Vec3& p, Random& random) {
  Vec3 q = p;
  for (int axis = 0; axis < 3; ++axis)
    if (const std::uint64_t way = random.below(3); way != 2) q[axis] = std::nextafter(p[axis], way == 0 ? -9e9 : 9e9);
  return q;
}

inline std::vector<Vec3> hull_points(const std::string& family, Random& random, std::size_t count) {
  std::vector<Vec3> points;
  const auto fill = [&](const auto& make) {
    while (points.size() < count) points.push_back(make());
  };
  if (family == "ball") fill([&] { return in_ball(random); });
  if (family == "sphere")
    fill([&] {
      const Vec3 p = in_ball(random);
      return 1 / std::sqrt(dot(p, p)) * p;
    });
  if (family == "grid") fill([&] { return on_grid(random, 12); });
  if (family == "coarse-grid") fill([&] { return on_grid(random, 3); });
  if (family == "near-coplanar")  // a cloud whose sides are flat but for a last place
    fill([&] {
      Vec3 p = in_cube(random);
      p[static_cast<int>(random.below(3))] = random.below(2) == 0 ? -1 : 1;
      return random.below(2) == 0 ? p : next_to(p, random);
    });
  if (family == "tiny") fill([&] { return 1e-300 * in_ball(random); });
  if (family == "denormal") fill([&] { return 0x1p-1074 * on_grid(random, 6); });
  if (family == "huge") fill([&] { return 1.7e308 * in_cube(random); });
  if (family == "needle")
    fill([&] {
      const Vec3 p = in_ball(random);
      return Vec3{p.x, 1e-9 * p.y + 1e-3 * p.x, 1e-12 * p.z};
    });
  if (family == "flat") {
    const double first = static_cast<double>(random.below(5)), second = static_cast<double>(random.below(5));
    fill([&] {
      const Vec3 p = on_grid(random, 9);
      return Vec3{p.x, p.y, first * p.x - second * p.y};
    });
  }
  if (family == "distant") {
    const double far = random.below(2) == 0 ? 1e6 : 1e15;
    fill([&] { return Vec3{far, -far, 3 * far} + in_ball(random); });
  }
  if (family == "collinear")
    fill([&] {
      const double along = static_cast<double>(random.below(20));
      return Vec3{1 + along, 2 - 3 * along, along};
    });
  if (family == "equal") {
    const Vec3 p = in_ball(random);
    fill([&] { return p; });
  }
  if (family == "mixed")
    fill([&] {
      Vec3 p = in_cube(random);
      for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(p[axis], static_cast<int>(random.below(2000)) - 1000);
      return p;
    });
  return points;
}

inline std::string to_text(const std::vector<Vec3>& points) {
  std::string text = "{";
  char buffer[128];
  for (const Vec3& p : points) {
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a}, ", p.x, p.y, p.z);
    text += buffer;
  }
  return text + "}";
}

/// Half-edges, twins, faces and the canonical order fit together. Empty, or what is wrong.
inline std::string topology_failure(const ConvexHull& hull) {
  const HullTopology t = hull.topology();
  const Index half_edges = static_cast<Index>(t.origin.size()), vertices = hull.vertex_count(), faces = t.face_count();
  if (t.twin.size() != half_edges || t.face.size() != half_edges || t.leaving.size() != vertices) return "sizes";
  if (hull.dimension() == 0) return vertices == 1 && half_edges == 0 && faces == 0 ? "" : "a point with faces";
  if (hull.dimension() == 1 && (vertices != 2 || half_edges != 2 || faces != 1)) return "a segment's counts";
  if (hull.dimension() == 2 && (half_edges != 2 * vertices || faces != 2)) return "a polygon's counts";
  if (hull.dimension() == 3 && vertices + faces != half_edges / 2 + 2) return "Euler's formula";
  std::set<std::pair<Index, Index>> directed;
  std::pair<Index, Index> last{0, 0};
  for (Index f = 0; f < faces; ++f) {
    const Index begin = t.face_start[f], end = t.face_start[f + 1];
    if (end - begin < (hull.dimension() == 1 ? 2U : 3U)) return "a face of few corners";
    for (Index h = begin; h < end; ++h) {
      if (t.face[h] != f) return "the face of a half-edge";
      if (t.origin[h] < t.origin[begin]) return "a face does not begin at its least vertex";
      if (t.twin[t.twin[h]] != h || t.origin[t.twin[h]] != t.origin[t.next(h)]) return "twins";
      if (hull.dimension() > 1 && t.face[t.twin[h]] == f) return "an edge with one face on both sides";
      if (!directed.emplace(t.origin[h], t.target(h)).second) return "an edge that is there twice";
    }
    const std::pair<Index, Index> key{t.origin[begin], t.origin[begin + 1]};
    if (f > 0 && key <= last) return "the order of faces";
    last = key;
  }
  for (Index v = 0; v < vertices; ++v)
    if (t.leaving[v] >= half_edges || t.origin[t.leaving[v]] != v) return "leaving";
  return "";
}

/// The vertices are the points they claim to be: ascending, of equal points the first, and all there is to be said.
inline std::string vertices_failure(const ConvexHull& hull, const std::vector<Vec3>& points) {
  for (Index v = 0; v < hull.vertex_count(); ++v) {
    if (v > 0 && hull.source_of(v) <= hull.source_of(v - 1)) return "the order of vertices";
    if (!(points[hull.source_of(v)] == hull.vertex(v))) return "a vertex that is not its point";
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::span<const double> along = hull.padded_coordinates(axis);
    if (along.size() != (hull.vertex_count() + 7) / 8 * 8) return "the size of the padding";
    for (Index v = 0; v < along.size(); ++v)
      if (along[v] != hull.vertex(std::min(v, hull.vertex_count() - 1))[axis]) return "padding";
  }
  return "";
}

inline bool on_one_line(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)) != Sign::zero) return false;
  return true;
}

/// c lies to the left of the line from a to b, seen along the axis against which a, b, `inside` turn left.
inline bool is_left(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& inside) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto turn = [&](const Vec3& p) {
      return orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(p, axis));
    };
    if (turn(inside) != Sign::zero) return turn(c) == turn(inside);
  }
  return false;
}

/// Every face is planar and strictly convex, its edges' other faces fall off behind it, and no point lies in front.
/// With more than `most_points` points only some are asked.
inline std::string solid_failure(const ConvexHull& hull, const std::vector<Vec3>& points, std::size_t most_points) {
  const HullTopology t = hull.topology();
  const std::size_t step = 1 + points.size() / most_points;
  for (Index f = 0; f < t.face_count(); ++f) {
    const Index begin = t.face_start[f], end = t.face_start[f + 1];
    const auto corner = [&](Index h) { return hull.vertex(t.origin[h]); };
    const Vec3 a = corner(begin), b = corner(begin + 1), c = corner(begin + 2);
    for (Index h = begin; h < end; ++h) {
      if (orient3d(a, b, c, corner(h)) != Sign::zero) return "a face that is not planar";
      const Index next = t.next(h);
      const Vec3 behind = corner(t.next(t.next(t.twin[h])));
      if (orient3d(a, b, c, behind) != Sign::negative) return "an edge that is not convex";
      // Seen from `behind`, which lies below the face, the face turns the other way round.
      for (Index other = begin; other < end && end - begin < 64; ++other)
        if (other != h && other != next && orient3d(corner(h), corner(next), corner(other), behind) != Sign::negative)
          return "a face that is not strictly convex";
    }
    for (std::size_t p = f % step; p < points.size(); p += step)
      if (orient3d(a, b, c, points[p]) == Sign::positive) return "a point in front of a face";
  }
  return "";
}

inline std::string flat_failure(const ConvexHull& hull, const std::vector<Vec3>& points) {
  const HullTopology t = hull.topology();
  const Index n = hull.vertex_count();
  const auto corner = [&](Index i) { return hull.vertex(t.origin[i % n]); };
  for (const Vec3& p : points)
    for (Index i = 0; i < n; ++i) {
      if (orient3d(corner(0), corner(1), corner(2), p) != Sign::zero) return "a point off the plane";
      const Vec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
      if (on_one_line(a, b, c)) return "a corner on a line";
      if (!on_one_line(a, b, p) && !is_left(a, b, p, c)) return "a point outside the polygon";
    }
  return "";
}

inline std::string segment_failure(const ConvexHull& hull, const std::vector<Vec3>& points) {
  Vec3 low = hull.vertex(0), high = hull.vertex(1);
  if (lexicographically_less(high, low)) std::swap(low, high);
  for (const Vec3& p : points) {
    if (!on_one_line(low, high, p)) return "a point off the line";
    if (lexicographically_less(p, low) || lexicographically_less(high, p)) return "a point beyond the segment";
  }
  return "";
}

/// Empty, or why this is not the hull of the points.
inline std::string hull_failure(const ConvexHull& hull, const std::vector<Vec3>& points,
                                std::size_t most_points = 1'000'000) {
  if (std::string wrong = topology_failure(hull); !wrong.empty()) return wrong;
  if (std::string wrong = vertices_failure(hull, points); !wrong.empty()) return wrong;
  if (hull.dimension() == 3) return solid_failure(hull, points, most_points);
  if (hull.dimension() == 2) return flat_failure(hull, points);
  if (hull.dimension() == 1) return segment_failure(hull, points);
  for (const Vec3& p : points)
    if (!(p == hull.vertex(0))) return "another point";
  return hull.source_of(0) == 0 ? "" : "not the first point";
}

}  // namespace toccata::test
