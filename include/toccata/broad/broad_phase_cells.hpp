#pragma once

#include <string>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata {

/// Parts of space of one sort: the cells of one size, the boxes of one level of a tree, the intervals along an axis.
struct CellGroup {
  std::string name;    ///< for people: "cells of side 2", "level 3"
  int dimensions = 3;  ///< 1: intervals along an axis, 2: rectangles in a plane; infinite along the others
};

/// A part of space, in the world, in the unit of the boxes.
struct BroadPhaseCell {
  Aabb box;         ///< has infinite sides where it has no end; ends that the method keeps as floats are rounded so
  Index group = 0;  ///< of the groups
};

/// Into what a method of the broad phase divided space to find pairs, for looking at it (BroadPhase::cells).
struct BroadPhaseCells {
  std::vector<CellGroup> groups;      ///< from coarse to fine, where they are levels
  std::vector<BroadPhaseCell> cells;  ///< by group
};

}  // namespace toccata
