#pragma once

namespace toccata::io {

enum class NumberFault {
  none,
  not_a_number,  ///< no decimal number starts here; "nan", "inf" and hexadecimal numbers are none
  too_large,     ///< the nearest double is infinite
};

struct ParsedNumber {
  double value = 0;
  const char* end = nullptr;  ///< one past the last character of the number; its start where there is none
  NumberFault fault = NumberFault::none;
};

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The double nearest to the decimal number at the start of [first, last): an optional sign, digits with or without a
/// point, an optional exponent. Ties go to even, what is too small becomes zero of its sign, the locale is ignored.
[[nodiscard]] ParsedNumber parse_number(const char* first, const char* last) noexcept;

}  // namespace toccata::io
