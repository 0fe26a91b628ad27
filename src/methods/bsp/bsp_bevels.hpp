#pragma once

#include "methods/bsp/bsp_sweep.hpp"

namespace toccata {

struct BevelledStretch {
  BspStretch stretch;
  Vec3 normal{};  ///< of the bevel across which it begins; zero where it begins as it did without
};

/// The part of the stretch in which the shape may be in the cell that the sweep is entering, by bevels too; empty where
/// they keep it out. A bevel is a plane that the cell lies behind because it lies behind two or three others: a sum of
/// these with weights that are not negative. Those tried are the sums of unit normals, which cut off edges and corners,
/// and the planes along an axis at an edge and across an axis at a corner, with which all planes of the Minkowski sum
/// of the cell and a box along the axes are among those tried.
[[nodiscard]] BevelledStretch narrowed_by_bevels(const BspSweep& sweep, const BspStretch& in_cell);

}  // namespace toccata
