#include "oracle/polynomials.hpp"

#include <algorithm>

namespace toccata::oracle {
namespace {

Rational coefficient(const Polynomial& a, std::size_t power) {
  return power < a.coefficients().size() ? a.coefficients()[power] : Rational(0);
}

/// The polynomial times a positive number such that its coefficients are whole and have no common divisor. Nothing
/// below depends on it but the time.
Polynomial reduced(const Polynomial& a) {
  if (a.is_zero()) return a;
  Integer denominator = 1;
  long least = 0;
  for (const Rational& c : a.coefficients()) {
    denominator = lcm(denominator, c.denominator());
    if (!c.is_zero()) least = std::min(least, c.exponent());
  }
  Integer divisor = 0;
  std::vector<Integer> whole;
  for (const Rational& c : a.coefficients()) {
    const Rational scaled = (c * Rational(denominator)).scaled(-least);
    whole.push_back(shifted(scaled.numerator(), scaled.exponent()));
    divisor = gcd(divisor, whole.back());
  }
  std::vector<Rational> coefficients;
  for (const Integer& c : whole) coefficients.emplace_back(Integer(c / divisor));
  return Polynomial(coefficients);
}

/// The remainder of a by b, times a positive number.
Polynomial positive_remainder(Polynomial a, const Polynomial& b) {
  while (a.degree() >= b.degree()) {
    std::vector<Rational> shift(static_cast<std::size_t>(a.degree() - b.degree()) + 1);
    shift.back() = a.leading() * b.leading();
    const Polynomial square({b.leading() * b.leading()});
    a = square * a - Polynomial(shift) * b;
  }
  return reduced(a);
}

Polynomial quotient(Polynomial a, const Polynomial& b) {
  std::vector<Rational> result(static_cast<std::size_t>(std::max(0, a.degree() - b.degree())) + 1);
  while (a.degree() >= b.degree()) {
    std::vector<Rational> shift(static_cast<std::size_t>(a.degree() - b.degree()) + 1);
    shift.back() = a.leading() / b.leading();
    result[shift.size() - 1] = shift.back();
    a = a - Polynomial(shift) * b;
  }
  return Polynomial(result);
}

/// Sturm's sequence: the polynomial, its derivative, and the remainders with their signs turned.
std::vector<Polynomial> sturm_sequence(const Polynomial& a) {
  std::vector<Polynomial> sequence{a, derivative(a)};
  while (!sequence.back().is_zero())
    sequence.push_back(-positive_remainder(sequence[sequence.size() - 2], sequence.back()));
  sequence.pop_back();
  return sequence;
}

int sign_changes(const std::vector<Polynomial>& sequence, const Rational& t) {
  int changes = 0, last = 0;
  for (const Polynomial& a : sequence) {
    const int sign = a.at(t).sign();
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    last = sign;
  }
  return changes;
}

/// Counts roots by Sturm's theorem.
class RootCounter {
 public:
  explicit RootCounter(const Polynomial& a) : sequence_(sturm_sequence(square_free(a))) {}
  [[nodiscard]] int within(const Rational& lower, const Rational& upper) const {
    return sign_changes(sequence_, lower) - sign_changes(sequence_, upper);
  }

