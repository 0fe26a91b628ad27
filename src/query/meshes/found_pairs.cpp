#include "query/meshes/found_pairs.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace toccata {
namespace {

constexpr int digit_bits = 9;
constexpr std::uint64_t digit_mask = (std::uint64_t{1} << digit_bits) - 1;

/// Below it the counters cost more than comparisons.
constexpr std::size_t worth_counting = 100;

/// Sorts by one digit; equals stay in order.
void sort_by_digit(std::span<const FoundPair> from, std::span<FoundPair> to, int shift) {
  std::array<std::size_t, digit_mask + 1> next{};
  for (const FoundPair& pair : from) ++next[pair.number >> shift & digit_mask];
  std::size_t before = 0;
  for (std::size_t& one : next) before += std::exchange(one, before);
  for (const FoundPair& pair : from) to[next[pair.number >> shift & digit_mask]++] = pair;
}

/// The bits in which some of the numbers differ.
std::uint64_t differing_bits(std::span<const FoundPair> pairs) {
  std::uint64_t differing = 0;
  for (const FoundPair& pair : pairs) differing |= pair.number ^ pairs.front().number;
  return differing;
}

}  // namespace

std::span<FoundPair> sorted(std::span<FoundPair> pairs, std::span<FoundPair> spare) {
  if (pairs.size() < worth_counting) {
    std::sort(pairs.begin(), pairs.end(), [](const FoundPair& p, const FoundPair& q) { return p.number < q.number; });
    return pairs;
  }
  for (std::uint64_t left = differing_bits(pairs); left != 0;) {
    const int shift = std::countr_zero(left);
    sort_by_digit(pairs, spare, shift);
    std::swap(pairs, spare);
    left &= ~(digit_mask << shift);
  }
  return pairs;
}

}  // namespace toccata
