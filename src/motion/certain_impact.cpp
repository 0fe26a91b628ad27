#include "motion/certain_impact.hpp"

#include "math/number_vector.hpp"
#include "motion/moment.hpp"
#include "motion/separating_direction.hpp"
#include "motion/volume_filter.hpp"

namespace toccata {
namespace {

/// A cubic by its four Bernstein coefficients over a part of the time, each off by at most `error`.
struct BernsteinCubic {
  std::array<double, 4> b{};
  double error = 0;

  [[nodiscard]] bool is_positive(std::size_t i) const { return b[i] > error; }
  [[nodiscard]] bool is_negative(std::size_t i) const { return b[i] < -error; }
  [[nodiscard]] bool has_no_root() const {
    const auto all = [&](auto is) { return is(0) && is(1) && is(2) && is(3); };
    return all([&](std::size_t i) { return is_positive(i); }) || all([&](std::size_t i) { return is_negative(i); });
  }
  /// The coefficients change their sign once, whatever the uncertain ones are; so there is one root, and it is simple.
  [[nodiscard]] bool has_one_root() const {
    if (is_positive(0) && is_negative(3)) return is_positive(1) || is_negative(2);
    if (is_negative(0) && is_positive(3)) return is_negative(1) || is_positive(2);
    return false;
  }
  /// All but one have the same certain sign. If that one, at an end, is zero, then the end is the only root.
  [[nodiscard]] bool has_all_signs_but(std::size_t i) const {
    int sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += k == i ? 0 : is_positive(k) - is_negative(k);
    return sum == 3 || sum == -3;
  }
};

// A coefficient is at most P in magnitude, but for its error, and the error is at least 15.8εP (volume_filter.hpp). To
// divide by three rounds by εP, to halve the time three times in a row by 3εP, and a quarter of the error covers
// either.
constexpr double error_growth = 1.25;

/// An infinite error makes all signs uncertain. It is that of a cubic, or of a NaN, whose coefficients or means may
/// overflow: one of infinite size has a sign, but its means have not.
double error_within_range(double error, double size) { return size < 0x1p900 ? error : HUGE_VAL; }

/// The error is 2^-50 of twice what bounds the coefficients, so one below 2^900 leaves room for three times as much.
BernsteinCubic cubic_of(const BernsteinVolume& v) {
  return {{v.start, v.near_start / 3, v.near_end / 3, v.end}, error_within_range(error_growth * v.error, v.error)};
}

/// The same by numbers of twice the length, for what stays nearly in one plane. The coefficients are rounded to
/// doubles; the error allows for that, and for the halving of coefficients of this size as above.
template <std::size_t Count>
BernsteinCubic precise_cubic(const MovingPolygon<Count>& polygon) {
  std::array<BoundedVector, 3> start, end;
  for (std::size_t i = 0; i < 3; ++i) {
    start[i] = bounded_difference(polygon[i].head->start, polygon[i].tail->start);
    end[i] = bounded_difference(polygon[i].head->end, polygon[i].tail->end);
  }
  const BoundedVector first = cross(start[0], start[1]), last = cross(end[0], end[1]);
  const BoundedVector mixed = cross(end[0], start[1]) + cross(start[0], end[1]);
  const std::array<BoundedNumber, 4> b{dot(first, start[2]), (dot(mixed, start[2]) + dot(first, end[2])) / exactly(3),
                                       (dot(last, start[2]) + dot(mixed, end[2])) / exactly(3), dot(last, end[2])};
  BernsteinCubic cubic;
  double off = 0, size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    cubic.b[i] = middle(b[i]);
    // A NaN must not be lost, as it would be by std::max.
    off += distance_from_high(b[i]);
    size += std::fabs(cubic.b[i]);
  }
  cubic.error = error_within_range(off + 0x1p-49 * size, size);
  return cubic;
}

struct CubicHalves {
  BernsteinCubic first;
  BernsteinCubic second;
};

/// Both halves of the cubic, by de Casteljau's means.
CubicHalves halves_of(const BernsteinCubic& c) {
  const auto mean = [](double a, double b) { return 0.5 * (a + b); };
  const double early = mean(c.b[0], c.b[1]), middle = mean(c.b[1], c.b[2]), late = mean(c.b[2], c.b[3]);
  const double before = mean(early, middle), after = mean(middle, late), half = mean(before, after);
  const double error = error_growth * c.error;
  return {{{c.b[0], early, before, half}, error}, {{half, after, late, c.b[3]}, error}};
}

double value_at(const std::array<double, 4>& b, double t) {
  const double s = 1 - t;
  const double early = s * b[0] + t * b[1], middle = s * b[1] + t * b[2], late = s * b[2] + t * b[3];
  return s * (s * early + t * middle) + t * (s * middle + t * late);
}

double slope_at(const std::array<double, 4>& b, double t) {
  const double s = 1 - t;
  return 3 * ((s * s) * (b[1] - b[0]) + (2 * s * t) * (b[2] - b[1]) + (t * t) * (b[3] - b[2]));
}

/// A fraction of the cubic's time near its only root; nothing is proved (regula falsi after Illinois).
double approximate_root(const std::array<double, 4>& b) {
  double low = 0, high = 1, at_low = b[0], at_high = b[3];
  for (int step = 0; step < 40 && high - low > 0x1p-50; ++step) {
    double t = low + (high - low) * (at_low / (at_low - at_high));
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    if (t == low || t == high) break;
    const double value = value_at(b, t);
    if (value == 0) return t;
    if ((value > 0) == (b[0] > 0)) {
      low = t;
      at_low = value;
      at_high *= 0.5;
    } else {
      high = t;
      at_high = value;
      at_low *= 0.5;
    }
  }
  return std::fabs(at_low) < std::fabs(at_high) ? low : high;
}

/// Times [index, index + 1] / 2^depth.
struct TimePart {
  double index = 0;
  int depth = 0;

