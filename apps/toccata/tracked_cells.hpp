#pragma once

#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/index.hpp"
#include "toccata/partitions/cell_tracker.hpp"

namespace toccata::command {

/// Which cells of a grid moving boxes are in, for a page: those that are entered, kept and left in a frame, and those
/// that the middle of a box passes on its way without stopping there.
class TrackedCells {
 public:
  /// The boxes are finite.
  explicit TrackedCells(std::span<const Aabb> boxes);

  /// What has changed since the last call; a cell is in the first group that it belongs to. At first all are entered.
  [[nodiscard]] BroadPhaseCells frame(std::span<const Aabb> boxes);

 private:
  [[nodiscard]] std::vector<GridCell<3>> passed(Index number, const Aabb& box) const;

  CellTracker<3> tracker_;
  std::vector<Aabb> last_;
};

}  // namespace toccata::command
