#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/integer_polynomial.hpp"
#include "motion/moving_polygon.hpp"

namespace toccata {
namespace {

/// A contact's place in the answer: in the cell of this index, or at its start.
struct ContactCell {
  WideInteger index = 0;
  bool is_inside = false;
};

bool operator<(const ContactCell& a, const ContactCell& b) {
  return a.index != b.index ? a.index < b.index : a.is_inside < b.is_inside;
}

/// Cells of the answer, whatever the root's own cell is.
ContactCell contact_cell(PolynomialRoot& root) {
  while (!root.is_start && root.cell.level < contact_level) root.narrow();
  const unsigned level = root.cell.level;
  if (level < contact_level) return {WideInteger(root.cell.index << (contact_level - level)), !root.is_start};
  const unsigned finer = level - contact_level;
  const WideInteger index = root.cell.index >> finer;
  return {index, !root.is_start || root.cell.index != (index << finer)};
}

TimeOfImpact told(const ContactCell& cell) {
  const double lower = std::ldexp(cell.index.convert_to<double>(), -static_cast<int>(contact_level));
  return {lower, cell.is_inside ? lower + cell_length : lower};
}

/// The corners as polynomials in the time, over a common power of two.
std::vector<PolynomialVector> corners_of(std::span<const MovingCorner> polygon) {
  std::vector<Vec3> points;
  for (const MovingCorner& c : polygon)
    points.insert(points.end(), {c.head->start, c.head->end, c.tail->start, c.tail->end});
  const int exponent = common_exponent(points);
  std::vector<PolynomialVector> corners;
  for (const MovingCorner& c : polygon) {
    const IntegerVector start = scaled_wide(c.head->start, exponent) - scaled_wide(c.tail->start, exponent);
    const IntegerVector end = scaled_wide(c.head->end, exponent) - scaled_wide(c.tail->end, exponent);
    PolynomialVector& q = corners.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = IntegerPolynomial(start[axis], end[axis]);
  }
  return corners;
}

bool is_zero(const PolynomialVector& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

bool is_zero_at(const PolynomialVector& v, PolynomialRoot& t) {
  return sign_at(v[0], t) == Sign::zero && sign_at(v[1], t) == Sign::zero && sign_at(v[2], t) == Sign::zero;
}

/// A polygon whose corners are polynomials, and the question whether it contains the origin.
class PolynomialPolygon {
 public:
  explicit PolynomialPolygon(std::vector<PolynomialVector> corners)
      : corners_(std::move(corners)),
        normal_(cross(corners_[1] - corners_[0], corners_[2] - corners_[0])),
        volume_(dot(normal_, corners_[0])) {}

  [[nodiscard]] std::optional<ContactCell> first_contact();

 private:
  /// Twice the area of the origin and an edge, times the length of the normal: once the origin lies in the plane, it is
  /// inside while none of them is negative.
  [[nodiscard]] const IntegerPolynomial& side(std::size_t i) const {
    if (!sides_[i]) sides_[i] = dot(cross(corners_[i], corners_[(i + 1) % corners_.size()]), normal_);
    return *sides_[i];
  }
  [[nodiscard]] bool contains_origin_at(PolynomialRoot& t) const;
  [[nodiscard]] bool segment_contains_origin_at(PolynomialRoot& t) const;
  [[nodiscard]] std::vector<IntegerPolynomial> polynomials_of_candidates() const;
  void add_products(std::vector<IntegerPolynomial>& found) const;

  std::vector<PolynomialVector> corners_;
  PolynomialVector normal_;
  IntegerPolynomial volume_;
  mutable std::array<std::optional<IntegerPolynomial>, 4> sides_;  ///< computed when first needed
};

/// For corners that all lie in one line.
bool PolynomialPolygon::segment_contains_origin_at(PolynomialRoot& t) const {
  const std::size_t count = corners_.size();
  bool are_all_on_one_side = true;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (!is_zero_at(cross(corners_[i], corners_[j]), t)) return false;
      are_all_on_one_side = are_all_on_one_side && sign_at(dot(corners_[i], corners_[j]), t) == Sign::positive;
    }
  }
  return !are_all_on_one_side;
}

/// For a time at which the origin lies in the polygon's plane.
bool PolynomialPolygon::contains_origin_at(PolynomialRoot& t) const {
  if (is_zero_at(normal_, t)) return segment_contains_origin_at(t);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (sign_at(side(i), t) == Sign::negative) return false;
  return true;
}

/// For corners that always lie in one line: the line contains the origin where the cross products vanish, and then the
/// origin enters the segment at an end, or when this is a point.
void PolynomialPolygon::add_products(std::vector<IntegerPolynomial>& found) const {
  const std::size_t count = corners_.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (const IntegerPolynomial& along_axis : cross(corners_[i], corners_[j])) {
        if (along_axis.is_zero()) continue;
        found = {along_axis};
        return;
      }
      found.push_back(dot(corners_[i], corners_[j]));
    }
  }
}

/// A first contact that is not at 0 is a root of one of these, and at their roots the origin lies in the plane.
std::vector<IntegerPolynomial> PolynomialPolygon::polynomials_of_candidates() const {
  if (!volume_.is_zero()) return {volume_};
  std::vector<IntegerPolynomial> found;
  if (is_zero(normal_)) {
    add_products(found);
    return found;
  }
  // The origin always lies in the plane. It enters over an edge, or when the polygon has become a segment.
  for (const IntegerPolynomial& along_axis : normal_) {
    if (along_axis.is_zero()) continue;
    found.push_back(along_axis);
    break;
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) found.push_back(side(i));
  return found;
}

std::optional<ContactCell> PolynomialPolygon::first_contact() {
  PolynomialRoot start{nullptr, {}, true, Sign::zero};
  if (sign_at(volume_, start) == Sign::zero && contains_origin_at(start)) return ContactCell{};
  std::optional<ContactCell> first;
  for (IntegerPolynomial& candidate : polynomials_of_candidates()) {
    if (candidate.is_zero()) continue;
    for (PolynomialRoot& root : roots_in_unit_interval(candidate)) {
      const ContactCell cell = contact_cell(root);
      if (first && !(cell < *first)) break;
      if (!contains_origin_at(root)) continue;
      first = cell;
      break;
    }
  }
  return first;
}

}  // namespace

std::optional<TimeOfImpact> time_of_impact_by_integers(std::span<const MovingCorner> polygon) {
  const std::optional<ContactCell> cell = PolynomialPolygon(corners_of(polygon)).first_contact();
  return cell ? std::optional(told(*cell)) : std::nullopt;
}

}  // namespace toccata
