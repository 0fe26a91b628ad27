#pragma once

#include <cstddef>
#include <vector>

namespace toccata {

/// Gives all memory back: `list = {}` would keep it.
template <class T>
void free_list(std::vector<T>& list) {
  std::vector<T>().swap(list);
}

/// Empties a list that will have about so many entries: it gets room for them, and gives back what is more than twice
/// as much.
template <class T>
void empty_list(std::vector<T>& list, std::size_t expected) {
  constexpr std::size_t few = 1024;
  list.clear();
  if (list.capacity() > 2 * expected + few) free_list(list);
  list.reserve(expected);
}

}  // namespace toccata
