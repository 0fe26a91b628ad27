#include "reports/plots/plot_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/constants.hpp"

namespace toccata::io {
namespace {

constexpr double decades_for_logarithms = 100;

/// 1, 2 or 5 times a power of ten, at least `step`.
double round_step(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step) return factor * power;
  return 10 * power;
}

/// 1234567 as 1,234,567.
std::string grouped_digits(std::string digits) {
  const std::size_t start = digits.starts_with('-') ? 1 : 0;
  const std::size_t end = std::min(digits.find('.'), digits.size());
  for (std::size_t at = end; at > start + 3;) digits.insert(at -= 3, ",");
  return digits;
}

}  // namespace

PlotAxis::PlotAxis(std::span<const double> values, From from) {
  double least = infinity, greatest = -least, least_positive = least;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    if (value > 0) least_positive = std::min(least_positive, value);
  }
  if (!(least <= greatest)) least = greatest = 0;
  if (least >= 0 && greatest > 0 && greatest / decades_for_logarithms >= least_positive) {
    make_logarithmic(least_positive, greatest);
    return;
  }
  if (from == From::zero) {
    least = std::min(least, 0.0);
    greatest = std::max(greatest, 0.0);
  }
  make_linear(least, greatest);
}

void PlotAxis::make_logarithmic(double least, double greatest) {
  constexpr double most_ticks = 6;
  logarithmic_ = true;
  // A third of a decade is left below the least, so that its bar is seen.
  lower_ = std::max(std::floor(std::log10(least) - 0.3), -307.0);
  upper_ = std::min(std::max(std::ceil(std::log10(greatest)), lower_ + 1), 308.0);
  const double step = std::ceil((upper_ - lower_) / most_ticks);
  for (int i = 0; lower_ + i * step <= upper_; ++i) ticks_.push_back(std::pow(10, lower_ + i * step));
}

void PlotAxis::make_linear(double least, double greatest) {
  constexpr double steps = 6;
  if (least == greatest) {
    const double beside = least == 0 ? 1 : 0.5 * std::abs(least);
    least -= least == 0 ? 0 : beside;
    greatest += beside;
  }
  const double step = round_step(std::max(greatest / steps - least / steps, 1e-300));
  const double first = std::floor(least / step), last = std::ceil(greatest / step);
  lower_ = std::max(first * step, std::numeric_limits<double>::lowest());
  upper_ = std::min(last * step, std::numeric_limits<double>::max());
  for (int i = 0; first + i <= last; ++i)
    if (const double tick = (first + i) * step; std::isfinite(tick)) ticks_.push_back(tick == 0 ? 0 : tick);
}

double PlotAxis::place_of(double value) const {
  if (logarithmic_) return value > 0 ? std::clamp((std::log10(value) - lower_) / (upper_ - lower_), 0.0, 1.0) : 0;
  const double unit = std::max(std::abs(lower_), std::abs(upper_));  // differences of the greatest doubles overflow
  return std::clamp((value / unit - lower_ / unit) / (upper_ / unit - lower_ / unit), 0.0, 1.0);
}

std::string plot_number(double value) {
  if (std::isnan(value)) return "not measured";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-4 || size >= 1e7)) {
    const std::string text = fmt::format("{:.3e}", value);
    const std::size_t at = text.find('e');
    std::string digits = text.substr(0, at);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
    return digits + "e" + fmt::format("{}", std::stoi(text.substr(at + 1)));
  }
  if (size >= 1000) return grouped_digits(fmt::format("{:.0f}", value));
  return fmt::format("{:.4g}", value);
}

}  // namespace toccata::io
