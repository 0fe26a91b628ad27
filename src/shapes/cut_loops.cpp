#include "shapes/cut_loops.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "shapes/ear_clipping.hpp"

namespace toccata {
namespace {

/// Grows with the angle by which the way turns left from a → b to b → c, from −2 to 2.
double left_turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u{b.x - a.x, b.y - a.y}, v{c.x - b.x, c.y - b.y};
  const double along = u.x * v.x + u.y * v.y, across = u.x * v.y - u.y * v.x;
  const double sum = std::abs(along) + std::abs(across);
  if (sum == 0) return 0;
  return along >= 0 ? across / sum : (across >= 0 ? 2 : -2) - across / sum;
}

/// A loop on the way to be cut: with holes that are joined to it.
using JoinedLoop = CornerLoop;

/// The corner of the hole that lies farthest to the right.
std::size_t rightmost(std::span<const Vec2> points, const CornerLoop& hole) {
  return static_cast<std::size_t>(std::max_element(hole.begin(), hole.end(),
                                                   [&](Index i, Index j) {
                                                     return std::pair(points[i].x, points[i].y) <
                                                            std::pair(points[j].x, points[j].y);
                                                   }) -
                                  hole.begin());
}

/// A place in one of several loops.
struct LoopPlace {
  std::size_t loop = 0;
  std::size_t corner = 0;
};

class HoleJoiner {
 public:
  HoleJoiner(std::span<const Vec2> points, std::vector<JoinedLoop> outer) : points_(points), loops_(std::move(outer)) {}

  /// Holes come from the right to the left. False where nothing is around it.
  bool join(const CornerLoop& hole) {
    const std::size_t first = rightmost(points_, hole);
    const std::optional<LoopPlace> bridge = bridge_from(points_[hole[first]]);
    if (!bridge) return false;
    JoinedLoop& loop = loops_[bridge->loop];
    JoinedLoop added;
    for (std::size_t i = 0; i <= hole.size(); ++i) added.push_back(hole[(first + i) % hole.size()]);
    added.push_back(loop[bridge->corner]);
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(bridge->corner) + 1, added.begin(), added.end());
    return true;
  }

  [[nodiscard]] const std::vector<JoinedLoop>& loops() const { return loops_; }

 private:
  [[nodiscard]] const Vec2& corner(const LoopPlace& place) const { return points_[loops_[place.loop][place.corner]]; }
  [[nodiscard]] LoopPlace next(const LoopPlace& place) const {
    return {place.loop, (place.corner + 1) % loops_[place.loop].size()};
  }
  [[nodiscard]] LoopPlace previous(const LoopPlace& place) const {
    const std::size_t count = loops_[place.loop].size();
    return {place.loop, (place.corner + count - 1) % count};
  }

  /// A corner to the right that sees the point: an end of the nearest edge there, or a corner that hides it.
  [[nodiscard]] std::optional<LoopPlace> bridge_from(const Vec2& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<LoopPlace> found;
    each_place([&](const LoopPlace& place) {
      const Vec2 &from = corner(place), &to = corner(next(place));
      if (!(from.y <= point.y && point.y < to.y)) return;
      const double x = from.x + (point.y - from.y) / (to.y - from.y) * (to.x - from.x);
      if (!(x >= point.x && x < nearest)) return;
      nearest = x;
      found = from.x >= to.x ? place : next(place);
    });
    if (!found) return {};
    return seen_instead_of(*found, point, {nearest, point.y});
  }

  /// The corner whose triangle with the point and where the ray meets the edge holds no other, and of those at one
  /// point that which the bridge enters from inside.
  [[nodiscard]] LoopPlace seen_instead_of(const LoopPlace& place, const Vec2& point, const Vec2& met) const {
    LoopPlace best = place;
    double least = slope_from(point, corner(place));
    const Sign turn = orient2d(point, met, corner(place));
    each_place([&](const LoopPlace& other) {
      const Vec2& p = corner(other);
      const bool is_inside = p.x >= point.x && turn != Sign::zero && orient2d(point, met, p) != -turn &&
                             orient2d(met, corner(place), p) != -turn && orient2d(corner(place), point, p) != -turn;
      const bool is_same = p == corner(best);
      if (!is_inside && !is_same) return;
      const double slope = slope_from(point, p);
      const bool is_nearer = slope < least || (slope == least && p.x < corner(best).x);
      if ((!is_nearer && !is_same) || !opens_to(other, point)) return;
      best = other;
      least = slope;
    });
    return best;
  }

  static double slope_from(const Vec2& point, const Vec2& to) {
    return std::abs(to.y - point.y) / (std::abs(to.y - point.y) + std::abs(to.x - point.x));
  }

  /// The point lies in the corner's angle, to the left of both of its edges.
  [[nodiscard]] bool opens_to(const LoopPlace& place, const Vec2& point) const {
    const Vec2 &before = corner(previous(place)), &at = corner(place), &after = corner(next(place));
    const bool left_of_first = orient2d(before, at, point) != Sign::negative;
    const bool left_of_second = orient2d(at, after, point) != Sign::negative;
    return orient2d(before, at, after) == Sign::negative ? left_of_first || left_of_second
                                                         : left_of_first && left_of_second;
  }

  template <class See>
  void each_place(const See& see) const {
    for (std::size_t loop = 0; loop < loops_.size(); ++loop)
      for (std::size_t i = 0; i < loops_[loop].size(); ++i) see(LoopPlace{loop, i});
  }

