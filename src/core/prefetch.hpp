#pragma once

#include <cstddef>

namespace toccata {

/// Asks for the memory of a value before its turn comes.
template <class T>
inline void prefetch(const T& value) {
  constexpr std::size_t line = 64;
  const auto* bytes = reinterpret_cast<const char*>(&value);
#pragma GCC unroll 8
  for (std::size_t at = 0; at < sizeof(T); at += line) __builtin_prefetch(bytes + at);
  // A value that begins within a line may end in one more.
  if constexpr (alignof(T) < line) __builtin_prefetch(bytes + sizeof(T) - 1);
  // Without this g++ takes a function that does nothing but ask for memory for one without effects, and leaves calls of
  // it out.
  asm volatile("" : :);
}

}  // namespace toccata
