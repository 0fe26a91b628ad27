#include "query/decomposition/solid_piece.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shapes/hull_faces.hpp"

namespace toccata {
namespace {

double snapped(double height, double tolerance) { return std::fabs(height) <= tolerance ? 0 : height; }

/// Where an edge passes the plane: the same bits from both of its triangles.
Vec3 crossing(const Vec3& p, const Vec3& q, double height_p, double height_q) {
  if (lexicographically_less(q, p)) return crossing(q, p, height_q, height_p);
  const double t = height_p / (height_p - height_q);
  return p + t * (q - p);
}

/// A convex polygon beside a plane, with the heights of its corners.
struct ClippedTriangle {
  std::array<Vec3, 4> corners{};
  std::array<bool, 4> on_plane{};
  std::size_t count = 0;

  void add(const Vec3& corner, bool is_on) {
    corners[count] = corner;
    on_plane[count++] = is_on;
  }
};

/// The part in front where `sign` is 1, that behind where it is −1. None where only the border is there.
ClippedTriangle clipped(const RoundedTriangle& triangle, const RoundedPlane& plane, double sign, double tolerance) {
  std::array<double, 3> heights{};
  bool inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    heights[i] = sign * snapped(plane.height(triangle[i]), tolerance);
    inside = inside || heights[i] > 0;
  }
  ClippedTriangle result;
  if (!inside) return result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (heights[i] >= 0) result.add(triangle[i], heights[i] == 0);
    if (heights[i] * heights[next] < 0)
      result.add(crossing(triangle[i], triangle[next], heights[i], heights[next]), true);
  }
  return result;
}

void append(std::vector<RoundedTriangle>& triangles, const ClippedTriangle& polygon) {
  for (std::size_t i = 2; i < polygon.count; ++i)
    triangles.push_back({polygon.corners[0], polygon.corners[i - 1], polygon.corners[i]});
}

/// The edges of the polygon in the plane, against their direction: the cap goes round the other way.
void append_border(std::vector<RoundedSegment>& border, const ClippedTriangle& polygon) {
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const std::size_t next = (i + 1) % polygon.count;
    if (polygon.on_plane[i] && polygon.on_plane[next]) border.push_back({polygon.corners[next], polygon.corners[i]});
  }
}

std::vector<RoundedTriangle> fan(const std::vector<RoundedSegment>& border) {
  std::vector<RoundedTriangle> triangles;
  if (border.empty()) return triangles;
  const Vec3 apex = border.front()[0];
  for (const RoundedSegment& s : border)
    if (!(s[0] == apex) && !(s[1] == apex)) triangles.push_back({apex, s[0], s[1]});
  return triangles;
}

/// Where a signed sum of segments on one line is not zero.
std::vector<RoundedSegment> covered(const std::vector<RoundedSegment>& segments, double tolerance) {
  std::vector<RoundedSegment> result;
  Vec3 extent{};
  for (const RoundedSegment& s : segments)
    for (int axis = 0; axis < 3; ++axis) extent[axis] = std::max(extent[axis], std::fabs(s[1][axis] - s[0][axis]));
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  std::vector<std::pair<Vec3, int>> events;
  for (const RoundedSegment& s : segments) {
    const int direction = s[0][axis] < s[1][axis] ? 1 : -1;
    events.emplace_back(direction > 0 ? s[0] : s[1], direction);
    events.emplace_back(direction > 0 ? s[1] : s[0], -direction);
  }
  std::ranges::stable_sort(events, [&](const auto& p, const auto& q) { return p.first[axis] < q.first[axis]; });
  int count = 0;
  Vec3 start{};
  for (std::size_t i = 0; i < events.size(); ++i) {
    const int before = count;
    count += events[i].second;
    while (i + 1 < events.size() && events[i + 1].first[axis] - events[i].first[axis] <= tolerance)
      count += events[++i].second;
    if (before == 0 && count != 0) start = events[i].first;
    if (before != 0 && count == 0) result.push_back({start, events[i].first});
  }
  return result;
}