  std::span<const Vec2> points_;
  std::vector<JoinedLoop> loops_;
};

double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// Clips ears as `clip_ears` does, but of loops that cross themselves by a little: a corner is in the way only where it
/// lies in a triangle by more than that. Where there is no ear, the corner goes that takes the least area.
class RoundedClipper {
 public:
  RoundedClipper(std::span<const Vec2> points, JoinedLoop loop, double negligible)
      : points_(points), loop_(std::move(loop)), negligible_(negligible) {}

  [[nodiscard]] std::optional<std::vector<std::array<Index, 3>>> clip() {
    std::vector<std::array<Index, 3>> triangles;
    double clockwise = 0;
    while (loop_.size() > 2) {
      const std::size_t ear = find_ear();
      const std::array<Index, 3> t = corners_at(ear);
      clockwise += std::max(0.0, -area_of(t));
      triangles.push_back(t);
      loop_.erase(loop_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (clockwise > negligible_) return {};
    return triangles;
  }

 private:
  [[nodiscard]] std::array<Index, 3> corners_at(std::size_t i) const {
    const std::size_t count = loop_.size();
    return {loop_[(i + count - 1) % count], loop_[i], loop_[(i + 1) % count]};
  }
  [[nodiscard]] double area_of(const std::array<Index, 3>& t) const {
    return triangle_area(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  [[nodiscard]] std::size_t find_ear() const {
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const std::array<Index, 3> t = corners_at(i);
      const double area = area_of(t);
      if (area > negligible_ && is_clear(t)) return i;
      if (std::abs(area) >= least) continue;
      least = std::abs(area);
      flattest = i;
    }
    return flattest;
  }

  [[nodiscard]] bool is_clear(const std::array<Index, 3>& t) const {
    const Vec2 &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    return std::none_of(loop_.begin(), loop_.end(), [&](Index i) {
      const Vec2& p = points_[i];
      return triangle_area(a, b, p) > negligible_ && triangle_area(b, c, p) > negligible_ &&
             triangle_area(c, a, p) > negligible_;
    });
  }

  std::span<const Vec2> points_;
  JoinedLoop loop_;
  double negligible_;
};

std::optional<std::vector<std::array<Index, 3>>> cut_joined(std::span<const Vec2> points,
                                                            const std::vector<JoinedLoop>& loops, double negligible) {
  std::vector<std::array<Index, 3>> triangles;
  for (const JoinedLoop& loop : loops) {
    std::vector<Vec2> corners;
    for (const Index i : loop) corners.push_back(points[i]);
    const std::vector<CornerTriangle> cut = clip_ears(corners);
    if (cut.empty()) {
      const auto rounded = RoundedClipper(points, loop, negligible).clip();
      if (!rounded) return {};
      triangles.insert(triangles.end(), rounded->begin(), rounded->end());
    }
    for (const CornerTriangle& t : cut) triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  return triangles;
}

std::optional<std::vector<std::array<Index, 3>>> cut_rightwards(std::span<const Vec2> points,
                                                                std::span<const CornerLoop> loops, double negligible) {
  std::vector<JoinedLoop> outer;
  std::vector<CornerLoop> holes;
  for (const CornerLoop& loop : loops) (loop_area(points, loop) > 0 ? outer : holes).push_back(loop);
  std::stable_sort(holes.begin(), holes.end(), [&](const CornerLoop& a, const CornerLoop& b) {
    const Vec2 &p = points[a[rightmost(points, a)]], &q = points[b[rightmost(points, b)]];
    return std::pair(p.x, p.y) > std::pair(q.x, q.y);
  });
  HoleJoiner joiner(points, std::move(outer));
  for (const CornerLoop& hole : holes)
    if (!joiner.join(hole)) return {};
  return cut_joined(points, joiner.loops(), negligible);
}

}  // namespace

std::vector<CornerLoop> loops_of_edges(std::span<const Vec2> points, std::span<const std::array<Index, 2>> edges) {
  std::multimap<Index, Index> heads;
  for (const auto& [tail, head] : edges) heads.emplace(tail, head);
  std::vector<CornerLoop> loops;
  while (!heads.empty()) {
    CornerLoop loop{heads.begin()->first};
    Index from = loop[0], at = heads.begin()->second;
    heads.erase(heads.begin());
    while (at != loop[0]) {
      loop.push_back(at);
      const auto [first, last] = heads.equal_range(at);
      if (first == last) return {};  // no loop
      const auto sharpest = std::max_element(first, last, [&](const auto& one, const auto& other) {
        return left_turn(points[from], points[at], points[one.second]) <
               left_turn(points[from], points[at], points[other.second]);
      });
      from = std::exchange(at, sharpest->second);
      heads.erase(sharpest);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double loop_area(std::span<const Vec2> points, const CornerLoop& loop) {
  const Vec2& origin = points[loop[0]];
  double twice = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec2 &p = points[loop[i]], &q = points[loop[i + 1]];
    twice += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  return twice / 2;
}

std::optional<std::vector<std::array<Index, 3>>> cut_loops(std::span<const Vec2> points,
                                                           std::span<const CornerLoop> loops, double negligible) {
  std::vector<Vec2> turned(points.begin(), points.end());
  for (int quarter = 0; quarter < 4; ++quarter) {
    if (auto triangles = cut_rightwards(turned, loops, negligible)) return triangles;
    for (Vec2& p : turned) p = {-p.y, p.x};
  }
  return {};
}

}  // namespace toccata
