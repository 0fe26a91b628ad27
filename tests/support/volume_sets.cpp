#include "support/volume_sets.hpp"

#include <span>

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;
using oracle::RationalPoint;

/// All centre ± half_i axis_i.
oracle::ConvexSet box_set(const Vec3& centre, const Mat3& axes, std::span<const double> half, double radius) {
  oracle::ConvexSet set{{exact(centre)}, exact(radius)};
  for (std::size_t i = 0; i < half.size(); ++i) {
    const RationalPoint way = exact(half[i]) * exact(axes[static_cast<int>(i)]);
    std::vector<RationalPoint> moved;
    for (const RationalPoint& p : set.vertices) {
      moved.push_back(p + way);
      moved.push_back(p - way);
    }
    set.vertices = moved;
  }
  return set;
}

}  // namespace

oracle::ConvexSet exact_set(const Aabb& volume) {
  oracle::ConvexSet set;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto along = [&](unsigned axis) {
      return exact((corner >> axis & 1U) != 0 ? volume.upper[static_cast<int>(axis)]
                                              : volume.lower[static_cast<int>(axis)]);
    };
    set.vertices.push_back({along(0), along(1), along(2)});
  }
  return set;
}
oracle::ConvexSet exact_set(const Ball& volume) { return box_set(volume.centre, {}, {}, volume.radius); }
oracle::ConvexSet exact_set(const Cube& volume) {
  return box_set(volume.centre, {}, std::array{volume.half, volume.half, volume.half}, 0);
}
oracle::ConvexSet exact_set(const Obb& volume) {
  return box_set(volume.centre, volume.axes, std::array{volume.half.x, volume.half.y, volume.half.z}, 0);
}
oracle::ConvexSet exact_set(const Pss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
oracle::ConvexSet exact_set(const Lss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
oracle::ConvexSet exact_set(const Rss& volume) {
  return box_set(volume.centre, volume.axes, volume.half, volume.radius);
}
oracle::ConvexSet exact_set(const HullBound& volume) {
  oracle::ConvexSet set;
  for (Index i = 0; i < volume.hull->vertex_count(); ++i) set.vertices.push_back(exact(volume.hull->vertex(i)));
  set.radius = exact(volume.margin);
  return set;
}

bool holds(const EllipsoidBound& volume, const Vec3& point) {
  const RationalPoint y = exact(point) - exact(volume.centre);
  const RationalPoint a = exact(volume.axes[0]), b = exact(volume.axes[1]), c = exact(volume.axes[2]);
  // Cramer's rule for y = s_0 a + s_1 b + s_2 c.
  const Rational determinant = dot(a, cross(b, c));
  const RationalPoint s{dot(y, cross(b, c)) / determinant, dot(a, cross(y, c)) / determinant,
                        dot(a, cross(b, y)) / determinant};
  Rational sum = 0;
  const auto add = [&](const Rational& along, double half) {
    if (half == 0) {
      if (!along.is_zero()) sum = 2;
    } else {
      sum += along * along / (exact(half) * exact(half));
    }
  };
  add(s.x, volume.half.x);
  add(s.y, volume.half.y);
  add(s.z, volume.half.z);
  return sum <= 1;
}

}  // namespace toccata::test
