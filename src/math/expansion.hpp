#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "math/constants.hpp"
#include "toccata/math/predicates.hpp"

// Floating-point expansions (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", 1997, section 2): an exact number as a sum of doubles. Exact as long as nothing under- or overflows.
namespace toccata {

/// A sum of two doubles: the rounded result of an operation and its error.
struct TwoPart {
  double high = 0;
  double low = 0;
};

/// a + b (Knuth).
inline TwoPart two_sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a, a_part = high - b_part;
  return {high, (a - a_part) + (b - b_part)};
}

/// The least double that is not less than a + b, where that does not overflow.
inline double sum_not_less(double a, double b) {
  const TwoPart sum = two_sum(a, b);
  return sum.low <= 0 ? sum.high : std::nextafter(sum.high, infinity);
}

inline TwoPart two_difference(double a, double b) { return two_sum(a, -b); }

/// a + b, for |a| ≥ |b| or a = 0 (Dekker).
inline TwoPart fast_two_sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

/// A double as two of at most 26 bits each (Veltkamp).
inline TwoPart split(double a) {
  const double scaled = 0x1.0000002p27 * a;  // 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// a · b (Dekker). Not by std::fma, which is a slow call where the processor has none.
inline TwoPart two_product(double a, double b) {
  const double high = a * b;
  const TwoPart x = split(a), y = split(b);
  const double rest = ((high - x.high * y.high) - x.low * y.high) - x.high * y.low;
  return {high, x.low * y.low - rest};
}

/// The sum of its components: none of them zero, ordered by growing magnitude, and no two overlapping in their binary
/// digits; so the last has the sign of the sum.
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(const TwoPart& sum) {
    append(sum.low);
    append(sum.high);
  }

  /// Adds a component beyond all present ones; zero adds nothing.
  void append(double component) {
    components_[size_] = component;  // without a branch, which would be mispredicted half of the time
    size_ += component != 0;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return components_[i]; }

  [[nodiscard]] Sign sign() const {
    if (size_ == 0) return Sign::zero;
    return components_[size_ - 1] > 0 ? Sign::positive : Sign::negative;
  }

  [[nodiscard]] Expansion operator-() const {
    Expansion negated;
    for (std::size_t i = 0; i < size_; ++i) negated.append(-components_[i]);
    return negated;
  }

 private:
  std::array<double, Capacity> components_;  // the first size_ are set
  std::size_t size_ = 0;
};

/// The components of two expansions as one sequence of growing magnitude.
template <std::size_t M, std::size_t N>
Expansion<M + N> merged(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> merged;
  std::size_t i = 0, j = 0;
  while (i < e.size() && j < f.size()) {
    const bool from_e = std::fabs(e[i]) < std::fabs(f[j]);
    merged.append(from_e ? e[i] : f[j]);
    i += from_e;
    j += !from_e;
  }
  while (i < e.size()) merged.append(e[i++]);
  while (j < f.size()) merged.append(f[j++]);
  return merged;
}

/// e + f, by Shewchuk's Linear-Expansion-Sum: it needs nothing of its inputs but what every Expansion promises.
/// (Fast-Expansion-Sum is a little cheaper and asks for more.)
template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  const Expansion<M + N> g = merged(e, f);
  if (g.size() < 2) return g;
  Expansion<M + N> sum;
  TwoPart total = fast_two_sum(g[1], g[0]);
  for (std::size_t i = 2; i < g.size(); ++i) {
    const TwoPart carried = fast_two_sum(g[i], total.low);
    sum.append(carried.low);
    total = two_sum(total.high, carried.high);
  }
  sum.append(total.low);
  sum.append(total.high);
  return sum;
}

/// e · b, by Shewchuk's Scale-Expansion.
template <std::size_t M>
Expansion<2 * M> operator*(const Expansion<M>& e, double b) {
  Expansion<2 * M> product;
  if (e.size() == 0 || b == 0) return product;
  TwoPart total = two_product(e[0], b);
  product.append(total.low);
  for (std::size_t i = 1; i < e.size(); ++i) {
    const TwoPart next = two_product(e[i], b);
    const TwoPart sum = two_sum(total.high, next.low);
    product.append(sum.low);
    total = fast_two_sum(next.high, sum.high);
    product.append(total.low);
  }
  product.append(total.high);
  return product;
}

/// e · (a difference of two doubles).
template <std::size_t M>
Expansion<4 * M> operator*(const Expansion<M>& e, const Expansion<2>& f) {
  if (f.size() == 0) return {};
  if (f.size() == 1) return Expansion<2 * M>() + e * f[0];
  return e * f[0] + e * f[1];
}

}  // namespace toccata
