#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

/// What is told of them, as numbers; of one number both ends are that.
std::pair<double, double> told_bracket(double lower, double upper) {
  const std::string text = bracket_text(lower, upper);
  const std::size_t between = text.find(" to ");
  const std::string most = between == std::string::npos ? text : text.substr(between + 4);
  return {std::stod(text), std::stod(most)};
}

// The page tells them by the same cases (tests/viewer/check_clashes.py).
TEST(BracketText, TellsOneNumberOrBothRoundedOutward) {
  std::ifstream file(TOCCATA_BRACKET_TEXTS);
  const nlohmann::json cases = nlohmann::json::parse(file);
  ASSERT_GT(cases.size(), 10U);
  for (const nlohmann::json& one : cases)
    EXPECT_EQ(bracket_text(one["lower"].get<double>(), one["upper"].get<double>()), one["text"].get<std::string>());
}

TEST(BracketText, HoldsWhatTheBracketHolds) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> decade(-9, 9), share(0, 1);
  int brackets = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double upper = std::pow(10, decade(random));
    const double width = upper * std::pow(10, -9 * share(random)), lower = upper - width;
    const auto [least, most] = told_bracket(lower, upper);
    if (least == most) {
      EXPECT_LE(std::abs(upper - most), 5.1e-6 * upper) << lower << " " << upper;
      continue;
    }
    ++brackets;
    EXPECT_LE(least, lower * (1 + 2e-9)) << lower << " " << upper;
    EXPECT_GE(most, upper * (1 - 2e-9)) << lower << " " << upper;
    EXPECT_LE(most - least, 1.21 * width + 2.1e-5 * upper) << lower << " " << upper;
  }
  EXPECT_GT(brackets, 5'000);
}

TEST(BracketText, OfWhatIsBeyondTheDoublesTheEndIsToldThatIsKnown) {
  const double infinity = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();
  EXPECT_EQ(bracket_text(0.5, infinity), "at least 0.5");
  EXPECT_EQ(bracket_text(most, infinity), "at least 1.79769e+308");
  EXPECT_EQ(bracket_text(0.5, most), "0.5 to 1.79769313486e+308");
  EXPECT_EQ(bracket_text(5e-324, 1e-320), "0 to 1e-300");
  EXPECT_EQ(bracket_text(infinity, infinity), "inf");
}

TEST(BracketText, ABoundAloneIsRoundedToItsSide) {
  EXPECT_EQ(upper_bound_text(0.1), "0.1");
  EXPECT_EQ(lower_bound_text(0.1), "0.1");
  EXPECT_EQ(upper_bound_text(0.10000001), "0.100001");
  EXPECT_EQ(upper_bound_text(0.050000000000455014), "0.05");
  EXPECT_EQ(lower_bound_text(0.049999999992674383), "0.05");
  EXPECT_EQ(lower_bound_text(0.09999999), "0.0999999");
  EXPECT_EQ(upper_bound_text(0.000171234, 2), "0.00018");
  EXPECT_EQ(upper_bound_text(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace toccata
