#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "distributed/ranks.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// A point of the box, about the middle: where what is in it has its home.
[[nodiscard]] Vec3 place_of(const Aabb& box);

/// All of space, divided into as many parts as there are ranks by planes across the axes: a plane divides space, each
/// side is divided again, and so on. What lies on a plane belongs to the side above, so every point is in one part. The
/// same bits on all ranks. (M. J. Berger, S. H. Bokhari, "A partitioning strategy for nonuniform problems on
/// multiprocessors", 1987.)
class SpaceOfRanks {
 public:
  /// Below it is what has a coordinate less than `at`.
  struct Plane {
    int axis = 0;
    double at = 0;
  };

  /// Into so many parts, of which the first has all.
  explicit SpaceOfRanks(int parts);
  /// Such that all parts have about as much of the costs. Collective; a place counts what it costs.
  SpaceOfRanks(Ranks& ranks, std::span<const Vec3> places, std::span<const std::uint64_t> costs);

  [[nodiscard]] int part_of(const Vec3& place) const;
  /// That of a piece, then those of its lower side, then those of its upper one.
  [[nodiscard]] std::span<const Plane> planes() const { return planes_; }

  /// Calls `visit(part)` for each part that has a point of the closed box, ascending.
  template <class Visit>
  void visit_parts_meeting(const Aabb& box, const Visit& visit) const {
    visit_parts(box, visit, 0, 0, parts_);
  }

 private:
  /// The parts [first, end), which still are one piece, and the plane that is to divide them if there are several.
  struct Piece {
    int first = 0;
    int end = 1;
    std::size_t plane = 0;
  };
  struct Bisection;

  [[nodiscard]] static bool is_open(const Piece& piece) { return piece.end - piece.first > 1; }
  [[nodiscard]] static std::vector<Piece> halves(std::span<const Piece> pieces);
  /// How many of the parts of a piece lie below its plane.
  [[nodiscard]] static int below(int first, int end) { return (end - first) / 2; }

  template <class Visit>
  void visit_parts(const Aabb& box, const Visit& visit, std::size_t plane, int first, int end) const {
    if (end - first == 1) {
      visit(first);
      return;
    }
    const Plane& by = planes_[plane];
    const int low = below(first, end);
    if (box.lower[by.axis] < by.at) visit_parts(box, visit, plane + 1, first, first + low);
    if (box.upper[by.axis] >= by.at) visit_parts(box, visit, plane + static_cast<std::size_t>(low), first + low, end);
  }

  int parts_;
  std::vector<Plane> planes_;
};

}  // namespace toccata
