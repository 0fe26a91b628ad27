#pragma once

#include <array>
#include <span>
#include <vector>

#include "oracle/convex.hpp"
#include "toccata/bounds/all_volumes.hpp"

// Which set a volume is, as its header says, in rational numbers, and whether it can turn: what tests of volumes want
// to be told of a new one.
namespace toccata::test {

/// Turned, it is as tight as before: it has no directions that are given.
template <class V>
inline constexpr bool can_turn = true;
template <>
inline constexpr bool can_turn<Aabb> = false;
template <>
inline constexpr bool can_turn<Cube> = false;
template <std::size_t k>
inline constexpr bool can_turn<Kdop<k>> = false;

/// All centre ± half_i axis_i.
inline oracle::ConvexSet box_set(const Vec3& centre, const Mat3& axes, std::span<const double> half, double radius) {
  oracle::ConvexSet set{{oracle::exact(centre)}, oracle::exact(radius)};
  for (std::size_t i = 0; i < half.size(); ++i) {
    const oracle::RationalPoint way = oracle::exact(half[i]) * oracle::exact(axes[static_cast<int>(i)]);
    std::vector<oracle::RationalPoint> moved;
    for (const oracle::RationalPoint& p : set.vertices) {
      moved.push_back(p + way);
      moved.push_back(p - way);
    }
    set.vertices = moved;
  }
  return set;
}

inline oracle::ConvexSet exact_set(const Aabb& volume) {
  oracle::ConvexSet set;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto along = [&](unsigned axis) {
      return oracle::exact((corner >> axis & 1U) != 0 ? volume.upper[static_cast<int>(axis)]
                                                      : volume.lower[static_cast<int>(axis)]);
    };
    set.vertices.push_back({along(0), along(1), along(2)});
  }
  return set;
}
inline oracle::ConvexSet exact_set(const Ball& volume) { return box_set(volume.centre, {}, {}, volume.radius); }
inline oracle::ConvexSet exact_set(const Cube& volume) {
  return box_set(volume.centre, {}, std::array{volume.half, volume.half, volume.half}, 0);
}
inline oracle::ConvexSet exact_set(const Obb& volume) {
  return box_set(volume.centre, volume.axes, std::array{volume.half.x, volume.half.y, volume.half.z}, 0);
}
inline oracle::ConvexSet exact_set(const Pss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
inline oracle::ConvexSet exact_set(const Lss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
inline oracle::ConvexSet exact_set(const Rss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
inline oracle::ConvexSet exact_set(const HullBound& volume) {
  oracle::ConvexSet set;
  for (Index i = 0; i < volume.hull->vertex_count(); ++i) set.vertices.push_back(oracle::exact(volume.hull->vertex(i)));
  set.radius = oracle::exact(volume.margin);
  return set;
}

template <class V>
concept HasExactSet = requires(const V& volume) {
  exact_set(volume);
};

/// The point is in the set, exactly.
template <HasExactSet V>
bool holds(const V& volume, const Vec3& point) {
  return oracle::side_of(oracle::exact(point), exact_set(volume)) <= 0;
}

inline bool holds(const EllipsoidBound& volume, const Vec3& point) {
  const oracle::RationalPoint y = oracle::exact(point) - oracle::exact(volume.centre);
  const oracle::RationalPoint a = oracle::exact(volume.axes[0]), b = oracle::exact(volume.axes[1]),
                              c = oracle::exact(volume.axes[2]);
  // Cramer's rule for y = s_0 a + s_1 b + s_2 c.
  const oracle::Rational determinant = dot(a, cross(b, c));
  const oracle::RationalPoint s{dot(y, cross(b, c)) / determinant, dot(a, cross(y, c)) / determinant,
                                dot(a, cross(b, y)) / determinant};
  oracle::Rational sum = 0;
  const auto add = [&](const oracle::Rational& along, double half) {
    if (half == 0) {
      if (!along.is_zero()) sum = 2;
    } else {
      sum += along * along / (oracle::exact(half) * oracle::exact(half));
    }
  };
  add(s.x, volume.half.x);
  add(s.y, volume.half.y);
  add(s.z, volume.half.z);
  return sum <= 1;
}

template <std::size_t k>
bool holds(const Kdop<k>& volume, const Vec3& point) {
  for (std::size_t i = 0; i < Kdop<k>::slabs; ++i) {
    const oracle::Rational height = dot(oracle::exact(kdop_normals<k>()[i]), oracle::exact(point));
    if (height < oracle::exact(volume.lower[i]) || height > oracle::exact(volume.upper[i])) return false;
  }
  return true;
}

}  // namespace toccata::test
