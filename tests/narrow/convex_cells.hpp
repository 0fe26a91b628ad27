#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/convex_cases.hpp"
#include "support/sweep.hpp"

// Cells of sweeps over pairs of convex shapes: a family for every two kinds.
namespace toccata::test {

/// "box/hull" is every box against every hull; both orders are one cell.
inline std::vector<std::string> cells_of(const std::vector<std::string>& kinds) {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    for (std::size_t j = i; j < kinds.size(); ++j) cells.push_back(kinds[i] + "/" + kinds[j]);
  return cells;
}

/// The regimes in turn, and after a round of them the shapes in the other order.
inline ConvexCase case_of_cell(const std::string& cell, std::uint64_t number, Random& random) {
  const std::vector<std::string>& regimes = convex_regimes();
  const std::size_t slash = cell.find('/');
  ConvexCase pair =
      convex_case(cell.substr(0, slash), cell.substr(slash + 1), regimes[number % regimes.size()], random);
  if (number / regimes.size() % 2 == 1) std::swap(pair.a, pair.b);
  return pair;
}

/// Its own numbers for every seed of every cell.
inline Random random_of_cell(const std::string& cell, std::uint64_t seed) {
  std::uint64_t number = seed;
  for (const char c : cell) number = 0x9e3779b97f4a7c15ULL * number + static_cast<unsigned char>(c);
  return Random(number);
}

/// Cases of a cell. `check(pair, random)` gives nothing, or what is wrong.
template <class Check>
SweepResult run_cell(const std::string& cell, std::uint64_t seed, std::uint64_t cases, Check check) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  for (; result.cases < cases; ++result.cases) {
    const ConvexCase pair = case_of_cell(cell, result.cases, random);
    const std::string wrong = check(pair, random);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

constexpr std::uint64_t cell_goal = 100'000;  ///< over all regimes
constexpr std::uint64_t cell_round = 15;      ///< every regime once
constexpr std::uint64_t cell_slice = 67 * cell_round;
constexpr std::uint64_t cell_shard = 1500;

}  // namespace toccata::test