  [[nodiscard]] double at(double fraction) const { return std::ldexp(index + fraction, -depth); }
};

/// The corner at any time that t stands for.
BoundedVector at_time(const MovingCorner& c, const BoundedNumber& t) {
  const BoundedVector start = bounded_difference(c.head->start, c.tail->start);
  const BoundedVector end = bounded_difference(c.head->end, c.tail->end);
  return start + t * (end - start);
}

/// A corner at any time of the cell [t, t + cell_length].
VectorOf<BoundedDouble> within_cell(const RoundedCorner& c, double t) {
  VectorOf<BoundedDouble> result;
  for (int axis = 0; axis < 3; ++axis) {
    const double start = c.start[axis], end = c.end[axis], way = end - start;
    // Two roundings of differences, one of a product, two of sums: five times 2^-53 of either end, and |way| 2^-40.
    const double rounding = 0x1p-50 * (std::fabs(start) + std::fabs(end)) + filter::floor;
    result[static_cast<std::size_t>(axis)] = {start + t * way, rounding + cell_length * std::fabs(way)};
  }
  return result;
}

enum class Found { nothing, contact, doubt };

/// Where the only root of a part of the time is: in the interior of the cell that starts here, or perhaps exactly here.
struct RootPlace {
  double start = 0;
  bool is_in_cell = false;
  Sign before = Sign::zero;  ///< of the cubic, before the root
};

/// Whether a polygon, in whose plane the origin lies, contains it.
template <class Number, std::size_t Count>
Found side_of_origin(const std::array<VectorOf<Number>, Count>& q) {
  const VectorOf<Number> normal = outer(difference(q[1], q[0]), difference(q[2], q[0]));
  bool are_all_certain = true;
  for (std::size_t i = 0; i < Count; ++i) {
    const Number side = inner(outer(q[i], q[(i + 1) % Count]), normal);
    if (side.is_negative()) return Found::nothing;
    are_all_certain = are_all_certain && side.is_positive();
  }
  return are_all_certain ? Found::contact : Found::doubt;
}

/// Halves the time where the cubic or a direction does not tell, the earlier half first, and looks at roots.
template <std::size_t Count>
class CertainContact {
 public:
  explicit CertainContact(const MovingPolygon<Count>& polygon, const RoundedPolygon<Count>& corners)
      : polygon_(polygon), corners_(corners), magnitude_(greatest_magnitudes(corners)) {}

