#pragma once

#include "narrow/smooth/distance/smooth_nearest.hpp"

// How bodies that meet are parted the shortest way, surfaces too. In the pair's frame.
namespace toccata {

/// Of bodies that certainly have a common inner point, the direction along which B has to move the least, but for what
/// was not found; A is made of a smooth shape.
[[nodiscard]] Penetration least_depth(const SmoothBody& a, const SmoothBody& b);

struct SmoothParting {
  Vec3 normal;       ///< unit, from A to B
  double depth = 0;  ///< how far A reaches along it beyond where B begins
  // Where they would touch last; the difference is depth · normal, but for rounding.
  Vec3 on_a;
  Vec3 on_b;
};

/// Nothing nearby is shorter.
[[nodiscard]] SmoothParting parting_of(const SmoothBody& a, const SmoothBody& b, const SmoothNearest& met);

}  // namespace toccata
