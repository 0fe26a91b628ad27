#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace toccata {

/// Which triangles of a closed surface join which, by the numbers of their corners, without any geometry: a sphere, as
/// each new corner replaces a disc of facets by a fan, whatever has told which facets are to go. A facet keeps its slot
/// as long as it is there; what whoever owns the surface knows of facets lies in arrays of his own, by slots.
class FacetSlots {
 public:
  static constexpr std::size_t most_corners = 192;
  static constexpr std::size_t most_facets = 2 * most_corners;  // of a sphere, less than twice as many as corners

  using Corners = std::array<std::uint8_t, 3>;  ///< against the clock, seen from outside
  /// One for each slot.
  struct Bits {
    std::array<std::uint64_t, most_facets / 64> word{};

    [[nodiscard]] bool operator()(std::size_t f) const { return (word[f / 64] >> (f % 64) & 1) != 0; }
    void set(std::size_t f) { word[f / 64] |= std::uint64_t{1} << (f % 64); }
  };

  /// An edge of the way around a hole: the new facet in the slot has the corners `from`, `to` and the new one.
  struct HoleEdge {
    std::uint16_t slot;
    std::uint16_t twin;  ///< of the facet that stays
    std::uint8_t from;
    std::uint8_t to;
  };

  void clear() { slots_ = 0; }
  /// A closed surface, with the twin of the edge from corner k of facet f to the next at 4f + k.
  void start(std::span<const Corners> facets, std::span<const std::uint16_t> twins);
  /// The tetrahedron of the corners 0 to 3. `is_positive`: 1, 2, 3 turn against the clock, seen from 0.
  void start_tetrahedron(bool is_positive);

  /// Slots in use, and those that have become vacant.
  [[nodiscard]] std::size_t count() const { return slots_; }
  [[nodiscard]] bool is_vacant(std::size_t f) const { return corner_[4 * f] == corner_[4 * f + 1]; }
  [[nodiscard]] std::uint8_t corner(std::size_t f, std::size_t k) const { return corner_[4 * f + k]; }
  [[nodiscard]] Corners corners(std::size_t f) const { return {corner(f, 0), corner(f, 1), corner(f, 2)}; }

  /// Looks for the facets to go: the first, and those of which `is_seen(f)` is told, as far as they hang together with
  /// it. False when they are no disc, or there are not slots enough.
  template <class IsSeen>
  [[nodiscard]] bool find_hole(std::size_t first, const IsSeen& is_seen);
  [[nodiscard]] std::span<const HoleEdge> hole() const { return {hole_.data(), edges_}; }
  /// The slots of facets that are to go, which no new facet takes.
  [[nodiscard]] std::span<const std::uint16_t> left_over() const {
    return {gone_.data() + edges_, gone_count_ > edges_ ? gone_count_ - edges_ : 0};
  }
  /// Exchanges what was found for a fan around the corner.
  void fill_hole(std::size_t apex);

 private:
  void place(std::size_t f, std::size_t i, std::size_t j, std::size_t k) {
    corner_[4 * f] = static_cast<std::uint8_t>(i);
    corner_[4 * f + 1] = static_cast<std::uint8_t>(j);
    corner_[4 * f + 2] = static_cast<std::uint8_t>(k);
  }
  void join(std::size_t edge, std::size_t other) {
    twin_[edge] = static_cast<std::uint16_t>(other);
    twin_[other] = static_cast<std::uint16_t>(edge);
  }
  [[nodiscard]] bool go_around(std::size_t start);

  std::array<std::uint8_t, 4 * most_facets> corner_;  ///< those of facet f at 4f, 4f + 1 and 4f + 2
  std::array<std::uint16_t, 4 * most_facets> twin_;  ///< of the edge from a corner to the next, that in the other facet
  std::size_t slots_ = 0;

  std::array<std::uint16_t, most_facets> gone_;
  std::array<std::uint16_t, most_corners> twin_from_;  ///< of the edge around the hole that begins at a corner
  std::array<std::uint8_t, most_corners> next_to_;     ///< where that edge ends
  std::array<HoleEdge, most_corners> hole_;
  std::size_t gone_count_ = 0;
  std::size_t edges_ = 0;
};

template <class IsSeen>
bool FacetSlots::find_hole(std::size_t first, const IsSeen& is_seen) {
  Bits gone;
  gone.set(first);
  gone_[0] = static_cast<std::uint16_t>(first);
  gone_count_ = 1;
  edges_ = 0;
  std::size_t start = 0;
  for (std::size_t g = 0; g < gone_count_; ++g)
    for (std::size_t f = gone_[g], k = 0; k < 3; ++k) {
      const std::size_t twin = twin_[4 * f + k], other = twin / 4;
      if (gone(other)) continue;
      if (is_seen(other)) {
        gone.set(other);
        gone_[gone_count_++] = static_cast<std::uint16_t>(other);
        continue;
      }
      start = corner(f, k);
      twin_from_[start] = static_cast<std::uint16_t>(twin);
      next_to_[start] = corner(f, k == 2 ? 0 : k + 1);
      ++edges_;
    }
  return go_around(start);
}

}  // namespace toccata
