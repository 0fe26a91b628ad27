#include "motion/approach.hpp"

#include <tuple>

#include "motion/scaled_polygon.hpp"

// Cells of time are halved until in each the features stay farther apart than the separation, the earliest first.
//
// A cell. If all corners of the polygon lie at both ends of a cell at n · q > d |n|, they do so at all times in it,
// because each moves in a straight line; and then so does the polygon, so that the features stay more than d apart. The
// direction is that of the nearest point in the middle of the cell: what is lost by it shrinks with the square of the
// cell's length, so that features that slide along each other at nearly this distance are told in one piece. The dot
// products are off by at most `slack` (separating_direction.hpp), and `separation_along` covers the rounding of d |n|
// and of the comparison.
namespace toccata {
namespace {

// A vertex and a face in a turn about each other, at nearly the distance that is asked about, take one cell for every
// root of what is missing. This is so many that a pair is done in about a millisecond.
constexpr int most_looks = 1 << 14;

// An end is looked for in up to so many cells after the first that is not free.
constexpr int cells_to_the_end = 1 << 10;

bool point_comes_first(const MovingPoint* a, const MovingPoint* b) {
  if (a->start != b->start) return lexicographically_less(a->start, b->start);
  return lexicographically_less(a->end, b->end);
}

void put_points_in_order(const MovingPoint*& a, const MovingPoint*& b) {
  if (point_comes_first(b, a)) std::swap(a, b);
}

/// The same for every order of corners, of ends and of edges.
MovingPolygon<3> with_points_in_order(MovingPolygon<3> polygon) {
  put_points_in_order(polygon[0].head, polygon[1].head);
  put_points_in_order(polygon[1].head, polygon[2].head);
  put_points_in_order(polygon[0].head, polygon[1].head);
  return polygon;
}

MovingPolygon<4> with_points_in_order(const MovingPolygon<4>& polygon) {
  std::array a{polygon[0].head, polygon[1].head}, b{polygon[0].tail, polygon[2].tail};
  put_points_in_order(a[0], a[1]);
  put_points_in_order(b[0], b[1]);
  const bool is_b_first =
      point_comes_first(b[0], a[0]) || (!point_comes_first(a[0], b[0]) && point_comes_first(b[1], a[1]));
  if (is_b_first) std::swap(a, b);
  return {{{a[0], b[0]}, {a[1], b[0]}, {a[1], b[1]}, {a[0], b[1]}}};
}

template <std::size_t Count>
class ApproachSearch {
 public:
  ApproachSearch(const ScaledPolygon<Count>& polygon, double latest) : polygon_(polygon), latest_(latest) {}

  [[nodiscard]] std::optional<Approach> search() const;

 private:
  [[nodiscard]] bool stays_farther(double from, double to) const;
  [[nodiscard]] bool is_within(double t) const;
  [[nodiscard]] Approach told_from(double lower) const;

  const ScaledPolygon<Count>& polygon_;
  double latest_;
};

template <std::size_t Count>
bool ApproachSearch<Count>::stays_farther(double from, double to) const {
  const Vec3 direction = of_largest_coordinate_one(nearest_of_polygon(polygon_.at(0.5 * (from + to))).direction);
  const PolygonSpan<Count> span{polygon_.corners, polygon_.magnitude};
  const double wanted = span.slack(direction) + separation_along(direction, polygon_.separation);
  for (const double t : {from, to})
    for (const Vec3& corner : polygon_.at(t))
      if (!(dot(direction, corner) > wanted)) return false;
  return true;
}

/// A mean of corners with weights that are not negative lies in the polygon. A coordinate of a corner at t is off by
/// four roundings of at most the greatest magnitude, and the mean and its weights' sum add ten: less than 2^-48 of it;
/// the length of what is off is at most the sum over the axes.
template <std::size_t Count>
bool ApproachSearch<Count>::is_within(double t) const {
  const Vec3 point = nearest_of_polygon(polygon_.at(t)).point;
  return plain_length(point) * (1 + 0x1p-48) + 0x1p-46 * sum_of_magnitudes(polygon_.magnitude) <= polygon_.separation;
}

/// They stay farther apart before this time, and are not proved to after it.
template <std::size_t Count>
Approach ApproachSearch<Count>::told_from(double lower) const {
  for (int cells = 1; cells <= cells_to_the_end; cells *= 2) {
    const double upper = std::min(lower + cells * cell_length, 1.0);
    if (is_within(upper)) return {{lower, upper}, Status::exact};
  }
  return {{lower, lower + cell_length}, Status::undecided};
}

template <std::size_t Count>
std::optional<Approach> ApproachSearch<Count>::search() const {
  if (is_within(0)) return Approach{{0, 0}, Status::exact};
  double index = 0;
  int level = 0;
  for (int looks = 0; looks < most_looks; ++looks) {
    if (!stays_farther(std::ldexp(index, -level), std::ldexp(index + 1, -level))) {
      if (level == static_cast<int>(contact_level)) return told_from(std::ldexp(index, -level));
      index *= 2;
      ++level;
      continue;
    }
    ++index;
    for (; level > 0 && std::fmod(index, 2) == 0; --level) index /= 2;
    if (level == 0 || std::ldexp(index, -level) > latest_) return {};
  }
  return Approach{{std::ldexp(index, -level), 1}, Status::not_converged};
}

template <std::size_t Count>
std::optional<Approach> approach_of(const MovingPolygon<Count>& polygon, double separation, double latest) {
  return ApproachSearch<Count>(ScaledPolygon<Count>(with_points_in_order(polygon), separation), latest).search();
}

}  // namespace

std::optional<Approach> time_of_approach(const MovingPolygon<3>& polygon, double separation, double latest) {
  return approach_of(polygon, separation, latest);
}
std::optional<Approach> time_of_approach(const MovingPolygon<4>& polygon, double separation, double latest) {
  return approach_of(polygon, separation, latest);
}

}  // namespace toccata
