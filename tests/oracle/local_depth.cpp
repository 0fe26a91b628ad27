#include "oracle/local_depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

namespace toccata::oracle {
namespace {

constexpr std::size_t unknowns = 5;
using Unknowns = std::array<double, unknowns>;
using SquareMatrix = std::array<Unknowns, unknowns>;

/// row · x ≤ most, of x = (point, s, t).
struct Inequality {
  Unknowns row{};
  double most = 0;
};

double product(const Unknowns& row, const Unknowns& x) {
  double sum = 0;
  for (std::size_t i = 0; i < unknowns; ++i) sum += row[i] * x[i];
  return sum;
}

/// By elimination (Gauss, Jordan); nothing where the rows are nearly dependent.
std::optional<SquareMatrix> inverse_of(SquareMatrix m) {
  SquareMatrix inverse{};
  for (std::size_t i = 0; i < unknowns; ++i) inverse[i][i] = 1;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < unknowns; ++row)
      if (std::abs(m[row][column]) > std::abs(m[pivot][column])) pivot = row;
    if (std::abs(m[pivot][column]) < 1e-9) return {};
    std::swap(m[column], m[pivot]);
    std::swap(inverse[column], inverse[pivot]);
    const double factor = 1 / m[column][column];
    for (std::size_t i = 0; i < unknowns; ++i) {
      m[column][i] *= factor;
      inverse[column][i] *= factor;
    }
    for (std::size_t row = 0; row < unknowns; ++row) {
      const double times = m[row][column];
      if (row == column || times == 0) continue;
      for (std::size_t i = 0; i < unknowns; ++i) {
        m[row][i] -= times * m[column][i];
        inverse[row][i] -= times * inverse[column][i];
      }
    }
  }
  return inverse;
}

std::vector<Inequality> inequalities_of(std::span<const FacetPlane> a, std::span<const FacetPlane> b) {
  std::vector<Inequality> all;
  for (const FacetPlane& plane : a)
    all.push_back({{plane.normal.x, plane.normal.y, plane.normal.z, 1, 0}, plane.offset});
  for (const FacetPlane& plane : b)
    all.push_back({{plane.normal.x, plane.normal.y, plane.normal.z, 0, 1}, plane.offset});
  all.push_back({{0, 0, 0, -1, 0}, 0});
  all.push_back({{0, 0, 0, 0, -1}, 0});
  return all;
}

/// Greater by so much is greater by rounding.
constexpr double rounding_of_program = 1e-11;

/// Looks at the corner at which five inequalities are equations, and at what is proved where s + t is a sum of the five
/// with factors that are not negative.
void look_at_corner(const std::array<const Inequality*, unknowns>& five, std::span<const Inequality> all,
                    LocalDepth& known) {
  SquareMatrix rows;
  for (std::size_t i = 0; i < unknowns; ++i) rows[i] = five[i]->row;
  const std::optional<SquareMatrix> inverse = inverse_of(rows);
  if (!inverse) return;
  Unknowns corner{}, factors{};
  double proved = 0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t j = 0; j < unknowns; ++j) corner[i] += (*inverse)[i][j] * five[j]->most;
    factors[i] = (*inverse)[3][i] + (*inverse)[4][i];
    proved += factors[i] * five[i]->most;
  }
  if (std::ranges::all_of(factors, [](double factor) { return factor >= -rounding_of_program; }))
    known.upper = std::min(known.upper, proved);
  const double sum = corner[3] + corner[4];
  if (sum > known.lower && std::ranges::all_of(all, [&](const Inequality& one) {
        return product(one.row, corner) <= one.most + rounding_of_program * (1 + std::abs(one.most));
      }))
    known.lower = sum;
}

double distance_from_box(const Vec3& p, const AxisBox& box) {
  Vec3 gap;
  for (int i = 0; i < 3; ++i) gap[i] = p[i] - std::clamp(p[i], box.lower[i], box.upper[i]);
  return std::sqrt(dot(gap, gap));
}

/// The corners and then the middle.
using CellPoints = std::array<Vec3, 9>;

CellPoints points_of_cell(const AxisBox& cell) {
  CellPoints points;
  for (std::size_t i = 0; i < 8; ++i)
    points[i] = {(i & 1) != 0 ? cell.upper.x : cell.lower.x, (i & 2) != 0 ? cell.upper.y : cell.lower.y,
                 (i & 4) != 0 ? cell.upper.z : cell.lower.z};
  points[8] = 0.5 * (cell.lower + cell.upper);
  return points;
}

