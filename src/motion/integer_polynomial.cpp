#include "motion/integer_polynomial.hpp"

#include <algorithm>
#include <limits>

namespace toccata {
namespace {

/// How many signs an interval's polynomial changes, and its first sign that is not zero. By the rule of Descartes there
/// are as many roots within the interval as changes, or fewer by an even number.
struct SignChanges {
  int count = 0;
  Sign first = Sign::zero;
};

using Coefficients = std::array<WideInteger, IntegerPolynomial::capacity>;

/// p(x) becomes p(x + shift).
void taylor_shift(Coefficients& p, std::size_t size, const WideInteger& shift) {
  for (std::size_t i = 0; i + 1 < size; ++i)
    for (std::size_t j = size - 1; j-- > i;) p[j] += shift * p[j + 1];
}

void taylor_shift_by_one(Coefficients& p, std::size_t size) {
  for (std::size_t i = 0; i + 1 < size; ++i)
    for (std::size_t j = size - 1; j-- > i;) p[j] += p[j + 1];
}

/// The signs of the Bernstein coefficients over a cell, from its start to its end. They are those of
/// (1 + x)^n p(1 / (1 + x)), where p is the polynomial in the fraction of the cell (times 2^(n level)).
SignChanges sign_changes(const IntegerPolynomial& a, const DyadicCell& cell) {
  const std::size_t size = a.size();
  Coefficients p;
  for (std::size_t i = 0; i < size; ++i) p[i] = a[i] << static_cast<unsigned>((size - 1 - i) * cell.level);
  if (cell.index != 0) taylor_shift(p, size, cell.index);
  std::reverse(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(size));
  taylor_shift_by_one(p, size);
  SignChanges changes;
  Sign last = Sign::zero;
  for (std::size_t i = size; i-- > 0;) {
    const Sign sign = sign_of(p[i]);
    if (sign == Sign::zero) continue;
    if (last == Sign::zero) changes.first = sign;
    changes.count += last != Sign::zero && sign != last;
    last = sign;
  }
  return changes;
}

void add_start_if_root(const IntegerPolynomial& a, const DyadicCell& cell, std::vector<PolynomialRoot>& found) {
  if (sign_at_start(a, cell) == Sign::zero) found.push_back({&a, cell, true, Sign::zero});
}

/// The roots in the interior of a cell. Stops where two may lie together in a cell of the deepest level, and says so;
/// what has no multiple root needs no limit.
bool isolate(const IntegerPolynomial& a, const DyadicCell& cell, unsigned deepest, std::vector<PolynomialRoot>& found) {
  const SignChanges changes = sign_changes(a, cell);
  if (changes.count == 1) found.push_back({&a, cell, false, changes.first});
  if (changes.count < 2) return true;
  if (cell.level == deepest) return false;
  if (!isolate(a, cell.first_half(), deepest, found)) return false;
  add_start_if_root(a, cell.second_half(), found);
  return isolate(a, cell.second_half(), deepest, found);
}

}  // namespace

IntegerPolynomial::IntegerPolynomial(const WideInteger& start, const WideInteger& end) : size_(2) {
  coefficients_[0] = start;
  coefficients_[1] = end - start;
  trim();
}

void IntegerPolynomial::trim() {
  while (size_ > 0 && coefficients_[size_ - 1].is_zero()) --size_;
}

IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (a.size_ < b.size_) return b + a;
  IntegerPolynomial sum = a;
  for (std::size_t i = 0; i < b.size_; ++i) sum.coefficients_[i] += b.coefficients_[i];
  sum.trim();
  return sum;
}

IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial difference = a;
  for (; difference.size_ < b.size_; ++difference.size_) difference.coefficients_[difference.size_] = 0;
  for (std::size_t i = 0; i < b.size_; ++i) difference.coefficients_[i] -= b.coefficients_[i];
  difference.trim();
  return difference;
}

IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  IntegerPolynomial product;
  if (a.is_zero() || b.is_zero()) return product;
  product.size_ = a.size_ + b.size_ - 1;
  for (std::size_t i = 0; i < a.size_; ++i)
    for (std::size_t j = 0; j < b.size_; ++j) product.coefficients_[i + j] += a.coefficients_[i] * b.coefficients_[j];
  return product;
}

IntegerPolynomial derivative(const IntegerPolynomial& a) {
  IntegerPolynomial result;
  for (std::size_t i = 1; i < a.size_; ++i) result.coefficients_[i - 1] = a.coefficients_[i] * i;
  result.size_ = a.size_ == 0 ? 0 : a.size_ - 1;
  return result;
}

/// That of a times the leading coefficient of b to the power 1 + (degree of a − degree of b), so that all stays whole.
IntegerPolynomial remainder(IntegerPolynomial a, const IntegerPolynomial& b) {
  for (std::size_t steps = a.size_ < b.size_ ? 0 : a.size_ - b.size_ + 1; steps > 0; --steps) {
    const bool is_reduced = a.size_ < b.size_;
    const std::size_t shift = is_reduced ? 0 : a.size_ - b.size_;
    const WideInteger leading = is_reduced ? WideInteger(0) : a.leading();
    for (std::size_t i = 0; i < a.size_; ++i) a.coefficients_[i] *= b.leading();
    if (is_reduced) continue;
    for (std::size_t i = 0; i < b.size_; ++i) a.coefficients_[i + shift] -= leading * b.coefficients_[i];
    a.trim();
  }
  return a;
}