  [[nodiscard]] Found search(const BernsteinCubic& cubic, const TimePart& part);
  [[nodiscard]] TimeOfImpact contact() const { return contact_; }

 private:
  static constexpr int greatest_depth = 4;
  static constexpr int steps_of_whole = 16;
  static constexpr int steps_of_part = 8;

  [[nodiscard]] PolygonSpan<Count> span_of(const TimePart& part) const;
  [[nodiscard]] Found look_at_root(const BernsteinCubic& cubic, const TimePart& part);
  [[nodiscard]] Found look_at_moment(double t);
  [[nodiscard]] std::optional<RootPlace> place_of_root(double guess, bool falls) const;
  [[nodiscard]] BoundedNumber volume_at(const BoundedNumber& t) const;
  [[nodiscard]] Sign volume_sign(const BoundedNumber& t) const;
  [[nodiscard]] Found inside_at_root(const RootPlace& cell, double guess, double slope) const;
  [[nodiscard]] Found inside_near_root(const RootPlace& cell, double guess, double slope) const;

  const MovingPolygon<Count>& polygon_;
  const RoundedPolygon<Count>& corners_;
  Vec3 magnitude_;
  TimeOfImpact contact_;  ///< what was found
};

template <std::size_t Count>
PolygonSpan<Count> CertainContact<Count>::span_of(const TimePart& part) const {
  if (part.depth == 0) return {corners_, magnitude_};
  const double from = part.at(0), to = part.at(1);
  PolygonSpan<Count> span{{}, magnitude_};
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& [start, end] = corners_[i];
    span.corners[i] = {(1 - from) * start + from * end, (1 - to) * start + to * end};
  }
  return span;
}

template <std::size_t Count>
Found CertainContact<Count>::search(const BernsteinCubic& cubic, const TimePart& part) {
  if (cubic.has_no_root()) return Found::nothing;
  if (has_separating_direction(span_of(part), part.depth == 0 ? steps_of_whole : steps_of_part)) return Found::nothing;
  if (cubic.has_one_root()) return look_at_root(cubic, part);
  for (const double end : {0.0, 1.0}) {
    if (!cubic.has_all_signs_but(end == 0 ? 0 : 3)) continue;
    if (const Found found = look_at_moment(part.at(end)); found != Found::doubt) return found;
  }
  if (part.depth == greatest_depth) return Found::doubt;
  const auto [first, second] = halves_of(cubic);
  const Found early = search(first, {2 * part.index, part.depth + 1});
  return early != Found::nothing ? early : search(second, {2 * part.index + 1, part.depth + 1});
}

template <std::size_t Count>
Found CertainContact<Count>::look_at_root(const BernsteinCubic& cubic, const TimePart& part) {
  const double fraction = approximate_root(cubic.b), guess = part.at(fraction);
  const std::optional<RootPlace> place = place_of_root(guess, cubic.b[0] > 0);
  if (!place) return Found::doubt;
  if (!place->is_in_cell) return look_at_moment(place->start);
  contact_ = {place->start, place->start + cell_length};
  return inside_at_root(*place, guess, std::ldexp(slope_at(cubic.b, fraction), part.depth));
}

/// For a time that is the only root of a part of the time, if it is one.
template <std::size_t Count>
Found CertainContact<Count>::look_at_moment(double t) {
  const std::optional<Moment<Count>> moment = moment_at(polygon_, t);
  if (!moment || moment->volume_sign() != Sign::zero) return Found::doubt;
  contact_ = {t, t};
  return moment->is_contact() ? Found::contact : Found::nothing;
}

