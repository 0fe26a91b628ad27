#include "query/decomposition/outermost_corners.hpp"

#include <algorithm>
#include <cmath>
#include <map>

// The corners that a plane made lie in it exactly, so a corner within the polygon of some others in that plane is in
// their hull. Seen along an axis, in doubles, it is taken to be within only where it is farther from every side than
// rounding may be wrong by; to be left of every side of a closed polygon is to be in the hull of its corners, whichever
// polygon it is.
namespace toccata {
namespace {

constexpr double off_by = 0x1p-46;  // of the greatest coordinate

/// Off by less than that of itself.
double about(const Rational& value) {
  const double n = numerator(value).convert_to<double>(), d = denominator(value).convert_to<double>();
  return std::isfinite(n) && std::isfinite(d) ? n / d : nearest_double(value);
}

struct SeenCorner {
  Vec2 at;
  const RationalPoint* exact = nullptr;
};

double turn(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Counter-clockwise, of sorted points (A. M. Andrew, 1979).
std::vector<Vec2> polygon_around(std::span<const SeenCorner> sorted) {
  std::vector<Vec2> chain;
  const auto add = [&](const Vec2& p, std::size_t begin) {
    while (chain.size() > begin + 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
    chain.push_back(p);
  };
  for (const SeenCorner& corner : sorted) add(corner.at, 0);
  const std::size_t upper = chain.size() - 1;
  for (std::size_t i = sorted.size() - 1; i-- > 0;) add(sorted[i].at, upper);
  chain.pop_back();
  return chain;
}

bool is_deep(std::span<const Vec2> polygon, const Vec2& p, double error) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double length = std::fabs(b.x - a.x) + std::fabs(b.y - a.y),
                 away = std::fabs(p.x - a.x) + std::fabs(p.y - a.y);
    if (!(turn(a, b, p) > 32 * error * (length + away))) return false;
  }
  return polygon.size() > 2;
}

/// Appends the outermost of corners in one plane.
void append_outermost(std::span<const RationalPoint* const> corners, const CutPlane& plane,
                      std::vector<RationalPoint>& result) {
  const Vec3 normal = nearest_doubles(plane.normal());
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  std::vector<SeenCorner> seen;
  double largest = 0;
  for (const RationalPoint* corner : corners) {
    seen.push_back({{about((*corner)[(axis + 1) % 3]), about((*corner)[(axis + 2) % 3])}, corner});
    largest = std::max({largest, std::fabs(seen.back().at.x), std::fabs(seen.back().at.y)});
  }
  std::ranges::sort(seen, [](const SeenCorner& p, const SeenCorner& q) {
    return p.at.x < q.at.x || (p.at.x == q.at.x && p.at.y < q.at.y);
  });
  // Products of coordinates must neither over- nor underflow.
  const bool is_seen_well = largest > 0x1p-400 && largest < 0x1p400;
  const std::vector<Vec2> polygon = is_seen_well ? polygon_around(seen) : std::vector<Vec2>{};
  for (const SeenCorner& corner : seen)
    if (!is_deep(polygon, corner.at, off_by * largest)) result.push_back(*corner.exact);
}

}  // namespace

std::vector<RationalPoint> outermost_corners(std::span<const ExactPolygon> polygons, std::span<const CutPlane> planes) {
  std::vector<RationalPoint> result;
  std::map<Index, std::vector<const RationalPoint*>> in_plane;
  for (const ExactPolygon& polygon : polygons)
    for (const ExactCorner& corner : polygon.corners) {
      if (corner.plane)
        in_plane[*corner.plane].push_back(&corner.point);
      else
        result.push_back(corner.point);
    }
  for (const auto& [plane, corners] : in_plane) append_outermost(corners, planes[plane], result);
  return result;
}

}  // namespace toccata
