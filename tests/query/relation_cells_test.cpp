#include "query/relation/relation_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "math/exact.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

constexpr int side = 16;  // of the triangle's legs

/// a x + b y = c in the projection, with the least form of the three numbers.
struct Line {
  int a;
  int b;
  int c;
  friend auto operator<=>(const Line&, const Line&) = default;
};

struct GridPoint {
  int x;
  int y;
};

GridPoint random_point(Random& random) {
  const auto coordinate = [&] { return static_cast<int>(random.below(side + 1)); };
  return {coordinate(), coordinate()};
}

Line line_through(const GridPoint& p, const GridPoint& q) {
  Line line{q.y - p.y, p.x - q.x, 0};
  const int divisor = std::gcd(line.a, line.b) * (line.a < 0 || (line.a == 0 && line.b < 0) ? -1 : 1);
  line.a /= divisor;
  line.b /= divisor;
  line.c = line.a * p.x + line.b * p.y;
  return line;
}

Sign side_of(const Line& line, const Rational& x, const Rational& y) {
  return sign_of(line.a * x + line.b * y - line.c);
}

bool crosses_triangle(const Line& line) {
  const std::set<Sign> sides{side_of(line, 0, 0), side_of(line, side, 0), side_of(line, 0, side)};
  return sides.contains(Sign::positive) && sides.contains(Sign::negative);
}

/// The pieces into which lines cut a convex set: one, one more for each line, and for each point inside one more for
/// every line through it but the first.
std::size_t expected_cells(const std::set<Line>& lines) {
  std::map<std::pair<Rational, Rational>, std::set<Line>> through;
  for (const Line& s : lines)
    for (const Line& t : lines) {
      const int determinant = s.a * t.b - t.a * s.b;
      if (determinant == 0) continue;
      const Rational x = Rational(s.c * t.b - t.c * s.b) / determinant;
      const Rational y = Rational(s.a * t.c - t.a * s.c) / determinant;
      if (x > 0 && y > 0 && x + y < side) through[{x, y}].insert({s, t});
    }
  std::size_t cells = 1 + lines.size();
  for (const auto& [point, meeting] : through) cells += meeting.size() - 1;
  return cells;
}

/// The plane z = x + 2 y, in which the triangle lies.
Vec3 in_plane(double x, double y) { return {x, y, x + 2 * y}; }

/// A vertical triangle that cuts the whole plane of interest along the line.
Triangle wall(const GridPoint& p, const GridPoint& q) {
  const double x = 100.0 * (q.x - p.x), y = 100.0 * (q.y - p.y);
  return {{{{p.x - x, p.y - y, -1e4}, {p.x + x, p.y + y, -1e4}, {double(p.x), double(p.y), 1e5}}}};
}

TEST(RelationCells, AreAllThatLinesCutOutOfATriangle) {
  const Triangle t{{in_plane(0, 0), in_plane(side, 0), in_plane(0, side)}};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::set<Line> lines;
    std::vector<Triangle> cuts;
    for (std::uint64_t count = random.below(14); lines.size() < count;) {
      const GridPoint p = random_point(random), q = random_point(random);
      if (p.x == q.x && p.y == q.y) continue;
      const Line line = line_through(p, q);
      if (!crosses_triangle(line)) continue;
      lines.insert(line);
      cuts.push_back(wall(p, q));  // some twice
    }
    std::set<std::vector<Sign>> cells;
    visit_cells(t, cuts, [&](const ExactPoint& p) {
      const Rational &x = p.rational().x, &y = p.rational().y;
      EXPECT_TRUE(x > 0 && y > 0 && x + y < side && p.rational().z == x + 2 * y);
      std::vector<Sign> sides;
      for (const Line& line : lines) sides.push_back(side_of(line, x, y));
      EXPECT_EQ(std::count(sides.begin(), sides.end(), Sign::zero), 0);
      cells.insert(sides);
      return CellVisit::next;
    });
    EXPECT_EQ(cells.size(), expected_cells(lines));
  }
}

TEST(RelationCells, PointsOfOneCellDiffer) {
  const Triangle t{{in_plane(0, 0), in_plane(side, 0), in_plane(0, side)}};
  std::set<std::pair<Rational, Rational>> points;
  visit_cells(t, {}, [&](const ExactPoint& p) {
    points.insert({p.rational().x, p.rational().y});
    return points.size() < 20 ? CellVisit::another : CellVisit::stop;
  });
  EXPECT_EQ(points.size(), 20U);
}

}  // namespace
}  // namespace toccata