/// A cell is looked at to its end only where the root is not before its start, so that no time after the part is.
template <std::size_t Count>
std::optional<RootPlace> CertainContact<Count>::place_of_root(double guess, bool falls) const {
  const Sign before = falls ? Sign::positive : Sign::negative;
  double cell = std::ldexp(std::floor(std::ldexp(guess, contact_level)), -static_cast<int>(contact_level));
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Sign at_start = volume_sign(exactly(cell));
    if (at_start == Sign::zero) return RootPlace{cell, false, before};
    if (at_start != before) {
      cell -= cell_length;
      continue;
    }
    const double next = cell + cell_length;
    const Sign at_end = volume_sign(exactly(next));
    if (at_end == Sign::zero) return RootPlace{next, false, before};
    if (at_end != before) return RootPlace{cell, true, before};
    cell = next;
  }
  return {};
}

template <std::size_t Count>
BoundedNumber CertainContact<Count>::volume_at(const BoundedNumber& t) const {
  return dot(cross(at_time(polygon_[0], t), at_time(polygon_[1], t)), at_time(polygon_[2], t));
}

/// Zero where it is not certain.
template <std::size_t Count>
Sign CertainContact<Count>::volume_sign(const BoundedNumber& t) const {
  const BoundedNumber volume = volume_at(t);
  return volume.is_positive() ? Sign::positive : volume.is_negative() ? Sign::negative : Sign::zero;
}

/// Decides by numbers in doubles, which allow for the whole cell, and else by longer ones nearer to the root.
template <std::size_t Count>
Found CertainContact<Count>::inside_at_root(const RootPlace& cell, double guess, double slope) const {
  std::array<VectorOf<BoundedDouble>, Count> q;
  for (std::size_t i = 0; i < Count; ++i) q[i] = within_cell(corners_[i], cell.start);
  const Found found = side_of_origin(q);
  return found == Found::doubt ? inside_near_root(cell, guess, slope) : found;
}

/// One step of Newton's in numbers of twice the length leads to an interval of 2^-87, in which the cell's root is when
/// it lies in the cell and the cubic changes its sign there as it does at the root.
template <std::size_t Count>
Found CertainContact<Count>::inside_near_root(const RootPlace& cell, double guess, double slope) const {
  constexpr double radius = 0x1p-88;
  const DoubleWord root = double_word(two_sum(guess, -volume_at(exactly(guess)).value.high / slope));
  const Sign before = volume_sign({root + DoubleWord{-radius, 0}, 0}),
             after = volume_sign({root + DoubleWord{radius, 0}, 0});
  // The margin is more than the radius and the rounding of the sum; the difference is exact where it is small.
  const double into_cell = (root.high - cell.start) + root.low;
  if (!(into_cell > 0x1p-84 && into_cell < cell_length - 0x1p-84)) return Found::doubt;
  if (before != cell.before || after == Sign::zero || after == before) return Found::doubt;
  std::array<BoundedVector, Count> q;
  // The times before and after are themselves rounded by less than a radius.
  for (std::size_t i = 0; i < Count; ++i) q[i] = at_time(polygon_[i], {root, radius});
  return side_of_origin(q);
}

template <std::size_t Count>
CertainAnswer<TimeOfImpact> certain_contact_of(const MovingPolygon<Count>& polygon) {
  const RoundedPolygon<Count> corners = rounded(polygon);
  for (int axis = 0; axis < 3; ++axis)
    if (is_apart_along(corners, axis)) return {true};
  const BernsteinVolume volume = bernstein_volume(corners[0], corners[1], corners[2]);
  if (volume.is_certainly_not_zero()) return {true};
  CertainContact<Count> contact(polygon, corners);
  Found found = contact.search(cubic_of(volume), {});
  if (found == Found::doubt) found = contact.search(precise_cubic(polygon), {});
  if (found == Found::doubt) return {};
  return found == Found::contact ? CertainAnswer<TimeOfImpact>{true, contact.contact()}
                                 : CertainAnswer<TimeOfImpact>{true};
}

}  // namespace

CertainAnswer<TimeOfImpact> certain_time_of_impact(const MovingPolygon<3>& polygon) {
  return certain_contact_of(polygon);
}
CertainAnswer<TimeOfImpact> certain_time_of_impact(const MovingPolygon<4>& polygon) {
  return certain_contact_of(polygon);
}

}  // namespace toccata