 private:
  std::vector<Polynomial> sequence_;
};

/// Half of the interval, with the root in it. The polynomial changes its sign there and nowhere else in the interval.
AlgebraicNumber halved(const AlgebraicNumber& t) {
  const Rational middle = (t.lower + t.upper).scaled(-1);
  const int at_middle = t.polynomial.at(middle).sign(), at_upper = t.polynomial.at(t.upper).sign();
  if (at_middle == 0 || (at_upper != 0 && at_middle == at_upper)) return {t.polynomial, t.lower, middle};
  return {t.polynomial, middle, t.upper};
}

/// So narrow that most questions about it need no more.
AlgebraicNumber narrowed(AlgebraicNumber t) {
  for (int i = 0; i < 32; ++i) t = halved(t);
  return t;
}

void isolate(const Polynomial& a, const RootCounter& counter, const Rational& lower, const Rational& upper,
             std::vector<AlgebraicNumber>& found) {
  const int count = counter.within(lower, upper);
  if (count == 1) found.push_back(narrowed({a, lower, upper}));
  if (count < 2) return;
  const Rational middle = (lower + upper).scaled(-1);
  isolate(a, counter, lower, middle, found);
  isolate(a, counter, middle, upper, found);
}

/// The sign of the polynomial in the whole interval of a number, from bounds of its values there (Horner's scheme in
/// interval arithmetic); 0 where they do not tell. Not for intervals that begin below 0.
int sign_within(const Polynomial& a, const AlgebraicNumber& t) {
  Rational least = 0, most = 0;
  for (std::size_t i = a.coefficients().size(); i-- > 0;) {
    least = least * (least.sign() < 0 ? t.upper : t.lower) + a.coefficients()[i];
    most = most * (most.sign() < 0 ? t.lower : t.upper) + a.coefficients()[i];
  }
  return least.sign() == most.sign() ? least.sign() : 0;
}

/// Whether the two numbers are one.
bool are_equal(const AlgebraicNumber& s, const AlgebraicNumber& t) {
  const Rational lower = std::max(s.lower, t.lower), upper = std::min(s.upper, t.upper);
  return lower < upper && roots_within(common_divisor(s.polynomial, t.polynomial), lower, upper) > 0;
}

}  // namespace

Polynomial::Polynomial(std::vector<Rational> coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

Rational Polynomial::at(const Rational& t) const {
  Rational value = 0;
  for (std::size_t i = coefficients_.size(); i-- > 0;) value = value * t + coefficients_[i];
  return value;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  std::vector<Rational> sum(std::max(a.coefficients().size(), b.coefficients().size()));
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = coefficient(a, i) + coefficient(b, i);
  return Polynomial(sum);
}

Polynomial operator-(const Polynomial& a) {
  std::vector<Rational> negated = a.coefficients();
  for (Rational& c : negated) c = -c;
  return Polynomial(negated);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Rational> product(static_cast<std::size_t>(a.degree() + b.degree()) + 1);
  for (std::size_t i = 0; i < a.coefficients().size(); ++i)
    for (std::size_t j = 0; j < b.coefficients().size(); ++j)
      product[i + j] += a.coefficients()[i] * b.coefficients()[j];
  return Polynomial(product);
}

Polynomial derivative(const Polynomial& a) {
  std::vector<Rational> result;
  for (std::size_t i = 1; i < a.coefficients().size(); ++i)
    result.push_back(Rational(static_cast<int>(i)) * a.coefficients()[i]);
  return Polynomial(result);
}

Polynomial common_divisor(const Polynomial& a, const Polynomial& b) {
  Polynomial large = reduced(a), small = reduced(b);
  while (!small.is_zero()) {
    const Polynomial remainder = positive_remainder(large, small);
    large = small;
    small = remainder;
  }
  return large;
}

Polynomial square_free(const Polynomial& a) { return reduced(quotient(a, common_divisor(a, derivative(a)))); }

int roots_within(const Polynomial& a, const Rational& lower, const Rational& upper) {
  return RootCounter(a).within(lower, upper);
}

AlgebraicNumber algebraic(const Rational& value) { return {Polynomial({-value, 1}), value - 1, value}; }

std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& a) {
  std::vector<AlgebraicNumber> found;
  if (a.at(0).is_zero()) found.push_back(algebraic(0));
  isolate(square_free(a), RootCounter(a), 0, 1, found);
  return found;
}

int sign_at(const Polynomial& a, const AlgebraicNumber& t) {
  if (a.degree() <= 0) return a.at(0).sign();
  if (const int sign = t.lower.sign() < 0 ? 0 : sign_within(a, t)) return sign;
  if (t.polynomial.at(t.upper).is_zero()) return a.at(t.upper).sign();
  const Polynomial divisor = common_divisor(a, t.polynomial);
  if (divisor.degree() > 0 && roots_within(divisor, t.lower, t.upper) > 0) return 0;
  const RootCounter counter(a);
  AlgebraicNumber narrow = t;
  while (counter.within(narrow.lower, narrow.upper) > 0) narrow = halved(narrow);
  return a.at(narrow.upper).sign();
}

int compared(const AlgebraicNumber& t, const Rational& value) { return sign_at(Polynomial({-value, 1}), t); }

bool operator<(const AlgebraicNumber& s, const AlgebraicNumber& t) {
  if (s.upper <= t.lower) return true;
  if (t.upper <= s.lower || are_equal(s, t)) return false;
  AlgebraicNumber a = s, b = t;
  while (true) {
    if (a.upper <= b.lower) return true;
    if (b.upper <= a.lower) return false;
    a = halved(a);
    b = halved(b);
  }
}

PolynomialVector operator-(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Polynomial dot(const PolynomialVector& a, const PolynomialVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

PolynomialVector cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace toccata::oracle
