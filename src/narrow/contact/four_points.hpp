#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "toccata/math/vec3.hpp"

// The few points that stand for a region of contact. Points are seen along the normal: of their `at`, x and y are
// looked at; their `depth` is along it.
namespace toccata {

/// Points are as deep as each other within this part of the depth.
inline constexpr double same_part_of_depth = 0x1p-20;

namespace seen_along_normal {

/// Another point has to be so much better than one that was seen before, and to add so much to what the others span.
inline constexpr double better = 1 + 0x1p-30;
inline constexpr double least_share = 0x1p-20;

inline double squared_length(const Vec3& v) { return v.x * v.x + v.y * v.y; }
inline double twice_area(const Vec3& u, const Vec3& v) { return u.x * v.y - u.y * v.x; }

template <class Points>
double squared_span(const Points& points, const Vec3& from) {
  double span = 0;
  for (const auto& p : points) span = std::fmax(span, squared_length(p.at - from));
  return span;
}

template <class Points>
double greatest_depth(const Points& points) {
  double depth = -HUGE_VAL;
  for (const auto& p : points) depth = std::fmax(depth, p.depth);
  return depth;
}

template <class Points>
Vec3 mean_of(const Points& points) {
  Vec3 sum;
  for (const auto& p : points) sum = sum + p.at;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

/// The first of those farthest from the middle, among the points as deep as any, within `same_depth`.
template <class Points>
std::size_t deepest_of(const Points& points, double same_depth) {
  const double depth = greatest_depth(points);
  const double enough = depth - std::fmax(same_depth, same_part_of_depth * std::fabs(depth));
  const Vec3 middle = mean_of(points);
  std::size_t best = points.size();
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = squared_length(points[i].at - middle);
    if (points[i].depth < enough || (best < points.size() && squared <= better * farthest)) continue;
    best = i;
    farthest = squared;
  }
  return best;
}

}  // namespace seen_along_normal

/// Takes the deepest point, the farthest from it, the farthest from the line through these, and the one that adds the
/// most to the triangle of these. `Points` is a vector of what has `at` and `depth`, and is not empty.
template <class Points>
class FourPoints {
 public:
  /// Points nearer to each other than a part of `size` are one.
  FourPoints(Points& points, double same_depth, double size = 1)
      : points_(points),
        same_depth_(same_depth),
        least_squared_(seen_along_normal::least_share * seen_along_normal::least_share * size * size) {}

  Points taken() {
    using namespace seen_along_normal;
    Points four(points_.get_allocator());
    std::swap(points_.front(), points_[deepest_of(points_, same_depth_)]);
    const Vec3 first = points_.front().at;
    const double span = squared_span(points_, first);
    four.push_back(points_.front());
    const auto add = [&](const auto& measure, double least) {
      const Point* best = nullptr;
      double greatest = least;
      for (const Point& p : points_)
        if (const double here = measure(p.at); here > (best == nullptr ? greatest : better * greatest)) {
          best = &p;
          greatest = here;
        }
      if (best != nullptr) four.push_back(*best);
      return best != nullptr;
    };
    if (!add([&](const Vec3& p) { return squared_length(p - first); }, least_squared_)) return four;
    const Vec3 way = four[1].at - first;
    if (!add([&](const Vec3& p) { return std::fabs(twice_area(way, p - first)); }, least_share * span)) return four;
    add([&](const Vec3& p) { return area_added(four, p); }, least_share * span);
    return four;
  }

 private:
  using Point = typename Points::value_type;

  /// By a point to a triangle, twice: over the side that it sees best.
  static double area_added(const Points& triangle, const Vec3& p) {
    using seen_along_normal::twice_area;
    const Vec3 &a = triangle[0].at, &b = triangle[1].at, &c = triangle[2].at;
    const double turn = twice_area(b - a, c - a) > 0 ? -1 : 1;
    return std::max(
        {turn * twice_area(b - a, p - a), turn * twice_area(c - b, p - b), turn * twice_area(a - c, p - c)});
  }

  Points& points_;
  double same_depth_;
  double least_squared_;
};

}  // namespace toccata
