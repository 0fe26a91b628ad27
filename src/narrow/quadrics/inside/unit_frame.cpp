#include "narrow/quadrics/inside/unit_frame.hpp"

#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

/// constant + 2 linear · w + w · square w, for w of some dimensions.
struct QuadraticForm {
  std::array<std::array<BoundedNumber, 3>, 3> square;
  std::array<BoundedNumber, 3> linear;
  BoundedNumber constant;
  std::size_t dimensions = 0;
};

/// The form of the quadric, less its level, at the points of a generator.
QuadraticForm form_of(const UnitFrame& shape, const UnitGenerator& generator) {
  const BoundedNumber last = exactly(shape.last_sign());
  const auto product = [&](const BoundedVector& u, const BoundedVector& v) {
    return (u[0] * v[0] + u[1] * v[1]) + last * (u[2] * v[2]);
  };
  QuadraticForm form;
  form.dimensions = generator.columns;
  form.constant = product(generator.centre, generator.centre) - exactly(shape.level());
  for (std::size_t j = 0; j < generator.columns; ++j) {
    form.linear[j] = product(generator.column[j], generator.centre);
    for (std::size_t k = 0; k <= j; ++k)
      form.square[j][k] = form.square[k][j] = product(generator.column[j], generator.column[k]);
  }
  return form;
}

/// By elimination: all pivots are.
template <std::size_t size>
bool is_positive_definite(std::array<std::array<BoundedNumber, size>, size> m, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    if (!m[k][k].is_positive()) return false;
    for (std::size_t i = k + 1; i < count; ++i) {
      const BoundedNumber part = m[i][k] / m[k][k];
      for (std::size_t j = k + 1; j < count; ++j) m[i][j] = m[i][j] - part * m[k][j];
    }
  }
  return true;
}

/// λ(|w|² − 1) less the form is positive for all w.
bool is_below(const QuadraticForm& form, double multiplier) {
  if (!(multiplier >= 0 && std::isfinite(multiplier))) return false;
  const std::size_t n = form.dimensions;
  const BoundedNumber lambda = exactly(multiplier);
  std::array<std::array<BoundedNumber, 4>, 4> m;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) m[j][k] = j == k ? lambda - form.square[j][k] : -form.square[j][k];
    m[j][n] = m[n][j] = -form.linear[j];
  }
  m[n][n] = -form.constant - lambda;
  return is_positive_definite(m, n + 1);
}

/// Where in the ball |w| ≤ 1 a form is greatest, and the multiplier that shows it, both rounded.
struct Greatest {
  double multiplier = 0;
  Vec3 at;
};

/// For w = Σ wᵢ axisᵢ of the eigenvectors, wᵢ = gᵢ / (λ − Gᵢ), and λ is at least the greatest eigenvalue and 0; there,
/// where |w| < 1 for all such λ, the rest of w lies along its axis (J. J. Moré, D. C. Sorensen, "Computing a trust
/// region step", 1983).
class GreatestOnBall {
 public:
  GreatestOnBall(const Mat3& square, const Vec3& linear)
      : eigen_(symmetric_eigen(square)),
        along_{dot(eigen_.axes[0], linear), dot(eigen_.axes[1], linear), dot(eigen_.axes[2], linear)},
        least_(std::fmax(eigen_.values.x, 0)) {}

  [[nodiscard]] Greatest found() const {
    double above = 0;
    if (squared_length(at(0)) > 1) {
      double low = 0;
      above = std::sqrt(dot(along_, along_)) * (1 + 0x1p-50);
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + above);
        (squared_length(at(middle)) > 1 ? low : above) = middle;
      }
    }
    // Beyond what the eigenvalues are off by.
    const double slack = 0x1p-48 * std::fmax(std::fabs(eigen_.values.x), std::fabs(eigen_.values.z));
    return {(least_ + above) + slack, on_axes(filled(at(above)))};
  }

 private:
  static double squared_length(const Vec3& v) { return dot(v, v); }

  [[nodiscard]] Vec3 at(double above) const {
    Vec3 w;
    for (int i = 0; i < 3; ++i) {
      const double by = above + (least_ - eigen_.values[i]);
      if (along_[i] != 0) w[i] = along_[i] / by;
    }
    return w;
  }

  [[nodiscard]] Vec3 filled(Vec3 w) const {
    const double squared = squared_length(w);
    if (squared > 1) return (1 / std::sqrt(squared)) * w;
    if (least_ > 0) w.x = std::copysign(std::sqrt(std::fmax(1 - w.y * w.y - w.z * w.z, 0)), along_.x);
    return w;
  }

  [[nodiscard]] Vec3 on_axes(const Vec3& w) const {
    return (w.x * eigen_.axes[0] + w.y * eigen_.axes[1]) + w.z * eigen_.axes[2];
  }

  SymmetricEigen eigen_;
  Vec3 along_;
  double least_;
};

bool is_usable(double x) { return std::fabs(x) < 0x1p490; }

