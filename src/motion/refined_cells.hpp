#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/swept_cell.hpp"

namespace toccata {

struct CellsWanted {
  double excess = 0;     ///< no cell has to reach less far outside of what is passed
  std::size_t most = 1;  ///< so many cells; more where there are more parts and pieces to begin with
};

/// Cells that contain what the parts pass on the motion: one for each part and piece, of which the one that reaches
/// farthest outside is divided, in time or in space, until none does by more than is wanted or there are so many. In
/// the order in which they were made.
[[nodiscard]] std::vector<SweptCell> refined_cells(std::span<const MovingPart> parts, const RigidMotion& motion,
                                                   const CellsWanted& wanted);

}  // namespace toccata
