#include "io/formats/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace toccata::io {
namespace {

ParsedNumber parsed(const std::string& text) { return parse_number(text.data(), text.data() + text.size()); }

/// The C library's strtod is the oracle; it, too, rounds to nearest.
void expect_like_strtod(const std::string& text) {
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  ASSERT_EQ(*end, '\0') << text;
  const ParsedNumber number = parsed(text);
  if (std::isinf(expected)) {
    EXPECT_EQ(number.fault, NumberFault::too_large) << text;
    return;
  }
  EXPECT_EQ(number.fault, NumberFault::none) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(number.value), std::bit_cast<std::uint64_t>(expected)) << text;
  EXPECT_EQ(number.end, text.data() + text.size()) << text;
}

TEST(Number, EveryWayToWriteADecimalIsRead) {
  for (const char* text :
       {"0",    "-0",        "+0",    "1",   "+1.5", ".5",   "-.5",   "+.5",   "5.",
        "-5.",  "5.e1",      ".5E-1", "1e5", "1E+5", "1e-5", "00012", "000.5", "0e99999999999999999999",
        "-0e5", "0.000e-400"})
    expect_like_strtod(text);
}

TEST(Number, TooSmallBecomesZeroAndTooLargeIsAFault) {
  EXPECT_EQ(parsed("1e-400").fault, NumberFault::none);
  EXPECT_EQ(parsed("1e-400").value, 0);
  EXPECT_TRUE(std::signbit(parsed("-1e-400").value));
  for (const char* text : {"1e400", "-1e400", "1e309", "1.7976931348623159e308", "+1e99999999999999999999"})
    EXPECT_EQ(parsed(text).fault, NumberFault::too_large) << text;
}

TEST(Number, HardCasesAreRoundedLikeStrtod) {
  for (const char* text :
       {"9007199254740993",
        "9007199254740992.99999999999999999999",
        "9007199254740993.00000000000000000001",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.2250738585072014e-308",
        "4.9406564584124654e-324",
        "2.4703282292062327208e-324",
        "2.4703282292062328e-324",
        "2.47032822920623272e-324",
        "1e-323",
        "3e-324",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "8.98846567431158e307",
        "0.1",
        "0.3",
        "1e23",
        "8.5e22",
        "6929495644600919.5",
        "3.7455744005952583e15",
        "1448997445238699",
        "5e-324",
        "123456789012345678901234567890",
        "0.000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000123456789"})
    expect_like_strtod(text);
}

TEST(Number, DigitStringsOfAnyLengthDecideTheTie) {
  // 1 + 2^-53 lies halfway between two doubles: one digit far behind decides.
  const std::string halfway = "1.00000000000000011102230246251565404236316680908203125";
  expect_like_strtod(halfway);
  for (const int zeros : {1, 20, 800, 5000}) {
    expect_like_strtod(halfway + std::string(static_cast<std::size_t>(zeros), '0') + "1");
    expect_like_strtod(halfway + std::string(static_cast<std::size_t>(zeros), '0'));
  }
  expect_like_strtod("0." + std::string(1000, '0') + "5e1000");
  expect_like_strtod(std::string(400, '9') + "e-200");
  expect_like_strtod("1" + std::string(2000, '0') + "e-2000");
}

TEST(Number, WhatIsNoDecimalNumberIsRefused) {
  for (const char* text : {"",    "+",   "-",    ".",   "+.",   "e5",       ".e5", "+-1", "-+1", "--1", "++1",
                           "nan", "NaN", "-nan", "inf", "+inf", "Infinity", "x",   ",5",  "+e1", " 1",  "#"})
    EXPECT_EQ(parsed(text).fault, NumberFault::not_a_number) << text;
}

TEST(Number, TheEndIsWhereTheNumberEnds) {
  const std::string texts[] = {"1x", "1e", "1e+", "1.5.2", "0x10", "1,5", "1-2", "1nan", "1d5", "1f"};
  const std::ptrdiff_t lengths[] = {1, 1, 1, 3, 1, 1, 1, 1, 1, 1};
  for (std::size_t i = 0; i < std::size(texts); ++i)
    EXPECT_EQ(parsed(texts[i]).end - texts[i].data(), lengths[i]) << texts[i];
}

TEST(Number, TheLocaleHasNoSay) {
  const char* comma = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  EXPECT_EQ(parsed("1.5").value, 1.5);
  EXPECT_EQ(parsed("1,5").value, 1);
  if (comma != nullptr) std::setlocale(LC_NUMERIC, "C");
}

}  // namespace
}  // namespace toccata::io