std::optional<Greatest> greatest_of(const QuadraticForm& form) {
  Mat3 square;
  Vec3 linear;
  for (int j = 0; j < 3; ++j) square[j] = {0, 0, 0};
  for (std::size_t j = 0; j < form.dimensions; ++j) {
    linear[static_cast<int>(j)] = middle(form.linear[j]);
    for (std::size_t k = 0; k < form.dimensions; ++k)
      square[static_cast<int>(j)][static_cast<int>(k)] = middle(form.square[j][k]);
  }
  for (int j = 0; j < 3; ++j)
    if (!is_usable(linear[j]) || !is_usable(largest_magnitude(square[j]))) return {};
  return GreatestOnBall(square, linear).found();
}

/// A little within the ball, so that it certainly is. With u = 2⁻⁵³, the point's length on the axes is off by 5 u, what
/// the axes are off by in lengths and angles makes 16 u of it, and sums of three products 6 u; 64 u are taken off.
BoundedNumber value_at(const QuadraticForm& form, const Vec3& at) {
  const Vec3 w = (1 - 0x1p-47) * at;
  BoundedNumber value = form.constant;
  for (std::size_t j = 0; j < form.dimensions; ++j) {
    BoundedNumber across = exactly(2) * form.linear[j];
    for (std::size_t k = 0; k < form.dimensions; ++k)
      across = across + exactly(w[static_cast<int>(k)]) * form.square[j][k];
    value = value + exactly(w[static_cast<int>(j)]) * across;
  }
  return value;
}

Within is_held_by_quadric(const QuadraticForm& form) {
  if (form.dimensions == 0) return from_sign(form.constant);
  if (form.constant.is_positive()) return Within::no;
  const std::optional<Greatest> greatest = greatest_of(form);
  if (!greatest) return Within::undecided;
  if (is_below(form, greatest->multiplier)) return Within::yes;
  return value_at(form, greatest->at).is_positive() ? Within::no : Within::undecided;
}

/// The planes of the caps, and of a tip, on whose side the shape lies.
Within is_held_by_planes(const UnitFrame& shape, const UnitGenerator& generator) {
  if (shape.caps() == 0) return Within::yes;
  BoundedNumber squared = exactly(0);
  for (std::size_t j = 0; j < generator.columns; ++j)
    squared = squared + generator.column[j][2] * generator.column[j][2];
  const BoundedNumber reach = root_of_squares(squared), &at = generator.centre[2];
  return with_kind(shape.kind(), [&](auto kind) {
    Within all = Within::yes;
    for (const BoundedNumber& excess : kind.beyond_planes(at, reach)) all = both(all, from_sign(excess));
    return all;
  });
}

}  // namespace

UnitFrame::UnitFrame(const QuadricBody& shape) : kind_(*shape.quadric_kind()), origin_(shape.middle_point()) {
  with_kind(kind_, [&](auto kind) {
    last_sign_ = kind.last_sign;
    level_ = kind.level;
    caps_ = kind.caps;
  });
  const std::array<BoundedVector, 3>& axis = shape.axes();
  const BoundedVector across = cross(axis[1], axis[2]);
  const BoundedNumber part = exactly(1) / dot(across, axis[0]);
  row_ = {part * across, part * cross(axis[2], axis[0]), part * cross(axis[0], axis[1])};
  if (!shape.has_tip()) return;
  // From the tip to the middle of the base it is minus two half heights.
  origin_ = origin_ + axis[2];
  row_[2] = exactly(-0.5) * row_[2];
}

UnitGenerator UnitFrame::generator(const QuadricBody& body, Index number) const {
  UnitGenerator generator;
  generator.centre = placed(body.centre(number));
  generator.columns = body.grown(number) ? body.column_count() : 0;
  for (std::size_t j = 0; j < generator.columns; ++j) generator.column[j] = turned(body.column(j));
  return generator;
}

UnitGenerator UnitFrame::ball(const BoundedVector& centre, double radius) const {
  UnitGenerator generator;
  generator.centre = placed(centre);
  generator.columns = 3;
  for (std::size_t j = 0; j < 3; ++j)
    generator.column[j] = exactly(radius) * BoundedVector{row_[0][j], row_[1][j], row_[2][j]};
  return generator;
}

Within is_held(const UnitFrame& shape, const UnitGenerator& generator) {
  const Within by_planes = is_held_by_planes(shape, generator);
  return by_planes == Within::no ? by_planes : both(by_planes, is_held_by_quadric(form_of(shape, generator)));
}

bool is_held_by(const UnitFrame& shape, const UnitGenerator& generator, double multiplier) {
  return is_held_by_planes(shape, generator) == Within::yes && is_below(form_of(shape, generator), multiplier);
}

Within is_held(const UnitFrame& shape, const QuadricBody& other) {
  Within all = Within::yes;
  for (Index i = 0; i < other.generator_count() && all != Within::no; ++i)
    all = both(all, is_held(shape, shape.generator(other, i)));
  return all;
}

}  // namespace toccata
