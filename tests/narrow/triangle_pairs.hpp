#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/shapes/primitives.hpp"

// Pairs of triangles in families that are hard in one way each.
namespace toccata::test {

struct TrianglePair {
  Triangle a;
  Triangle b;
};

inline const std::vector<std::string>& triangle_pair_families() {
  static const std::vector<std::string> families{"random", "grid", "shared", "coplanar",   "needles", "ulp",
                                                 "far",    "tiny", "huge",   "degenerate", "mixed"};
  return families;
}

namespace triangle_pairs {

inline Vec3 random_point(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

inline Vec3 grid_point(Random& random, std::uint64_t size) {
  const auto number = [&] { return static_cast<double>(random.below(size)); };
  const double x = number(), y = number();
  return {x, y, number()};
}

inline Triangle random_triangle(Random& random) {
  const Vec3 p = random_point(random), q = random_point(random);
  return {{p, q, random_point(random)}};
}

inline Triangle grid_triangle(Random& random, std::uint64_t size) {
  const Vec3 p = grid_point(random, size), q = grid_point(random, size);
  return {{p, q, grid_point(random, size)}};
}

template <class Function>
Triangle each_vertex(const Triangle& t, Function change) {
  return {{change(t[0]), change(t[1]), change(t[2])}};
}

inline Vec3 nudged(const Vec3& v, Random& random) {
  const auto nudge = [&](double x) {
    const std::uint64_t way = random.below(4);  // half of the numbers stay
    return way == 0 ? std::nextafter(x, -INFINITY) : way == 1 ? std::nextafter(x, INFINITY) : x;
  };
  return {nudge(v.x), nudge(v.y), nudge(v.z)};
}

/// A rounded point of the triangle: inside, on an edge, or a vertex.
inline Vec3 point_of(const Triangle& t, Random& random) {
  const std::uint64_t where = random.below(4);
  if (where == 0) return t[static_cast<int>(random.below(3))];
  const double s = random.unit(), r = where == 1 ? 0 : random.unit() * (1 - s);
  const int first = static_cast<int>(random.below(3));
  return t[first] + s * (t[(first + 1) % 3] - t[first]) + r * (t[(first + 2) % 3] - t[first]);
}

/// Half of them on a grid, where much is decided by zeros.
inline TrianglePair plain_pair(Random& random) {
  if (random.below(2) == 0) {
    const Triangle a = grid_triangle(random, 4);
    return {a, grid_triangle(random, 4)};
  }
  const Triangle a = random_triangle(random);
  return {a, random_triangle(random)};
}

inline TrianglePair grid_pair(Random& random) {
  const std::uint64_t size = random.below(2) == 0 ? 3 : 8;
  const Triangle a = grid_triangle(random, size);
  return {a, grid_triangle(random, size)};
}

inline TrianglePair shared_pair(Random& random) {
  TrianglePair pair = plain_pair(random);
  const std::uint64_t shared = 1 + random.below(3);
  for (std::uint64_t i = 0; i < shared; ++i) pair.b[static_cast<int>(i)] = pair.a[static_cast<int>(i)];
  if (random.below(4) == 0) pair.b[2] = pair.b[static_cast<int>(random.below(2))];
  return pair;
}

/// Six points of one plane, exactly: combinations of two small whole vectors, or doubles in a plane across an axis.
inline TrianglePair coplanar_pair(Random& random) {
  TrianglePair pair = plain_pair(random);
  if (random.below(3) == 0) {
    const int axis = static_cast<int>(random.below(3));
    const double height = random.between(-1, 1);
    for (int i = 0; i < 3; ++i) pair.a[i][axis] = pair.b[i][axis] = height;
    return pair;
  }
  const Vec3 origin = grid_point(random, 9), u = grid_point(random, 9) - Vec3{4, 4, 4};
  const Vec3 v = grid_point(random, 9) - Vec3{4, 4, 4};
  const double steps = random.below(2) == 0 ? 4 : 1000;
  const auto in_plane = [&](const Vec3& p) {
    return origin + std::floor(p.x * steps) * u + std::floor(p.y * steps) * v;
  };
  return {each_vertex(pair.a, in_plane), each_vertex(pair.b, in_plane)};
}

/// Two vertices very close, or the third very close to the line of the others.
inline Triangle needle(Random& random) {
  Triangle t = random_triangle(random);
  const double width = std::ldexp(1.0, -static_cast<int>(10 + random.below(50)));
  const double share = random.below(2) == 0 ? 0 : random.unit();
  t[2] = t[0] + share * (t[1] - t[0]) + width * random_point(random);
  return t;
}

inline TrianglePair needle_pair(Random& random) {
  const Triangle a = needle(random);
  Triangle b = random.below(2) == 0 ? needle(random) : random_triangle(random);
  if (random.below(2) == 0) {  // through or beside a point of a
    const Vec3 goal = point_of(a, random), shift = goal - point_of(b, random);
    b = each_vertex(b, [&](const Vec3& v) { return v + shift; });
  }
  return {a, b};
}

/// Touching up to rounding, with the last bits of everything shaken.
inline TrianglePair ulp_pair(Random& random) {
  TrianglePair pair = plain_pair(random);
  const std::uint64_t touching = 1 + random.below(3);
  for (std::uint64_t i = 0; i < touching; ++i) pair.b[static_cast<int>(i)] = point_of(pair.a, random);
  const auto shake = [&](const Vec3& v) { return random.below(2) == 0 ? v : nudged(v, random); };
  return {each_vertex(pair.a, shake), each_vertex(pair.b, shake)};
}

inline TrianglePair far_pair(Random& random) {
  TrianglePair pair = random.below(2) == 0 ? plain_pair(random) : ulp_pair(random);
  const double distance = random.below(2) == 0 ? 1e6 : 1e15;
  const Vec3 offset = distance * random_point(random);
  const auto move = [&](const Vec3& v) { return v + offset; };
  return {each_vertex(pair.a, move), each_vertex(pair.b, move)};
}

inline Triangle degenerate(Triangle t, Random& random) {
  const int i = static_cast<int>(random.below(3)), j = (i + 1) % 3, k = (i + 2) % 3;
  switch (random.below(4)) {
    case 0:
      t[j] = t[i];
      break;
    case 1:
      t[j] = t[k] = t[i];
      break;
    case 2:
      t[j] = 0.5 * t[i] + 0.5 * t[k];
      break;
    default:
      t[j] = t[i] + t[i] - t[k];
      break;
  }
  return t;
}

inline TrianglePair degenerate_pair(Random& random) {
  TrianglePair pair = random.below(4) == 0   ? coplanar_pair(random)
                      : random.below(2) == 0 ? grid_pair(random)
                                             : ulp_pair(random);
  pair.a = degenerate(pair.a, random);
  if (random.below(2) == 0) pair.b = degenerate(pair.b, random);
  return pair;
}

inline TrianglePair any_pair(Random& random) {
  switch (random.below(8)) {
    case 0:
      return grid_pair(random);
    case 1:
      return shared_pair(random);
    case 2:
      return coplanar_pair(random);
    case 3:
      return needle_pair(random);
    case 4:
      return degenerate_pair(random);
    case 5:
      return far_pair(random);
    default:
      return ulp_pair(random);
  }
}

inline TrianglePair scaled_pair(TrianglePair pair, double factor) {
  const auto scale = [&](const Vec3& v) { return factor * v; };
  return {each_vertex(pair.a, scale), each_vertex(pair.b, scale)};
}

inline TrianglePair tiny_pair(Random& random) {
  const double factor = random.below(2) == 0 ? 1e-300 : 64 * 0x1p-1074;
  return scaled_pair(any_pair(random), factor);
}

/// Up to the greatest double.
inline TrianglePair huge_pair(Random& random) {
  const TrianglePair pair = any_pair(random);
  double greatest = 0;
  for (const Triangle& t : {pair.a, pair.b})
    for (const Vec3& v : t.vertex) greatest = std::max({greatest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return scaled_pair(pair, std::ldexp(1.0, (random.below(2) == 0 ? 1023 : 997) - std::ilogb(std::max(greatest, 1.0))));
}

/// Sizes from 2^-20 to 2^20 and, now and then, from end to end of the doubles, in one pair.
inline TrianglePair mixed_pair(Random& random) {
  TrianglePair pair = any_pair(random);
  if (random.below(2) == 0) std::swap(pair.a, pair.b);
  const int range = random.below(4) == 0 ? 900 : 20;
  const auto stretch = [&](const Vec3& v) {
    const auto factor = [&] {
      return std::ldexp(1.0, static_cast<int>(random.below(2 * static_cast<std::uint64_t>(range))) - range);
    };
    return random.below(3) == 0 ? factor() * v : v;
  };
  return {each_vertex(pair.a, stretch), each_vertex(pair.b, stretch)};
}

inline TrianglePair of_family(const std::string& family, Random& random) {
  if (family == "random") {
    const Triangle a = random_triangle(random);
    return {a, random_triangle(random)};
  }
  if (family == "grid") return grid_pair(random);
  if (family == "shared") return shared_pair(random);
  if (family == "coplanar") return coplanar_pair(random);
  if (family == "needles") return needle_pair(random);
  if (family == "ulp") return ulp_pair(random);
  if (family == "far") return far_pair(random);
  if (family == "tiny") return tiny_pair(random);
  if (family == "huge") return huge_pair(random);
  if (family == "degenerate") return degenerate_pair(random);
  return mixed_pair(random);
}

inline Triangle shuffled(Triangle t, Random& random) {
  std::swap(t[0], t[static_cast<int>(random.below(3))]);
  std::swap(t[1], t[static_cast<int>(1 + random.below(2))]);
  return t;
}

}  // namespace triangle_pairs

/// All coordinates are finite.
inline TrianglePair triangle_pair(const std::string& family, Random& random) {
  const TrianglePair pair = triangle_pairs::of_family(family, random);
  const Triangle a = triangle_pairs::shuffled(pair.a, random);
  return {a, triangle_pairs::shuffled(pair.b, random)};
}

/// In hexadecimal, to see it again bit by bit.
inline std::string to_text(const Triangle& t) {
  std::string text;
  char number[40];
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      std::snprintf(number, sizeof number, "%s%a", axis == 0 ? " {" : ", ", t[i][axis]);
      text += number + std::string(axis == 2 ? "}" : "");
    }
  return text;
}

}  // namespace toccata::test