IntegerPolynomial divided(IntegerPolynomial a, const WideInteger& divisor) {
  for (std::size_t i = 0; i < a.size_; ++i) a.coefficients_[i] /= divisor;
  return a;
}

/// Up to a factor, where b divides a.
IntegerPolynomial quotient(IntegerPolynomial a, const IntegerPolynomial& b) {
  IntegerPolynomial result;
  result.size_ = a.size_ - b.size_ + 1;
  while (a.size_ >= b.size_) {
    const std::size_t shift = a.size_ - b.size_;
    const WideInteger leading = a.leading();
    for (std::size_t i = 0; i < a.size_; ++i) a.coefficients_[i] *= b.leading();
    for (std::size_t i = 0; i < result.size_; ++i) result.coefficients_[i] *= b.leading();
    for (std::size_t i = 0; i < b.size_; ++i) a.coefficients_[i + shift] -= leading * b.coefficients_[i];
    result.coefficients_[shift] = leading;
    a.trim();
  }
  return result;
}

IntegerPolynomial primitive(IntegerPolynomial a) {
  WideInteger divisor = 0;
  for (std::size_t i = a.size_; i-- > 0 && divisor != 1;) divisor = gcd(divisor, a.coefficients_[i]);
  if (divisor > 1)
    for (std::size_t i = 0; i < a.size_; ++i) a.coefficients_[i] /= divisor;
  return a;
}

/// The common divisor by subresultants: every remainder is divided by a number that certainly divides it (W. S. Brown,
/// J. F. Traub, "On Euclid's algorithm and the theory of subresultants", 1971).
IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  const bool is_ordered = a.size() >= b.size();
  IntegerPolynomial large = is_ordered ? a : b, small = is_ordered ? b : a;
  WideInteger leading = 1, factor = 1;
  while (!small.is_zero()) {
    const auto drop = static_cast<unsigned>(large.size() - small.size());
    const IntegerPolynomial rest = divided(remainder(large, small), leading * pow(factor, drop));
    large = small;
    small = rest;
    leading = large.leading();
    if (drop > 0) factor = pow(leading, drop) / pow(factor, drop - 1);
  }
  return large;
}

IntegerPolynomial square_free(const IntegerPolynomial& a) {
  if (a.size() < 3) return a;
  const IntegerPolynomial divisor = common_divisor(a, derivative(a));
  return divisor.size() == 1 ? a : primitive(quotient(a, divisor));
}

Sign sign_at_start(const IntegerPolynomial& a, const DyadicCell& cell) {
  WideInteger value = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (!value.is_zero()) value *= cell.index;
    value += a[i] << static_cast<unsigned>((a.size() - 1 - i) * cell.level);
  }
  return sign_of(value);
}

void PolynomialRoot::narrow() {
  if (is_start) return;
  const DyadicCell half = cell.second_half();
  const Sign middle = sign_at_start(*polynomial, half);
  is_start = middle == Sign::zero;
  cell = middle == Sign::zero || middle == before ? half : cell.first_half();
}

std::vector<PolynomialRoot> roots_in_unit_interval(IntegerPolynomial& polynomial) {
  // Few simple roots lie nearer to each other.
  constexpr unsigned deepest_at_first = 12;
  const DyadicCell all{}, after_all{1, 0};
  std::vector<PolynomialRoot> found;
  add_start_if_root(polynomial, all, found);
  if (!isolate(polynomial, all, deepest_at_first, found)) {
    found.clear();
    polynomial = square_free(polynomial);
    add_start_if_root(polynomial, all, found);
    isolate(polynomial, all, std::numeric_limits<unsigned>::max(), found);
  }
  add_start_if_root(polynomial, after_all, found);
  return found;
}

Sign sign_at(const IntegerPolynomial& a, PolynomialRoot& root) {
  if (a.is_zero()) return Sign::zero;
  if (root.is_start) return sign_at_start(a, root.cell);
  // From this level on nothing but a common root is likely to keep the sign from being seen.
  constexpr unsigned suspicious_level = 24;
  for (bool is_common_possible = true;; root.narrow()) {
    if (root.is_start) return sign_at_start(a, root.cell);
    const SignChanges changes = sign_changes(a, root.cell);
    if (changes.count == 0) return changes.first;
    if (!is_common_possible || root.cell.level < suspicious_level) continue;
    // In the cell the polynomial has this root alone, which is simple, and so may the divisor: then its changes are
    // odd.
    const IntegerPolynomial divisor = common_divisor(*root.polynomial, a);
    if (divisor.size() > 1 && sign_changes(divisor, root.cell).count % 2 == 1) return Sign::zero;
    is_common_possible = false;
  }
}

PolynomialVector operator-(const PolynomialVector& u, const PolynomialVector& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}

IntegerPolynomial dot(const PolynomialVector& u, const PolynomialVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

PolynomialVector cross(const PolynomialVector& u, const PolynomialVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

}  // namespace toccata
