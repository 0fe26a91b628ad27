#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "math/vec3_measures.hpp"
#include "toccata/narrow/convex_convex.hpp"

// The nearest points of two features by a formula in doubles, with a bound on the error of every number. Inline, since
// a tracked pair asks for little else.
//
// Errors are in units of u = 2^-53. World vertices are exact; a difference x of two of them is off by u|x|. Bounds are
// of first order and rounded up by some per cent: terms of second order are 2^-20 of them at most, as `nearly` asks,
// and computing a bound takes less than fifty roundings. Lengths are between 2^-100 and 2^100 and squares of areas not
// less than 2^-400, so that what underflow takes, at most 2^-1074 times a few lengths, is less than 2^-300 of any
// bound.
namespace toccata {

/// The nearest points of two cores, the radii left aside. Errors are lengths.
struct FormulaNearest {
  Vec3 on_a;
  Vec3 on_b;
  double point_error = 0;  ///< of either point, less 2^-48 of the greatest coordinate of the shapes
  Vec3 difference;         ///< on_a − on_b
  double difference_error = 0;
  double distance = 0;
  double distance_error = 0;
};

/// A feature of each shape: its first vertex, and the edges that spread both features, two at most, those of A before
/// those of B. They start at the first vertex; those of B are turned round.
struct SpreadFeatures {
  Vec3 on_a;
  Vec3 on_b;
  std::array<Vec3, 2> edge;
  std::size_t edges_of_a = 0;
  std::size_t edges_of_b = 0;
};

struct FormulaNumbers {
  FormulaNearest nearest;
  /// A positive multiple of the features' exact difference, each coordinate off by the slack at most. For features that
  /// span a plane it is the normal, or the opposite.
  Vec3 across;
  double slack = 0;
  bool is_turned = false;  ///< of a plane: the opposite
};

inline constexpr double formula_unit = 0x1p-53;

inline bool in_formula_range(double least_squared_length, double greatest_squared_length) {
  return least_squared_length >= 0x1p-200 && greatest_squared_length <= 0x1p200;
}

/// An error is small enough for its square to be left aside.
inline bool nearly(double relative_error) { return relative_error <= 0x1p-20; }

/// Exact arithmetic does better there: distances along an axis are often doubles.
inline bool is_along_axis(const Vec3& v) {
  return static_cast<int>(v.x == 0) + static_cast<int>(v.y == 0) + static_cast<int>(v.z == 0) > 1;
}

[[gnu::always_inline]] inline bool solve_at_vertices(const SpreadFeatures& s, FormulaNumbers& numbers) {
  constexpr double u = formula_unit;
  const Vec3 first = s.on_a - s.on_b;
  const double squared = dot(first, first);
  if (!in_formula_range(squared, squared)) return false;
  const double distance = std::sqrt(squared);
  const double off = 2 * u * distance;
  numbers = {{s.on_a, s.on_b, 0, first, off, distance, 4 * u * distance}, first, off, false};
  return true;
}

/// The share t = −first · e / e · e is off by 12u |first| / |e|. What that moves the difference by lies along the edge,
/// across the difference: its length changes in second order only. `other` is what rounds apart from that.
[[gnu::always_inline]] inline bool solve_on_edge(const SpreadFeatures& s, FormulaNumbers& numbers) {
  constexpr double u = formula_unit;
  const Vec3 first = s.on_a - s.on_b, way = s.edge[0];
  const double squared = dot(way, way), first_squared = dot(first, first);
  if (!in_formula_range(std::min(squared, first_squared), std::max(squared, first_squared))) return false;
  const double share = -dot(first, way) / squared;
  const double length = std::sqrt(squared), first_length = std::sqrt(first_squared);
  const double share_error = 13 * u * (first_length / length);
  if (!(share > share_error && 1 - share > share_error + 2 * u)) return false;
  const Vec3 moved = share * way, difference = first + moved;
  const double distance = std::sqrt(dot(difference, difference));
  const double other = 1.25 * u * (first_length + 2 * length + distance), aside = 1.0625 * share_error * length;
  if (!(distance >= 0x1p-100) || !nearly((aside + other) / distance)) return false;
  const bool of_a = s.edges_of_a == 1;
  const double difference_error = 1.0625 * (aside + other);
  numbers = {{of_a ? s.on_a + moved : s.on_a, of_a ? s.on_b : s.on_b - moved, aside, difference, difference_error,
              distance, other + aside * (aside / distance) + 5 * u * distance},
             difference,
             difference_error,
             false};
  return true;
}

/// With the normal n = e × f of the edges and the height h = n · first, the difference is (h / n · n) n. As a vector, n
/// is off by 6u |e||f|, and h is by 11u |e||f||first|. The shares of e and f, (f × first) · n and (first × e) · n, are
/// in units of n · n, and off by 16u |first||e||f| times |f| and |e|.
[[gnu::always_inline]] inline bool solve_on_plane(const SpreadFeatures& s, FormulaNumbers& numbers) {
  constexpr double u = formula_unit;
  const Vec3 first = s.on_a - s.on_b, e = s.edge[0], f = s.edge[1], normal = cross(e, f);
  const double e_squared = dot(e, e), f_squared = dot(f, f), first_squared = dot(first, first);
  const double squared = dot(normal, normal), height = dot(normal, first);
  const double longest_squared = std::max(e_squared, f_squared);
  if (!in_formula_range(std::min(std::min(e_squared, f_squared), first_squared),
                        std::max(longest_squared, first_squared)) ||
      !(squared >= 0x1p-400))
    return false;
  const double area = std::sqrt(e_squared * f_squared), longest = std::sqrt(longest_squared);
  const double first_length = std::sqrt(first_squared), normal_length = std::sqrt(squared);
  const double skew = area / normal_length;

  const double share_e = dot(cross(f, first), normal), share_f = dot(cross(first, e), normal);
  const double share_off = 17 * u * (first_length * area) * longest;
  const bool two_edges = s.edges_of_a == 1;
  const double rest = two_edges ? squared - std::max(share_e, share_f) : (squared - share_e) - share_f;
  // n · n is off by 12u skew of itself, and rounds.
  const double rest_off = 2.125 * share_off + (13 * skew + 8) * u * squared;
  if (!(std::min(share_e, share_f) > share_off && rest > rest_off)) return false;

  const double height_off = 11 * u * (area * first_length) / std::fabs(height), normal_off = 6 * u * skew;
  if (!nearly(height_off + 2 * normal_off)) return false;  // NaN included
  const double distance = std::fabs(height) / normal_length, inverse = 1 / squared;
  const Vec3 difference = (height * inverse) * normal;
  const double difference_error = 1.0625 * distance * (height_off + 3 * normal_off + 9 * u);
  const double distance_error = 1.0625 * distance * (height_off + normal_off + 6 * u);
  if (two_edges) {
    const double point_error = 1.0625 * u * (17 * first_length * skew * skew + longest * (13 * skew + 10));
    numbers.nearest = {s.on_a + (share_e * inverse) * e,
                       s.on_b - (share_f * inverse) * f,
                       point_error,
                       difference,
                       difference_error,
                       distance,
                       distance_error};
  } else {
    const bool of_a = s.edges_of_a == 2;
    numbers.nearest = {of_a ? s.on_b + difference : s.on_a,
                       of_a ? s.on_b : s.on_a - difference,
                       difference_error,
                       difference,
                       difference_error,
                       distance,
                       distance_error};
  }
  numbers.is_turned = !(height > 0);
  numbers.across = numbers.is_turned ? -normal : normal;
  numbers.slack = 6 * u * area;
  return true;
}

/// Whether the nearest points certainly lie inside the features; and the numbers, where they do.
[[gnu::always_inline]] inline bool solve_formula(const SpreadFeatures& s, FormulaNumbers& numbers) {
  const std::size_t edges = s.edges_of_a + s.edges_of_b;
  const bool solved = edges == 2   ? solve_on_plane(s, numbers)
                      : edges == 1 ? solve_on_edge(s, numbers)
                                   : solve_at_vertices(s, numbers);
  return solved && !is_along_axis(numbers.nearest.difference);
}

/// The interval around a gap that is off by at most `error`.
[[gnu::always_inline]] inline std::optional<Distance> formula_interval(double gap, double error, const Vec3& on_a,
                                                                       const Vec3& on_b) {
  if (!(error <= 0.45e-12 * gap)) return {};
  const double off = 1.0625 * error + 4 * formula_unit * gap;
  return Distance{gap - off, gap + off, on_a, on_b, Status::exact};
}

/// The answer of `distance` for shapes with radii, if the numbers are good enough for what is promised of it. They are
/// given by value, so that those of shapes without radii need no memory.
[[nodiscard]] std::optional<Distance> offset_formula_distance(FormulaNearest nearest, double radius_a, double radius_b);

/// The same of shapes without.
[[gnu::always_inline]] inline std::optional<Distance> plain_formula_distance(const FormulaNearest& nearest) {
  // What either point is off by, apart from roundings of coordinates of the shapes; the promise is about a greatest
  // coordinate that is at least each of these.
  const double size = std::max(largest_magnitude(nearest.on_a), largest_magnitude(nearest.on_b));
  if (!(nearest.point_error <= 0.9e-12 * size)) return {};
  return formula_interval(nearest.distance, nearest.distance_error, nearest.on_a, nearest.on_b);
}

}  // namespace toccata
