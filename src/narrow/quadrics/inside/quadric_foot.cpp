#include "narrow/quadrics/inside/quadric_foot.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/quadrics/inside/word_eigen.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata {
namespace {

/// The matrix S of the quadric x · S x = level, as seen from its origin.
std::array<FineVector, 3> quadric_of(const UnitFrame& shape) {
  std::array<FineVector, 3> matrix{};
  const std::array<double, 3> sign{1, 1, shape.last_sign()};
  for (std::size_t i = 0; i < 3; ++i) {
    const FineVector row = vector_as<DoubleWord>(shape.row(i));
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) matrix[j][k] = matrix[j][k] + (row[j] * row[k]) * sign[i];
  }
  return matrix;
}

/// The nearest point x of the quadric to q is that with x − q = μ S x and a μ for which 1 − μ S has no negative
/// eigenvalue: along the eigenvectors, xᵢ = qᵢ / (1 − μ κᵢ), and from within, 0 ≤ μ ≤ 1 / κ₁ of the greatest κ. What is
/// looked for is t = 1 − μ κ₁, at which Σ κᵢ xᵢ² is the level. That grows as t falls. Where it is still less at t = 0,
/// the rest of x lies along the first eigenvector, on either side: the point is as far from both.
class FootSearch {
 public:
  FootSearch(const WordEigen& eigen, const FineVector& seen, double level) : eigen_(eigen), level_(level) {
    for (std::size_t i = 0; i < 3; ++i) {
      at_[i] = inner(eigen.axis[i], seen);
      ratio_[i] = eigen.value[i] / eigen.value[0];
      rest_[i] = (eigen.value[0] - eigen.value[i]) / eigen.value[0];
    }
  }

  /// Along the eigenvectors.
  [[nodiscard]] FineVector foot() {
    if (excess<double>(0).value < 0) {
      t_ = {0, 0};
      FineVector x = at<DoubleWord>(t_);
      x[0] = root_of(-excess<DoubleWord>(t_).value / eigen_.value[0]);
      return x;
    }
    t_ = {searched(), 0};
    for (int step = 0; step < 2; ++step) {
      const auto now = excess<DoubleWord>(t_);
      const DoubleWord next = t_ - now.value / now.slope;
      if (next.high > 0 && next.high <= 1) t_ = next;
    }
    return at<DoubleWord>(t_);
  }

  /// 1 − t, which is μ κ₁.
  [[nodiscard]] DoubleWord far() const { return DoubleWord{1, 0} - t_; }

 private:
  template <class Number>
  struct Excess {
    Number value;
    Number slope;
  };

  template <class Number>
  [[nodiscard]] VectorOf<Number> at(const Number& t) const {
    VectorOf<Number> x{};
    for (std::size_t i = 0; i < 3; ++i)
      if (at_[i].high != 0)
        x[i] = number_as<Number>(at_[i]) / (number_as<Number>(rest_[i]) + number_as<Number>(ratio_[i]) * t);
    return x;
  }

  template <class Number>
  [[nodiscard]] Excess<Number> excess(const Number& t) const {
    const VectorOf<Number> x = at<Number>(t);
    Excess<Number> sum{number_as<Number>(-level_), number_as<Number>(0.0)};
    for (std::size_t i = 0; i < 3; ++i) {
      if (at_[i].high == 0) continue;
      const Number part = number_as<Number>(eigen_.value[i]) * (x[i] * x[i]), ratio = number_as<Number>(ratio_[i]);
      sum.value = sum.value + part;
      sum.slope = sum.slope - number_as<Number>(2.0) * (part * ratio) / (number_as<Number>(rest_[i]) + ratio * t);
    }
    return sum;
  }

  /// In doubles, by halving what is left: its logarithm first.
  [[nodiscard]] double searched() const {
    double low = 0x1p-400, high = 1;
    for (int step = 0; step < 80; ++step) {
      const double middle = high > 2 * low ? std::sqrt(low) * std::sqrt(high) : 0.5 * (low + high);
      (excess<double>(middle).value > 0 ? low : high) = middle;
    }
    return high;
  }

  const WordEigen& eigen_;
  double level_;
  FineVector at_, ratio_, rest_;
  DoubleWord t_{};
};

bool is_finite(const FineVector& v) {
  return std::all_of(v.begin(), v.end(), [](const DoubleWord& x) { return std::isfinite(x.high); });
}

FineVector in_frame(const WordEigen& eigen, const FineVector& along) {
  FineVector v{};
  for (std::size_t i = 0; i < 3; ++i) v = sum(v, multiple(along[i], eigen.axis[i]));
  return v;
}

/// S x, across a straight line of the round side exactly: the whole of it is as high.
FineVector normal_at(const UnitFrame& shape, const FineVector& x) {
  FineVector y;
  for (std::size_t i = 0; i < 3; ++i) y[i] = inner(vector_as<DoubleWord>(shape.row(i)), x);
  with_kind(shape.kind(), [&](auto kind) { kind.turn_to_normal(y); });
  FineVector normal{};
  for (std::size_t i = 0; i < 3; ++i) normal = sum(normal, multiple(y[i], vector_as<DoubleWord>(shape.row(i))));
  return normal;
}

}  // namespace

std::optional<QuadricFoot> quadric_foot(const UnitFrame& shape, const BoundedVector& point) {
  const WordEigen eigen = word_eigen(quadric_of(shape));
  if (!(eigen.value[0].high > 0)) return {};
  FootSearch search(eigen, vector_as<DoubleWord>(point - shape.origin()), shape.level());
  const FineVector along = search.foot(), x = in_frame(eigen, along), normal = normal_at(shape, x);
  const double squared = inner(normal, normal).high;
  if (!is_finite(x) || !is_finite(normal) || !(squared > 0)) return {};
  return QuadricFoot{x, normal, squared * (search.far() / eigen.value[0]).high};
}

}  // namespace toccata
