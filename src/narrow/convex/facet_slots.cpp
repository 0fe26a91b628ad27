#include "narrow/convex/facet_slots.hpp"

#include <algorithm>

namespace toccata {

void FacetSlots::start(std::span<const Corners> facets, std::span<const std::uint16_t> twins) {
  slots_ = facets.size();
  for (std::size_t f = 0; f < slots_; ++f) place(f, facets[f][0], facets[f][1], facets[f][2]);
  std::copy(twins.begin(), twins.end(), twin_.begin());
}

void FacetSlots::start_tetrahedron(bool is_positive) {
  // Corner 3 lies behind the face 0, i, j.
  const std::size_t i = is_positive ? 2 : 1, j = 3 - i;
  place(0, 0, i, j), place(1, 0, 3, i), place(2, i, 3, j), place(3, j, 3, 0);
  join(0, 6), join(1, 10), join(2, 14), join(4, 13), join(5, 8), join(9, 12);
  slots_ = 4;
}

/// One loop that passes no corner twice.
bool FacetSlots::go_around(std::size_t start) {
  if (edges_ < 3 || edges_ > most_corners || slots_ + edges_ > most_facets + gone_count_) return false;
  std::size_t from = start;
  for (std::size_t i = 0; i < edges_; ++i) {
    const std::size_t slot = i < gone_count_ ? gone_[i] : slots_ + i - gone_count_;
    const std::uint8_t to = next_to_[from];
    hole_[i] = {static_cast<std::uint16_t>(slot), twin_from_[from], static_cast<std::uint8_t>(from), to};
    from = to;
    if (from == start) return i + 1 == edges_;
  }
  return false;
}

void FacetSlots::fill_hole(std::size_t apex) {
  std::size_t previous = hole_[edges_ - 1].slot;
  for (const HoleEdge& edge : hole()) {
    place(edge.slot, edge.from, edge.to, apex);
    join(std::size_t{4} * edge.slot, edge.twin);
    join(4 * previous + 1, std::size_t{4} * edge.slot + 2);
    previous = edge.slot;
  }
  if (edges_ > gone_count_) slots_ += edges_ - gone_count_;
  for (const std::uint16_t f : left_over()) place(f, 0, 0, 0);
}

}  // namespace toccata
