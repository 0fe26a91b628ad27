#pragma once

#include <optional>

#include "narrow/quadrics/quadric_body.hpp"

namespace toccata {

/// A direction along which A − B is lowest of all: no height is less than `lower`. The points of A and B that are
/// farthest along it and against it lie across from each other, but for rounding.
struct LowestPlace {
  Vec3 axis;
  double lower = 0;
  Vec3 on_a;
  Vec3 on_b;
};

/// For bodies that overlap little beside the size of what meets there, and of which A is made of a quadric: one place
/// is looked for, by Newton's method, and proved to be the lowest by points of A − B all around it. Nothing where that
/// fails, as where they are deep in each other.
[[nodiscard]] std::optional<LowestPlace> lowest_place(const QuadricBody& a, const QuadricBody& b);

}  // namespace toccata
