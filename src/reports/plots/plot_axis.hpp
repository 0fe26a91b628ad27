#pragma once

#include <span>
#include <string>
#include <vector>

namespace toccata::io {

/// Where values stand between the ends of an axis, and round numbers to tell it by.
class PlotAxis {
 public:
  /// What the ends must hold besides the values.
  enum class From { zero, least };

  /// Around the finite ones of these.
  PlotAxis(std::span<const double> values, From from);

  [[nodiscard]] bool is_logarithmic() const { return logarithmic_; }
  [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }

  /// From 0 to 1, also for what lies outside; on a logarithmic axis 0 for what is not positive.
  [[nodiscard]] double place_of(double value) const;

 private:
  void make_logarithmic(double least, double greatest);
  void make_linear(double least, double greatest);

  bool logarithmic_ = false;
  double lower_ = 0;  ///< of a logarithmic axis the power of ten
  double upper_ = 1;
  std::vector<double> ticks_;
};

/// "1,500", "0.02", "3e12": four digits at most.
[[nodiscard]] std::string plot_number(double value);

}  // namespace toccata::io
