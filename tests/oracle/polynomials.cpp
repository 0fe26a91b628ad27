#include "oracle/polynomials.hpp"

#include <algorithm>
#include <optional>

namespace toccata::oracle {
namespace {

/// The remainder of a by b, times a positive number.
Polynomial positive_remainder(const Polynomial& a, const Polynomial& b) {
  std::vector<Rational> rest = a.coefficients();
  const std::vector<Rational>& by = b.coefficients();
  const Rational factor = abs(b.leading());
  while (rest.size() >= by.size()) {
    const Rational share = b.leading().sign() < 0 ? rest.back() : -rest.back();
    rest.pop_back();
    const std::size_t shift = rest.size() + 1 - by.size();
    for (std::size_t i = 0; i < rest.size(); ++i) {
      rest[i] *= factor;
      if (i >= shift) rest[i] += share * by[i - shift];
    }
    while (!rest.empty() && rest.back().is_zero()) rest.pop_back();
  }
  return primitive(Polynomial(std::move(rest)));
}

Polynomial quotient(Polynomial a, const Polynomial& b) {
  std::vector<Rational> result(static_cast<std::size_t>(std::max(0, a.degree() - b.degree())) + 1);
  while (a.degree() >= b.degree()) {
    std::vector<Rational> shift(static_cast<std::size_t>(a.degree() - b.degree()) + 1);
    shift.back() = a.leading() / b.leading();
    result[shift.size() - 1] = shift.back();
    a = a - Polynomial(shift) * b;
  }
  return Polynomial(std::move(result));
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
  explicit RootCounter(const Polynomial& a) : sequence_(sturm_sequence(primitive(a))) {
    // The last of the sequence divides both the polynomial and its derivative.
    if (sequence_.back().degree() > 0) sequence_ = sturm_sequence(primitive(quotient(a, sequence_.back())));
  }
  /// The same roots, each once.
  [[nodiscard]] const Polynomial& polynomial() const { return sequence_.front(); }
  [[nodiscard]] int within(const Rational& lower, const Rational& upper) const {
    return sign_changes(sequence_, lower) - sign_changes(sequence_, upper);
  }

 private:
  std::vector<Polynomial> sequence_;
};

/// Makes the interval half as long, with the root in it, `times` times. The polynomial changes its sign there and
/// nowhere else in the interval.
void halve(AlgebraicNumber& t, int times = 1) {
  int at_upper = t.polynomial.at(t.upper).sign();
  for (int i = 0; i < times; ++i) {
    const Rational middle = (t.lower + t.upper).scaled(-1);
    const int at_middle = t.polynomial.at(middle).sign();
    if (at_middle == 0 || (at_upper != 0 && at_middle == at_upper)) {
      t.upper = middle;
      at_upper = at_middle;
    } else {
      t.lower = middle;
    }
  }
}

void isolate(const RootCounter& counter, const Rational& lower, const Rational& upper,
             std::vector<AlgebraicNumber>& found) {
  const int count = counter.within(lower, upper);
  if (count == 1) {
    found.push_back({counter.polynomial(), lower, upper});
    // So narrow that most questions about it need no more.
    halve(found.back(), 32);
  }
  if (count < 2) return;
  const Rational middle = (lower + upper).scaled(-1);
  isolate(counter, lower, middle, found);
  isolate(counter, middle, upper, found);
}

/// The sign of the polynomial in a whole interval, from bounds of its values there (Horner's scheme in interval
/// arithmetic); 0 where they do not tell. Not for intervals that begin below 0.
int sign_within(const Polynomial& a, const Rational& lower, const Rational& upper) {
  Rational least = 0, most = 0;
  for (std::size_t i = a.coefficients().size(); i-- > 0;) {
    least = least * (least.sign() < 0 ? upper : lower) + a.coefficients()[i];
    most = most * (most.sign() < 0 ? lower : upper) + a.coefficients()[i];
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
  const bool is_a_longer = a.degree() > b.degree();
  std::vector<Rational> sum = is_a_longer ? a.coefficients() : b.coefficients();
  const std::vector<Rational>& shorter = is_a_longer ? b.coefficients() : a.coefficients();
  for (std::size_t i = 0; i < shorter.size(); ++i) sum[i] += shorter[i];
  return Polynomial(std::move(sum));
}

Polynomial operator-(const Polynomial& a) {
  std::vector<Rational> negated = a.coefficients();
  for (Rational& c : negated) c = -c;
  return Polynomial(std::move(negated));
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -b; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  std::vector<Rational> product(static_cast<std::size_t>(a.degree() + b.degree()) + 1);
  for (std::size_t i = 0; i < a.coefficients().size(); ++i)
    for (std::size_t j = 0; j < b.coefficients().size(); ++j)
      product[i + j] += a.coefficients()[i] * b.coefficients()[j];
  return Polynomial(std::move(product));
}

Polynomial derivative(const Polynomial& a) {
  std::vector<Rational> result;
  for (std::size_t i = 1; i < a.coefficients().size(); ++i)
    result.push_back(Rational(static_cast<int>(i)) * a.coefficients()[i]);
  return Polynomial(std::move(result));
}

Polynomial primitive(const Polynomial& a) {
  if (a.is_zero()) return a;
  Integer denominator = 1;
  std::optional<long> least;
  for (const Rational& c : a.coefficients()) {
    if (!c.is_dyadic()) denominator = lcm(denominator, c.denominator());
    if (!c.is_zero()) least = std::min(least.value_or(c.exponent()), c.exponent());
  }
  Integer divisor = 0;
  std::vector<Integer> whole;
  for (const Rational& c : a.coefficients()) {
    const Rational scaled = (c * Rational(denominator)).scaled(-*least);
    whole.push_back(shifted(scaled.numerator(), scaled.exponent()));
    if (divisor != 1) divisor = gcd(divisor, whole.back());
  }
  std::vector<Rational> coefficients;
  for (Integer& c : whole) coefficients.emplace_back(divisor == 1 ? std::move(c) : Integer(c / divisor));
  return Polynomial(std::move(coefficients));
}

Polynomial common_divisor(const Polynomial& a, const Polynomial& b) {
  Polynomial large = primitive(a), small = primitive(b);
  while (!small.is_zero()) {
    Polynomial remainder = positive_remainder(large, small);
    large = std::move(small);
    small = std::move(remainder);
  }
  return large;
}

Polynomial square_free(const Polynomial& a) { return RootCounter(a).polynomial(); }

int roots_within(const Polynomial& a, const Rational& lower, const Rational& upper) {
  return RootCounter(a).within(lower, upper);
}

AlgebraicNumber algebraic(const Rational& value) { return {Polynomial({-value, 1}), value - 1, value}; }

std::vector<AlgebraicNumber> roots_in_unit_interval(const Polynomial& a) {
  std::vector<AlgebraicNumber> found;
  if (a.at(0).is_zero()) found.push_back(algebraic(0));
  if (sign_within(a, 0, 1) == 0) isolate(RootCounter(a), 0, 1, found);
  return found;
}

int sign_at(const Polynomial& a, const AlgebraicNumber& t) {
  if (a.degree() <= 0) return a.at(0).sign();
  if (const int sign = t.lower.sign() < 0 ? 0 : sign_within(a, t.lower, t.upper)) return sign;
  if (t.polynomial.at(t.upper).is_zero()) return a.at(t.upper).sign();
  const Polynomial divisor = common_divisor(a, t.polynomial);
  if (divisor.degree() == t.polynomial.degree()) return 0;
  if (divisor.degree() > 0 && roots_within(divisor, t.lower, t.upper) > 0) return 0;
  const RootCounter counter(a);
  AlgebraicNumber narrow = t;
  while (counter.within(narrow.lower, narrow.upper) > 0) halve(narrow);
  return a.at(narrow.upper).sign();
}

int compared(const AlgebraicNumber& t, const Rational& value) {
  if (value <= t.lower) return 1;
  if (value > t.upper) return -1;
  const int at_value = t.polynomial.at(value).sign(), at_upper = t.polynomial.at(t.upper).sign();
  if (at_value == 0) return 0;
  return at_value == at_upper ? -1 : 1;
}

bool operator<(const AlgebraicNumber& s, const AlgebraicNumber& t) {
  if (s.upper <= t.lower) return true;
  if (t.upper <= s.lower || are_equal(s, t)) return false;
  AlgebraicNumber a = s, b = t;
  while (true) {
    if (a.upper <= b.lower) return true;
    if (b.upper <= a.lower) return false;
    halve(a);
    halve(b);
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
