#include "bounds/smallest_ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace toccata {
namespace {

// Points so little outside are taken to be inside: what is left out is measured at the end.
constexpr double tolerance = 1e-14;

struct Guess {
  Vec3 centre;
  double squared_radius = -1;

  [[nodiscard]] double excess(const Vec3& p) const { return dot(p - centre, p - centre) - squared_radius; }
  [[nodiscard]] bool holds(const Vec3& p) const { return excess(p) <= tolerance; }
};

/// Up to four points that the ball has to have on its boundary.
struct BallBoundary {
  std::array<Vec3, 4> point{};
  std::size_t count = 0;
};

/// Solves the symmetric system of `size` equations by elimination; nothing where it is singular, but for rounding.
std::optional<std::array<double, 3>> solved(std::array<std::array<double, 4>, 3> rows, std::size_t size) {
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < size; ++row)
      if (std::fabs(rows[row][column]) > std::fabs(rows[pivot][column])) pivot = row;
    if (!(std::fabs(rows[pivot][column]) > 1e-28)) return {};
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = 0; row < size; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k < 4; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::array<double, 3> answer{};
  for (std::size_t row = 0; row < size; ++row) answer[row] = rows[row][3] / rows[row][row];
  return answer;
}

/// The smallest ball with all these on its boundary: its centre is p0 + Σ λ_i q_i with q_i = p_i − p0, and from each
/// p_i as far as from p0: Σ_j 2 q_i · q_j λ_j = q_i · q_i.
std::optional<Guess> ball_through(const BallBoundary& boundary) {
  if (boundary.count == 0) return Guess{};
  const Vec3& first = boundary.point[0];
  const std::size_t size = boundary.count - 1;
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t i = 0; i < size; ++i) {
    const Vec3 q = boundary.point[i + 1] - first;
    for (std::size_t j = 0; j < size; ++j) rows[i][j] = 2 * dot(q, boundary.point[j + 1] - first);
    rows[i][3] = dot(q, q);
  }
  const auto weights = solved(rows, size);
  if (!weights) return {};
  Vec3 way;
  for (std::size_t i = 0; i < size; ++i) way = way + (*weights)[i] * (boundary.point[i + 1] - first);
  return Guess{first + way, dot(way, way)};
}

/// Welzl's: a point outside the ball around those before it is on the boundary of the ball around all of them. Such
/// points are moved to the front. No deeper than four calls.
Guess ball_of(std::vector<Vec3>& points, std::size_t count, const BallBoundary& boundary) {
  Guess ball = ball_through(boundary).value_or(Guess{});
  if (boundary.count == 4) return ball;
  for (std::size_t i = 0; i < count; ++i) {
    if (ball.holds(points[i])) continue;
    BallBoundary larger = boundary;
    larger.point[larger.count++] = points[i];
    // A point in the plane, or on the line, of the others adds nothing that doubles could tell.
    if (!ball_through(larger)) continue;
    ball = ball_of(points, i, larger);
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i),
                points.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return ball;
}

}  // namespace

Vec3 smallest_ball_centre(std::span<const Vec3> points) {
  constexpr int rounds = 64;
  std::vector<Vec3> outer{points.front()};
  Guess ball = ball_of(outer, 1, {});
  // Gärtner's pivot: only the farthest point joins the few that are looked at.
  for (int round = 0; round < rounds; ++round) {
    const Vec3* farthest = &points.front();
    for (const Vec3& p : points)
      if (ball.excess(p) > ball.excess(*farthest)) farthest = &p;
    if (ball.holds(*farthest)) break;
    outer.insert(outer.begin(), *farthest);
    const Guess larger = ball_of(outer, outer.size(), {});
    // Rounding may keep it from growing; then it is as good as it gets.
    if (!(larger.squared_radius > ball.squared_radius)) break;
    ball = larger;
  }
  return ball.centre;
}

}  // namespace toccata
