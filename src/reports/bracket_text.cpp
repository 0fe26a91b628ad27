#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

constexpr int most_digits = 6;

enum class Outward { down, up };

/// The exponent of the greatest power of ten that is no more than x.
int decade_of(double x) { return static_cast<int>(std::floor(std::log10(x))); }

/// A bound with as many digits. The page has the same rule (apps/viewer/src/words.ts).
std::string rounded(double x, int digits, Outward way) {
  constexpr int least_decade = -300;  // of what can be divided by
  constexpr double noise = 1e-9;
  if (!(x > 0)) return "0";
  const double step = std::pow(10, std::max(decade_of(x) - digits + 1, least_decade));
  const double steps = way == Outward::up ? std::ceil(x / step * (1 - noise)) : std::floor(x / step * (1 + noise));
  // Twelve digits hide what the product rounds.
  return fmt::format("{:.12g}", std::min(steps * step, std::numeric_limits<double>::max()));
}

}  // namespace

std::string bracket_text(double lower, double upper) {
  const std::string least = fmt::format("{:.6g}", lower);
  std::string most = fmt::format("{:.6g}", upper);
  if (least == most) return most;
  if (std::isinf(upper)) return "at least " + lower_bound_text(lower);
  const int width = decade_of(upper - lower);
  const auto digits_of = [&](double x) { return x > 0 ? std::clamp(2 + decade_of(x) - width, 2, most_digits) : 1; };
  return rounded(lower, digits_of(lower), Outward::down) + " to " + rounded(upper, digits_of(upper), Outward::up);
}

std::string lower_bound_text(double lower, int digits) {
  return std::isinf(lower) ? fmt::format("{}", lower) : rounded(lower, digits, Outward::down);
}

std::string upper_bound_text(double upper, int digits) {
  return std::isinf(upper) ? fmt::format("{}", upper) : rounded(upper, digits, Outward::up);
}

}  // namespace toccata
