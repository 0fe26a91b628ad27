#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "math/stages.hpp"

namespace toccata {
namespace {

__extension__ using Int128 = __int128;

constexpr int coordinate_bits = 60;

double power_of_two(int exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52); }

int exponent_of(double magnitude) { return static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52) - 1023; }

/// The coordinates along one axis as integers below 2^60 over a common power of two, if they are.
template <std::size_t N>
class CommonScale {
 public:
  explicit CommonScale(const std::array<double, N>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::fabs(value));
    const int exponent = largest == 0 ? 0 : exponent_of(largest);
    if (std::abs(exponent) > 900) return;  // both powers below must be normal
    const double up = power_of_two(coordinate_bits - 1 - exponent), down = power_of_two(exponent + 1 - coordinate_bits);
    fits_ = true;
    for (std::size_t i = 0; i < N; ++i) {
      integers_[i] = static_cast<std::int64_t>(up * values[i]);
      fits_ &= down * static_cast<double>(integers_[i]) == values[i];  // nothing was cut off or underflowed
    }
  }

  [[nodiscard]] bool fits() const { return fits_; }

  /// The difference of two coordinates, at most 2^61.
  [[nodiscard]] std::int64_t difference(std::size_t head, std::size_t tail) const {
    return integers_[head] - integers_[tail];
  }

 private:
  std::array<std::int64_t, N> integers_{};
  bool fits_ = false;
};

/// a·d − b·c.
Int128 determinant_of_integers(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return static_cast<Int128>(a) * d - static_cast<Int128>(b) * c;
}

Sign sign_of_machine_integer(Int128 value) { return static_cast<Sign>((value > 0) - (value < 0)); }

/// A sum of at most three products of an integer up to 2^123 and one up to 2^61, in two parts: high · 2^64 + low. The
/// low part of a factor is below 2^64, so `low` stays below 3 · 2^125.
class WideSum {
 public:
  void add_product(Int128 a, std::int64_t b) {
    high_ += (a >> 64) * b;
    low_ += static_cast<Int128>(static_cast<std::uint64_t>(a)) * b;
  }

  [[nodiscard]] Sign sign() const {
    const Sign upper =
        sign_of_machine_integer(high_ + (low_ >> 64));  // rounded down, so what is left of `low` is not negative
    if (upper != Sign::zero) return upper;
    return static_cast<std::uint64_t>(low_) != 0 ? Sign::positive : Sign::zero;
  }

 private:
  Int128 high_ = 0;
  Int128 low_ = 0;
};

}  // namespace

std::optional<Sign> orient2d_by_machine_integers(const Vec2& a, const Vec2& b, const Vec2& c) {
  const CommonScale<3> x({a.x, b.x, c.x}), y({a.y, b.y, c.y});
  if (!x.fits() || !y.fits()) return std::nullopt;
  return sign_of_machine_integer(
      determinant_of_integers(x.difference(1, 0), y.difference(1, 0), x.difference(2, 0), y.difference(2, 0)));
}

std::optional<Sign> triple_product_sign_by_machine_integers(const Difference& u, const Difference& v,
                                                            const Difference& w) {
  const auto along = [&](double Vec3::*axis) {
    return CommonScale<6>({u.head.*axis, u.tail.*axis, v.head.*axis, v.tail.*axis, w.head.*axis, w.tail.*axis});
  };
  const CommonScale<6> x = along(&Vec3::x), y = along(&Vec3::y), z = along(&Vec3::z);
  if (!x.fits() || !y.fits() || !z.fits()) return std::nullopt;
  const auto minor = [](const CommonScale<6>& p, const CommonScale<6>& q) {
    return determinant_of_integers(p.difference(0, 1), q.difference(0, 1), p.difference(2, 3), q.difference(2, 3));
  };
  WideSum sum;
  sum.add_product(minor(y, z), x.difference(4, 5));
  sum.add_product(minor(z, x), y.difference(4, 5));
  sum.add_product(minor(x, y), z.difference(4, 5));
  return sum.sign();
}

}  // namespace toccata
