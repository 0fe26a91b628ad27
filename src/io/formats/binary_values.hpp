#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

namespace toccata::io {

/// The value of type T stored at the start of `bytes`, which must be long enough, in the given byte order.
template <typename T>
[[nodiscard]] T stored_value(std::span<const char> bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data(), sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  return std::bit_cast<T>(raw);
}

}  // namespace toccata::io
