#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/no_index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// Finds points again by their coordinates: a hash table of their numbers, which are kept by whoever asks.
class PointNumbers {
 public:
  /// Has room for so many; grows when there are more.
  explicit PointNumbers(std::size_t expected) { make_room(std::bit_ceil(2 * expected + 2)); }

  /// The number of an earlier point that is the same; else `number` is taken for this one. `points` holds those that
  /// have numbers, at their numbers. Points that are the same must be equal.
  template <class Same>
  Index find_or_take(const Vec3& point, Index number, std::span<const Vec3> points, const Same& same) {
    if (2 * taken_ >= slots_.size()) grow(points);
    for (std::size_t slot = start_of(point);; slot = (slot + 1) & (slots_.size() - 1)) {
      const Index found = slots_[slot];
      if (found == no_index) {
        slots_[slot] = number;
        ++taken_;
        return number;
      }
      if (same(points[found], point)) return found;
    }
  }

 private:
  void make_room(std::size_t slots) {
    slots_.assign(slots, no_index);
    shift_ = 64 - std::countr_zero(slots);
  }

  void grow(std::span<const Vec3> points) {
    const std::vector<Index> before = std::move(slots_);
    make_room(2 * before.size());
    for (const Index number : before) {
      if (number == no_index) continue;
      std::size_t slot = start_of(points[number]);
      while (slots_[slot] != no_index) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = number;
    }
  }

  /// Where the search for a point begins. −0 is 0.
  [[nodiscard]] std::size_t start_of(const Vec3& p) const {
    // The highest bits of a product depend on all bits of its factors; the lowest of a double that was a float are 0.
    std::uint64_t hash = std::bit_cast<std::uint64_t>(p.x + 0.0) * 0x9e3779b97f4a7c15;
    hash += std::bit_cast<std::uint64_t>(p.y + 0.0) * 0xc2b2ae3d27d4eb4f;
    hash += std::bit_cast<std::uint64_t>(p.z + 0.0) * 0x165667b19e3779f9;
    return static_cast<std::size_t>(((hash ^ hash >> 32) * 0xd6e8feb86659fd93) >> shift_);
  }

  std::vector<Index> slots_;
  std::size_t taken_ = 0;
  int shift_ = 0;
};

}  // namespace toccata
