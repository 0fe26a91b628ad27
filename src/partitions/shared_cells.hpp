#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"

namespace toccata {

/// Lists of items, one behind the other: list i holds items[first[i]] up to items[first[i + 1]].
struct ItemLists {
  std::vector<std::size_t> first{0};
  std::vector<Index> items;

  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
  [[nodiscard]] std::span<const Index> operator[](std::size_t i) const {
    return std::span(items).subspan(first[i], first[i + 1] - first[i]);
  }
  [[nodiscard]] std::size_t bytes() const {
    return first.capacity() * sizeof(std::size_t) + items.capacity() * sizeof(Index);
  }
};

struct ItemInList {
  Index list;
  Index item;
};

/// The items of each of `lists` lists, in the order of `entries`.
[[nodiscard]] inline ItemLists item_lists(std::span<const ItemInList> entries, std::size_t lists) {
  ItemLists result;
  result.first.assign(lists + 1, 0);
  for (const ItemInList& entry : entries) ++result.first[entry.list + std::size_t{1}];
  for (std::size_t i = 0; i < lists; ++i) result.first[i + 1] += result.first[i];
  std::vector<std::size_t> place(result.first.begin(), result.first.end() - 1);
  result.items.resize(entries.size());
  for (const ItemInList& entry : entries) result.items[place[entry.list]++] = entry.item;
  return result;
}

/// For each item the lists that it is in.
[[nodiscard]] inline ItemLists lists_of_items(const ItemLists& lists, std::size_t items) {
  std::vector<ItemInList> entries;
  entries.reserve(lists.items.size());
  for (std::size_t list = 0; list < lists.size(); ++list)
    for (const Index item : lists[list]) entries.push_back({item, static_cast<Index>(list)});
  return item_lists(entries, items);
}

/// The pairs of different items that share a list, or of which one is in `everywhere` (ascending), and that
/// `may_meet(a, b)`: ascending, each once.
template <class MayMeet>
[[nodiscard]] std::vector<IndexPair> pairs_sharing_lists(const ItemLists& lists, std::size_t items,
                                                         std::span<const Index> everywhere, const MayMeet& may_meet) {
  std::vector<IndexPair> pairs;
  const ItemLists lists_of = lists_of_items(lists, items);
  std::vector<Index> seen_by(items, 0);  // one more than the last item that looked at it
  std::vector<char> is_everywhere(items, 0);
  for (const Index item : everywhere) is_everywhere[item] = 1;
  for (Index a = 0; a < items; ++a) {
    const auto begin = static_cast<std::ptrdiff_t>(pairs.size());
    const auto look_at = [&](Index b) {
      if (b <= a || seen_by[b] == a + 1) return;
      seen_by[b] = a + 1;
      if (may_meet(a, b)) pairs.push_back({a, b});
    };
    if (is_everywhere[a] != 0) {
      for (Index b = a + 1; b < items; ++b) look_at(b);
      continue;
    }
    for (const Index list : lists_of[a])
      for (const Index b : lists[list]) look_at(b);
    for (const Index b : everywhere) look_at(b);
    std::sort(pairs.begin() + begin, pairs.end());
  }
  return pairs;
}

/// Ascending, each once.
inline void sort_unique(std::vector<Index>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace toccata
