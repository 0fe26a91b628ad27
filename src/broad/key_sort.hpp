#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace toccata {

/// Unsigned numbers in the order of the floats.
[[nodiscard]] inline std::uint32_t ordered(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

/// Where something stood, and what it is sorted by.
template <std::unsigned_integral Key>
struct Keyed {
  Key key;
  std::uint32_t place;
};

/// Sorts by key, digit by digit, and leaves those of equal keys in their order. `scratch` is overwritten.
template <std::unsigned_integral Key>
void sort_by_key(std::vector<Keyed<Key>>& keyed, std::vector<Keyed<Key>>& scratch) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  scratch.resize(keyed.size());
  for (int shift = 0; shift < static_cast<int>(8 * sizeof(Key)); shift += digit_bits) {
    const auto digit = [shift](Key key) { return static_cast<std::size_t>(key >> shift) & (digits - 1); };
    std::array<std::uint32_t, digits> place{};
    for (const Keyed<Key>& one : keyed) ++place[digit(one.key)];
    if (!keyed.empty() && place[digit(keyed.front().key)] == keyed.size()) continue;
    std::uint32_t sum = 0;
    for (std::uint32_t& of_digit : place) sum += std::exchange(of_digit, sum);
    for (const Keyed<Key>& one : keyed) scratch[place[digit(one.key)]++] = one;
    std::swap(keyed, scratch);
  }
}

}  // namespace toccata
