#include "io/formats/number.hpp"

#include <fast_float/fast_float.h>

#include <cmath>

namespace toccata::io {
namespace {

/// fast_float reads "nan" and "inf" and no leading plus: here it is the other way round.
bool starts_a_decimal(const char* digits, const char* last) {
  return digits != last && (is_digit(*digits) || *digits == '.');
}

}  // namespace

ParsedNumber parse_number(const char* first, const char* last) noexcept {
  const bool is_signed = first != last && (*first == '+' || *first == '-');
  if (!starts_a_decimal(is_signed ? first + 1 : first, last)) return {0, first, NumberFault::not_a_number};

  double value = 0;
  const auto [end, code] = fast_float::from_chars(*first == '+' ? first + 1 : first, last, value);
  if (code == std::errc::invalid_argument) return {0, first, NumberFault::not_a_number};
  // Some versions report an underflow as out of range as well: only an infinite value is an overflow.
  if (!std::isfinite(value)) return {value, end, NumberFault::too_large};
  return {value, end, NumberFault::none};
}

}  // namespace toccata::io
