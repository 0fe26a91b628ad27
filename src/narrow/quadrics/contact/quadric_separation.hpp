#pragma once

#include <optional>

#include "narrow/quadrics/distance/quadric_nearest.hpp"

// How bodies that meet are parted the shortest way, surfaces too. In the pair's frame.
namespace toccata {

/// The depth and its direction where one place is proved to be the lowest (lowest_place.hpp): then the bodies meet. The
/// two points lie across from each other.
[[nodiscard]] std::optional<Penetration> depth_of_lowest_place(const QuadricBody& a, const QuadricBody& b);

/// For bodies that certainly have a common inner point, the direction along which B has to move the least, but for what
/// was not found; A is made of a quadric.
[[nodiscard]] Penetration least_depth(const QuadricBody& a, const QuadricBody& b);

struct QuadricSeparation {
  Vec3 normal;       ///< unit, from A to B
  double depth = 0;  ///< how far A reaches along it beyond where B begins
  // Where they would touch last; the difference is depth · normal, but for rounding.
  Vec3 on_a;
  Vec3 on_b;
};

/// By the lowest place, where that is found.
[[nodiscard]] std::optional<QuadricSeparation> separation_at_lowest_place(const QuadricBody& a, const QuadricBody& b);

/// Nothing nearby is shorter.
[[nodiscard]] QuadricSeparation separation_of(const QuadricBody& a, const QuadricBody& b, const QuadricNearest& met);

}  // namespace toccata
