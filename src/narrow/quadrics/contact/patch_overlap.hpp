#pragma once

#include "narrow/quadrics/contact/contact_patch.hpp"

namespace toccata {

/// A point of what two patches have in common, seen along the normal.
struct CommonPoint {
  Vec3 at;  ///< half way between the two
  double depth = 0;
  ConvexFeature on_a;
  ConvexFeature on_b;
};

/// Points on the boundary of what two patches have in common: all its corners, and of round pieces of it every 16th of
/// a rim, counted from where it is deepest. None where they have but a point in common, or nothing.
[[nodiscard]] std::pmr::vector<CommonPoint> common_points(const ContactPatch& a, const ContactPatch& b,
                                                          std::pmr::memory_resource& memory);

}  // namespace toccata
