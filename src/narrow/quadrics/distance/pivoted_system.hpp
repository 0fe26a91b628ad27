#pragma once

#include <array>
#include <cstddef>

namespace toccata {

/// Linear equations for up to `most` unknowns, as many as there are unknowns, in doubles. Where they say one thing
/// twice, some unknowns are left at 0.
class PivotedSystem {
 public:
  static constexpr std::size_t most = 20;

  explicit PivotedSystem(std::size_t size) : size_(size) {
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column <= size; ++column) entry_[row][column] = 0;
  }

  [[nodiscard]] double& at(std::size_t row, std::size_t column) { return entry_[row][column]; }
  [[nodiscard]] double& right(std::size_t row) { return entry_[row][size_]; }

  /// Solves the equations by elimination with the largest pivot of all. Changes them.
  [[nodiscard]] std::array<double, most> solve();

 private:
  void equilibrate();
  /// Brings the largest entry of the rest to (step, step), and tells its magnitude.
  double bring_pivot(std::size_t step);

  std::size_t size_;
  std::array<std::array<double, most + 1>, most> entry_;
  std::array<std::size_t, most> unknown_{};
};

}  // namespace toccata