SolidPiece half(const SolidPiece& piece, const RoundedPlane& plane, double sign, Index number, double tolerance) {
  SolidPiece result;
  std::vector<RoundedSegment> border;
  const auto take = [&](const std::vector<RoundedTriangle>& from, std::vector<RoundedTriangle>& to) {
    for (const RoundedTriangle& triangle : from) {
      const ClippedTriangle polygon = clipped(triangle, plane, sign, tolerance);
      append(to, polygon);
      append_border(border, polygon);
    }
  };
  take(piece.surface, result.surface);
  for (const RoundedSegment& s : piece.edges) {
    const double p = sign * snapped(plane.height(s[0]), tolerance), q = sign * snapped(plane.height(s[1]), tolerance);
    if (p <= 0 && q <= 0) continue;
    const Vec3 between = p * q < 0 ? crossing(s[0], s[1], p, q) : s[0];
    result.edges.push_back({p < 0 ? between : s[0], q < 0 ? between : s[1]});
  }
  for (const PieceCap& cap : piece.caps) {
    const std::size_t before = border.size();
    PieceCap part{cap.plane, {}};
    take(cap.triangles, part.triangles);
    const auto added = border.begin() + static_cast<std::ptrdiff_t>(before);
    const std::vector<RoundedSegment> meeting = covered({added, border.end()}, tolerance);
    result.edges.insert(result.edges.end(), meeting.begin(), meeting.end());
    if (!part.triangles.empty()) result.caps.push_back(std::move(part));
  }
  if (PieceCap cap{number, fan(border)}; !cap.triangles.empty()) result.caps.push_back(std::move(cap));
  result.volume = enclosed_volume(result);
  return result;
}

double six_volume(const Vec3& apex, const RoundedTriangle& t) {
  return dot(cross(t[0] - apex, t[1] - apex), t[2] - apex);
}

/// How much of a triangle's area lies where heights are positive.
double share_in_front(double a, double b, double c) {
  const int positive = (a > 0 ? 1 : 0) + (b > 0 ? 1 : 0) + (c > 0 ? 1 : 0);
  if (positive == 0) return 0;
  if (a >= 0 && b >= 0 && c >= 0) return 1;
  if (positive == 2) return 1 - share_in_front(-a, -b, -c);
  if (b > 0) return share_in_front(b, c, a);
  if (c > 0) return share_in_front(c, a, b);
  return (a / (a - b)) * (a / (a - c));
}

}  // namespace

std::vector<Vec3> SolidPiece::points() const {
  std::vector<Vec3> result;
  result.reserve(3 * surface.size() + 2 * edges.size());
  for (const RoundedTriangle& t : surface) result.insert(result.end(), t.begin(), t.end());
  for (const RoundedSegment& s : edges) result.insert(result.end(), s.begin(), s.end());
  std::ranges::sort(result, lexicographically_less);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

SplitPiece split(const SolidPiece& piece, const RoundedPlane& plane, Index number, double tolerance) {
  return {half(piece, plane, 1, number, tolerance), half(piece, plane, -1, number, tolerance)};
}

double volume_in_front(const SolidPiece& piece, const RoundedPlane& plane) {
  // From a point of the plane the cut itself has no volume, so the triangles alone tell it.
  const Vec3 apex = plane.offset * plane.normal;
  double sum = 0;
  const auto add = [&](const std::vector<RoundedTriangle>& triangles) {
    for (const RoundedTriangle& t : triangles) {
      const double share = share_in_front(plane.height(t[0]), plane.height(t[1]), plane.height(t[2]));
      if (share != 0) sum += share * six_volume(apex, t);
    }
  };
  add(piece.surface);
  for (const PieceCap& cap : piece.caps) add(cap.triangles);
  return sum / 6;
}

std::vector<Vec3> part_in_front(const RoundedTriangle& triangle, const RoundedPlane& plane, double tolerance) {
  const ClippedTriangle polygon = clipped(triangle, plane, 1, tolerance);
  return {polygon.corners.begin(), polygon.corners.begin() + static_cast<std::ptrdiff_t>(polygon.count)};
}

double enclosed_volume(const SolidPiece& piece) {
  if (piece.surface.empty()) {
    if (piece.caps.empty() || piece.caps[0].triangles.empty()) return 0;
  }
  const Vec3 apex = piece.surface.empty() ? piece.caps[0].triangles[0][0] : piece.surface[0][0];
  double sum = 0;
  for (const RoundedTriangle& t : piece.surface) sum += six_volume(apex, t);
  for (const PieceCap& cap : piece.caps)
    for (const RoundedTriangle& t : cap.triangles) sum += six_volume(apex, t);
  return sum / 6;
}

double hull_volume(std::span<const Vec3> points) {
  if (points.size() < 4) return 0;
  const std::vector<HullTriangle> triangles = hull_triangles(points);
  double sum = 0;
  for (const HullTriangle& t : triangles) {
    const auto& [a, b, c] = t.vertices;
    sum += six_volume(points[triangles[0].vertices[0]], {points[a], points[b], points[c]});
  }
  return sum / 6;
}

}  // namespace toccata
