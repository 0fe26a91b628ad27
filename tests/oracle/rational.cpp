#include "oracle/rational.hpp"

#include <cmath>
#include <tuple>

namespace toccata::oracle {

bool operator<(const RationalPoint& a, const RationalPoint& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

RationalPoint operator+(const RationalPoint& a, const RationalPoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RationalPoint operator-(const RationalPoint& a) { return {-a.x, -a.y, -a.z}; }
RationalPoint operator*(const Rational& s, const RationalPoint& a) { return {s * a.x, s * a.y, s * a.z}; }

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec3 rounded(const RationalPoint& p) { return {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }

bool is_zero(const RationalPoint& a) { return a.x.is_zero() && a.y.is_zero() && a.z.is_zero(); }

RationalPoint centroid(const std::vector<RationalPoint>& points) {
  RationalPoint sum;
  for (const RationalPoint& p : points) sum = sum + p;
  return Rational(1, points.size()) * sum;
}

Rational exact(double value) { return Rational(value); }

RationalPoint exact(const Vec3& point) { return {exact(point.x), exact(point.y), exact(point.z)}; }

Vec3 world_vertex(const Pose& pose, const Vec3& local) {
  // Every product and sum has a name of its own, so that the order and the rounding after each step can be seen.
  const auto coordinate = [&](int i) {
    const double product_x = pose.linear[i].x * local.x;
    const double product_y = pose.linear[i].y * local.y;
    const double product_z = pose.linear[i].z * local.z;
    const double sum_xy = product_x + product_y;
    const double sum_xyz = sum_xy + product_z;
    return sum_xyz + pose.offset[i];
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

bool is_singular(const Pose& pose) {
  const RationalPoint r0 = exact(pose.linear[0]);
  return dot(r0, cross(exact(pose.linear[1]), exact(pose.linear[2]))).is_zero();
}

bool keeps_balls_round(const Pose& pose) {
  const Rational limit = exact(0x1p-40);
  for (int i = 0; i < 3; ++i) {
    Rational row_sum;
    for (int j = 0; j < 3; ++j) {
      const Rational entry = dot(exact(pose.linear.column(i)), exact(pose.linear.column(j))) - (i == j ? 1 : 0);
      row_sum += abs(entry);
    }
    if (row_sum > limit) return false;
  }
  return true;
}

Rational orientation(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
  return dot(cross(b - a, c - a), d - a);
}

bool are_coplanar(const std::vector<RationalPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const RationalPoint plane_normal = cross(points[i] - points[0], points[j] - points[0]);
      if (is_zero(plane_normal)) continue;
      // Three points that span a plane: all are coplanar exactly when all lie in this one.
      for (const RationalPoint& p : points)
        if (!dot(plane_normal, p - points[0]).is_zero()) return false;
      return true;
    }
  return true;
}

HalfSpace half_space(const RationalPoint& point, const RationalPoint& normal) { return {normal, dot(normal, point)}; }

Rational height_above(const HalfSpace& half_space, const RationalPoint& p) {
  return dot(half_space.normal, p) - half_space.offset;
}

// I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974. Closed: corners in the plane stay. A segment is
// walked as a polygon of two corners, there and back.
std::vector<RationalPoint> clipped(const std::vector<RationalPoint>& polygon, const HalfSpace& half_space) {
  std::vector<Rational> heights;
  for (const RationalPoint& p : polygon) heights.push_back(height_above(half_space, p));
  std::vector<RationalPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (heights[i] <= 0) kept.push_back(polygon[i]);
    if (heights[i].sign() * heights[next].sign() < 0) {
      const Rational fraction = heights[i] / (heights[i] - heights[next]);
      kept.push_back(polygon[i] + fraction * (polygon[next] - polygon[i]));
    }
  }
  return kept;
}

}  // namespace toccata::oracle
