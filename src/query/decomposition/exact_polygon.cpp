#include "query/decomposition/exact_polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace toccata {
namespace {

/// The doubles next to a number, below and above; one and the same where it is a double.
std::array<double, 2> doubles_around(const Rational& value) {
  const double nearest = nearest_double(value);
  const int off = Rational(value - to_rational(nearest)).sign();
  if (off == 0) return {nearest, nearest};
  if (off > 0) return {nearest, std::nextafter(nearest, HUGE_VAL)};
  return {std::nextafter(nearest, -HUGE_VAL), nearest};
}

}  // namespace

PolygonBeside::PolygonBeside(const ExactPolygon& polygon, const CutPlane& plane, Index number)
    : polygon_(polygon), number_(number) {
  heights_.reserve(polygon.corners.size());
  for (const ExactCorner& corner : polygon.corners) {
    heights_.push_back(plane.height(corner.point));
    front_ = front_ || heights_.back() > 0;
    back_ = back_ || heights_.back() < 0;
  }
}

ExactPolygon PolygonBeside::clipped(int sign) const {
  ExactPolygon result{polygon_.triangle, {}};
  const std::size_t count = heights_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const ExactCorner &p = polygon_.corners[i], &q = polygon_.corners[next];
    if (sign * heights_[i].sign() >= 0) result.corners.push_back(p);
    if (heights_[i].sign() * heights_[next].sign() < 0)
      result.corners.push_back(
          {p.point + Rational(heights_[i] / (heights_[i] - heights_[next])) * (q.point - p.point), number_});
  }
  return result;
}

void append_doubles_around(const RationalPoint& point, std::vector<Vec3>& points) {
  const auto x = doubles_around(point.x), y = doubles_around(point.y), z = doubles_around(point.z);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const bool is_again = (i == 1 && x[0] == x[1]) || (j == 1 && y[0] == y[1]) || (k == 1 && z[0] == z[1]);
    if (!is_again) points.push_back({x[i], y[j], z[k]});
  }
}

bool contains(const ConvexHull& hull, const RationalPoint& point) {
  if (hull.dimension() < 3) return false;
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index h = topology.face_start[f];
    const auto corner = [&](Index i) { return to_rational(hull.vertex(topology.origin[h + i])); };
    if (orient3d(corner(0), corner(1), corner(2), point) == Sign::positive) return false;
  }
  return true;
}

bool contains(const std::array<Vec3, 3>& triangle, const RationalPoint& point) {
  const RationalPoint a = to_rational(triangle[0]), b = to_rational(triangle[1]), c = to_rational(triangle[2]);
  const RationalPoint normal = cross(b - a, c - a);
  if (dot(normal, point - a) != 0) return false;
  // Beside every edge, seen along the normal.
  const auto beside = [&](const RationalPoint& p, const RationalPoint& q) {
    return dot(cross(q - p, point - p), normal) >= 0;
  };
  return beside(a, b) && beside(b, c) && beside(c, a);
}

}  // namespace toccata
