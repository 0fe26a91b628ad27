#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "broad/pair_finder.hpp"

// Bounds that are no boxes along the axes: boxes around them are compared first, then they themselves.
namespace toccata {

/// What is wrong with a bound; empty where nothing is.
[[nodiscard]] std::string complaint_about(const Aabb& box);
[[nodiscard]] std::string complaint_about(const Ball& ball);
[[nodiscard]] std::string complaint_about(const Obb& box);

/// Bounds of one kind, in places that are used again.
template <class Bound>
class BoundPool {
 public:
  /// So that `put` cannot fail so often, nor `drop` ever.
  void make_room(std::size_t more);
  Index put(const Bound& bound);
  void drop(Index place) { free_.push_back(place); }
  [[nodiscard]] const Bound& operator[](Index place) const { return bounds_[place]; }
  [[nodiscard]] Bound& operator[](Index place) { return bounds_[place]; }
  [[nodiscard]] bool is_empty() const { return free_.size() == bounds_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return bounds_.capacity() * sizeof(Bound) + free_.capacity() * sizeof(Index);
  }

 private:
  std::vector<Bound> bounds_;
  std::vector<Index> free_;
};

/// The balls and oriented boxes among the bodies of a broad phase, beside the boxes around all of them, and which pairs
/// of boxes were found last: methods start from these, as they know of boxes only.
class OwnBounds {
 public:
  explicit OwnBounds(std::span<const IndexPair> box_pairs) : box_pairs_(box_pairs.begin(), box_pairs.end()) {}

  /// So that giving these numbers bounds of this kind cannot fail.
  template <class Bound>
  void make_room(std::size_t numbers, std::size_t more) {
    if (numbers > kinds_.capacity()) kinds_.reserve(numbers + numbers / 2);
    if (numbers > places_.capacity()) places_.reserve(numbers + numbers / 2);
    if (numbers > kinds_.size()) {
      kinds_.resize(numbers, Kind::box);
      places_.resize(numbers);
    }
    if constexpr (!std::is_same_v<Bound, Aabb>) pool<Bound>().make_room(more);
  }

  template <class Bound>
  void set(Index number, const Bound& bound) {
    if (kinds_[number] == Kind::ball) balls_.drop(places_[number]);
    if (kinds_[number] == Kind::oriented_box) oriented_boxes_.drop(places_[number]);
    kinds_[number] = kind_of<Bound>;
    if constexpr (!std::is_same_v<Bound, Aabb>) places_[number] = pool<Bound>().put(bound);
  }

  template <class Bound>
  [[nodiscard]] bool has_kind(Index number) const {
    return kind(number) == kind_of<Bound>;
  }
  /// What it is where it is no box.
  [[nodiscard]] AnyBound bound(Index number, const Aabb& box) const;
  [[nodiscard]] bool is_without_any() const { return balls_.is_empty() && oriented_boxes_.is_empty(); }
  [[nodiscard]] std::size_t bytes() const;

  [[nodiscard]] std::span<const IndexPair> box_pairs() const { return box_pairs_; }
  /// The list of the time before last, for its memory.
  [[nodiscard]] PairList take_storage() { return std::move(storage_); }

  /// What it looks at besides the pairs.
  struct Seen {
    std::span<const Aabb> boxes;
    std::span<const std::uint8_t> marks;  ///< by number
    std::uint8_t changed;                 ///< the mark of those that differ from the last update's
    int threads = own_thread;
  };
  /// Those pairs of boxes that overlap themselves, in the memory of `storage`; it keeps `box_pairs`. Pairs of two that
  /// have not changed are looked up among those before.
  [[nodiscard]] PairList cleaned(PairList box_pairs, std::span<const IndexPair> before, const Seen& seen,
                                 PairList storage);

 private:
  enum class Kind : std::uint8_t { box, ball, oriented_box };
  template <class Bound>
  static constexpr Kind kind_of = std::is_same_v<Bound, Aabb>   ? Kind::box
                                  : std::is_same_v<Bound, Ball> ? Kind::ball
                                                                : Kind::oriented_box;

  template <class Bound>
  [[nodiscard]] BoundPool<Bound>& pool() {
    if constexpr (std::is_same_v<Bound, Ball>)
      return balls_;
    else
      return oriented_boxes_;
  }
  [[nodiscard]] Kind kind(Index number) const { return number < kinds_.size() ? kinds_[number] : Kind::box; }
  [[nodiscard]] bool overlap_themselves(const IndexPair& pair, std::span<const Aabb> boxes) const;
  void judge(std::size_t begin, std::size_t end, std::span<const IndexPair> before, const Seen& seen);

  std::vector<Kind> kinds_;    ///< by number
  std::vector<Index> places_;  ///< by number, of those that are no boxes
  BoundPool<Ball> balls_;
  BoundPool<Obb> oriented_boxes_;
  PairList box_pairs_;
  PairList storage_;
  std::vector<std::uint8_t> stays_;  ///< by place among the pairs of boxes
};

}  // namespace toccata
