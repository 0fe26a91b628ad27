// Decimal numbers against the C library's strtod, which rounds to nearest as well.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "io/formats/number.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

using Random = std::mt19937_64;

bool is_read_like_strtod(const std::string& text) {
  const double expected = std::strtod(text.c_str(), nullptr);
  const io::ParsedNumber number = io::parse_number(text.data(), text.data() + text.size());
  if (number.end != text.data() + text.size()) return false;
  if (std::isinf(expected)) return number.fault == io::NumberFault::too_large;
  return number.fault == io::NumberFault::none &&
         std::bit_cast<std::uint64_t>(number.value) == std::bit_cast<std::uint64_t>(expected);
}

std::string random_digits(Random& random, std::size_t most) {
  std::string digits(1 + random() % most, '0');
  for (char& digit : digits) digit = static_cast<char>('0' + random() % 10);
  return digits;
}

std::string random_exponent(Random& random, int least, int count) {
  const int exponent = least + static_cast<int>(random() % static_cast<unsigned>(count));
  std::string text = random() % 2 == 0 ? "e" : "E";
  if (exponent >= 0 && random() % 2 == 0) text += '+';
  return text + std::to_string(exponent);
}

std::string random_sign(Random& random) {
  constexpr const char* signs[] = {"", "-", "+"};
  return signs[random() % 3];
}

/// As people and programs write numbers, and beyond: ".5", "5.", up to 60 digits, with and without an exponent.
std::string any_decimal(Random& random) {
  const std::size_t most_digits = random() % 8 == 0 ? 60 : 17;
  std::string text = random_sign(random);
  switch (random() % 4) {
    case 0:
      text += random_digits(random, most_digits);
      break;
    case 1:
      text += "." + random_digits(random, most_digits);
      break;
    case 2:
      text += random_digits(random, most_digits) + ".";
      break;
    default:
      text += random_digits(random, most_digits) + ".";
      text += random_digits(random, most_digits);
  }
  return random() % 2 == 0 ? text : text + random_exponent(random, -370, 720);
}

/// Around the middle of two neighbouring doubles: as it is, and a little rounded.
std::string near_halfway(Random& random) {
  const double low = std::bit_cast<double>(random() % std::bit_cast<std::uint64_t>(0x1.fffffffffffffp+1023));
  // A long double has at least one bit more than a double wherever this project is tested with x87 or wider.
  const long double middle =
      (static_cast<long double>(low) + static_cast<long double>(std::nextafter(low, INFINITY))) / 2;
  constexpr const char* formats[] = {"%.1100Lg", "%.40Lg", "%.25Lg", "%.17Lg"};
  char text[1200];
  std::snprintf(text, sizeof text, formats[random() % 4], middle);
  std::string result = text;
  if (random() % 2 == 0 && result.find('e') == std::string::npos && result.find('.') != std::string::npos)
    result += std::string(random() % 900, '0') + "1";
  return random_sign(random) + result;
}

/// Any sign, one digit, a point and up to 30 more; the exponent is one of `count` from `least` on.
std::string scientific(Random& random, int least, int count) {
  std::string text = random_sign(random);
  text += random_digits(random, 1) + ".";
  text += random_digits(random, 30);
  return text + random_exponent(random, least, count);
}

std::string near_underflow(Random& random) { return scientific(random, -326, 22); }

std::string near_overflow(Random& random) { return scientific(random, 305, 5); }

/// Hundreds of digits before or behind the point, brought back to size by the exponent.
std::string long_digits(Random& random) {
  const std::string digits = random_digits(random, 1200);
  const int shift = static_cast<int>(digits.size());
  if (random() % 2 == 0) return digits + random_exponent(random, -shift - 20, 40);
  const std::string zeros(random() % 1000, '0');
  return "0." + zeros + digits + random_exponent(random, -20, 1100);
}

std::string text_of(const std::string& family, Random& random) {
  if (family == "near_halfway") return near_halfway(random);
  if (family == "near_underflow") return near_underflow(random);
  if (family == "near_overflow") return near_overflow(random);
  return family == "long_digits" ? long_digits(random) : any_decimal(random);
}

SweepResult run_number(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random random(seed);
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const std::string text = text_of(family, random);
    if (is_read_like_strtod(text)) continue;
    if (result.wrong++ == 0) result.first_failure = text;
  }
  return result;
}

const bool number_known =
    register_sweep({.name = "numbers",
                    .families = {"any_decimal", "near_halfway", "near_underflow", "near_overflow", "long_digits"},
                    .goal = 10'000'000,
                    .slice = 20'000,
                    .run = run_number});

}  // namespace
}  // namespace toccata::test