/// What the points of a cell are to one surface.
struct CellDistances {
  std::array<double, 9> distance{};           ///< of each point
  std::vector<std::array<double, 8>> bounds;  ///< of the corners from some rectangles
};

CellDistances distances_of(const CellPoints& points, std::span<const AxisBox> surface) {
  CellDistances found;
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.distance[i] = std::numeric_limits<double>::infinity();
    std::size_t at = 0;
    for (std::size_t j = 0; j < surface.size(); ++j)
      if (const double distance = distance_from_box(points[i], surface[j]); distance < found.distance[i]) {
        found.distance[i] = distance;
        at = j;
      }
    if (std::ranges::find(nearest, at) == nearest.end()) nearest.push_back(at);
  }
  for (const std::size_t j : nearest) {
    std::array<double, 8>& bound = found.bounds.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) bound[i] = distance_from_box(points[i], surface[j]);
  }
  return found;
}

struct BoundedCell {
  AxisBox cell;
  double bound = 0;
  friend bool operator<(const BoundedCell& x, const BoundedCell& y) { return x.bound < y.bound; }
};

/// With what was found at its points.
BoundedCell bounded_cell(const AxisBox& cell, const CellSolid& a, const CellSolid& b, double& found) {
  const CellPoints points = points_of_cell(cell);
  const CellDistances of_a = distances_of(points, a.surface), of_b = distances_of(points, b.surface);
  for (std::size_t i = 0; i < points.size(); ++i) found = std::max(found, of_a.distance[i] + of_b.distance[i]);
  BoundedCell result{cell, std::numeric_limits<double>::infinity()};
  for (const std::array<double, 8>& s : of_a.bounds)
    for (const std::array<double, 8>& t : of_b.bounds) {
      double greatest = 0;
      for (std::size_t i = 0; i < 8; ++i) greatest = std::max(greatest, s[i] + t[i]);
      result.bound = std::min(result.bound, greatest);
    }
  return result;
}

std::vector<AxisBox> common_cells(const CellSolid& a, const CellSolid& b) {
  std::vector<AxisBox> cells;
  for (const AxisBox& of_a : a.cells)
    for (const AxisBox& of_b : b.cells) {
      AxisBox common;
      bool has_volume = true;
      for (int i = 0; i < 3; ++i) {
        common.lower[i] = std::max(of_a.lower[i], of_b.lower[i]);
        common.upper[i] = std::min(of_a.upper[i], of_b.upper[i]);
        has_volume = has_volume && common.lower[i] < common.upper[i];
      }
      if (has_volume) cells.push_back(common);
    }
  return cells;
}

std::array<AxisBox, 2> halves_of(const AxisBox& cell) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (cell.upper[i] - cell.lower[i] > cell.upper[axis] - cell.lower[axis]) axis = i;
  std::array<AxisBox, 2> halves{cell, cell};
  halves[0].upper[axis] = halves[1].lower[axis] = 0.5 * (cell.lower[axis] + cell.upper[axis]);
  return halves;
}

}  // namespace

LocalDepth local_depth_of_convex(std::span<const FacetPlane> a, std::span<const FacetPlane> b) {
  const std::vector<Inequality> all = inequalities_of(a, b);
  LocalDepth known{0, std::numeric_limits<double>::infinity()};
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k)
        for (std::size_t l = k + 1; l < count; ++l)
          for (std::size_t m = l + 1; m < count; ++m) {
            look_at_corner({&all[i], &all[j], &all[k], &all[l], &all[m]}, all, known);
            if (known.upper - known.lower < rounding_of_program) return known;
          }
  return known;
}

LocalDepth local_depth_of_cells(const CellSolid& a, const CellSolid& b, double precision) {
  LocalDepth known;
  std::priority_queue<BoundedCell> waiting;
  for (const AxisBox& cell : common_cells(a, b)) waiting.push(bounded_cell(cell, a, b, known.lower));
  while (!waiting.empty() && waiting.top().bound > (1 + precision) * known.lower) {
    const AxisBox cell = waiting.top().cell;
    waiting.pop();
    for (const AxisBox& half : halves_of(cell)) waiting.push(bounded_cell(half, a, b, known.lower));
  }
  known.upper = waiting.empty() ? 0 : std::max(known.lower, waiting.top().bound);
  return known;
}

}  // namespace toccata::oracle
