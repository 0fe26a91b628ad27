#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// Two triangles that meet, as a search finds them: small, because they are sorted. Pairs are in order when their
/// numbers are.
struct FoundPair {
  std::uint64_t number = 0;  ///< the first triangle · 2^32 + the second
  const Intersection* intersection = nullptr;

  [[nodiscard]] Index first() const { return static_cast<Index>(number >> 32); }
  [[nodiscard]] Index second() const { return static_cast<Index>(number); }
};

[[nodiscard]] constexpr std::uint64_t number_of(const ItemPair& pair) {
  return std::uint64_t{pair.first} << 32 | pair.second;
}

/// Intersections that stay where they are as long as this does or until it is cleared. Memory is kept.
class CachedIntersections {
 public:
  const Intersection* keep(const Intersection& intersection) {
    reserve(count_ + 1);
    Intersection& kept = (*chunks_[count_ / chunk_size])[count_ % chunk_size];
    ++count_;
    return &(kept = intersection);
  }
  void clear() { count_ = 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  /// Makes room for so many in all.
  void reserve(std::size_t count) {
    while (chunks_.size() * chunk_size < count) chunks_.push_back(std::make_unique<Chunk>());
  }

 private:
  static constexpr std::size_t chunk_size = 256;
  using Chunk = std::array<Intersection, chunk_size>;
  std::vector<std::unique_ptr<Chunk>> chunks_;
  std::size_t count_ = 0;
};

/// What one thread found.
struct FoundPairs {
  std::vector<FoundPair> pairs;
  CachedIntersections intersections;  ///< of pairs in special position; all others refer to a table

  void clear() {
    pairs.clear();
    intersections.clear();
  }
  /// The meeting must stay where it is.
  void add(const ItemPair& pair, const Intersection* intersection) { pairs.push_back({number_of(pair), intersection}); }
};

/// Sorts pairs that are all different (a radix sort, least digit first). Says where they are now: where they were, or
/// in `spare`, which is as long.
[[nodiscard]] std::span<FoundPair> sorted(std::span<FoundPair> pairs, std::span<FoundPair> spare);

}  // namespace toccata
