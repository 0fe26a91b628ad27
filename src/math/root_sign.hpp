#pragma once

#include "math/wide_integer.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

[[nodiscard]] inline Sign sign_of_integer(const WideInteger& value) { return static_cast<Sign>(value.sign()); }

/// The sign of plain + coefficient · √radicand, for a radicand that is not negative.
[[nodiscard]] inline Sign root_sum_sign(const WideInteger& plain, const WideInteger& coefficient,
                                        const WideInteger& radicand) {
  const int root = radicand.is_zero() ? 0 : coefficient.sign(), rest = plain.sign();
  if (rest * root >= 0) return static_cast<Sign>(rest != 0 ? rest : root);
  // They pull in opposite directions; the greater square wins.
  const int larger = WideInteger(plain * plain).compare(coefficient * coefficient * radicand);
  return static_cast<Sign>(larger == 0 ? 0 : larger > 0 ? rest : root);
}

}  // namespace toccata
