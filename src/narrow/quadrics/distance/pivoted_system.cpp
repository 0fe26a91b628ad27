#include "narrow/quadrics/distance/pivoted_system.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

/// A pivot below this part of the largest is rounding.
constexpr double least_pivot = 0x1p-44;

}  // namespace

void PivotedSystem::equilibrate() {
  for (std::size_t row = 0; row < size_; ++row) {
    double largest = 0;
    for (std::size_t column = 0; column < size_; ++column) largest = std::fmax(largest, std::fabs(entry_[row][column]));
    if (!(largest > 0)) continue;
    const double factor = 1 / largest;
    for (std::size_t column = 0; column <= size_; ++column) entry_[row][column] *= factor;
  }
}

double PivotedSystem::bring_pivot(std::size_t step) {
  std::size_t best_row = step, best_column = step;
  double largest = 0;
  for (std::size_t row = step; row < size_; ++row)
    for (std::size_t column = step; column < size_; ++column) {
      const double magnitude = std::fabs(entry_[row][column]);
      if (!(magnitude > largest)) continue;
      largest = magnitude;
      best_row = row;
      best_column = column;
    }
  if (best_row != step) std::swap(entry_[step], entry_[best_row]);
  if (best_column != step) {
    for (std::size_t row = 0; row < size_; ++row) std::swap(entry_[row][step], entry_[row][best_column]);
    std::swap(unknown_[step], unknown_[best_column]);
  }
  return largest;
}

std::array<double, PivotedSystem::most> PivotedSystem::solve() {
  equilibrate();
  for (std::size_t i = 0; i < size_; ++i) unknown_[i] = i;
  std::size_t rank = 0;
  for (; rank < size_; ++rank) {
    if (!(bring_pivot(rank) > least_pivot)) break;
    for (std::size_t row = rank + 1; row < size_; ++row) {
      const double factor = entry_[row][rank] / entry_[rank][rank];
      if (factor == 0) continue;
      for (std::size_t column = rank; column <= size_; ++column) entry_[row][column] -= factor * entry_[rank][column];
    }
  }
  std::array<double, most> found{};
  for (std::size_t row = rank; row-- > 0;) {
    double rest = entry_[row][size_];
    for (std::size_t column = row + 1; column < rank; ++column) rest -= entry_[row][column] * found[unknown_[column]];
    found[unknown_[row]] = rest / entry_[row][row];
  }
  return found;
}

}  // namespace toccata
