#include "tracked_cells.hpp"

#include <map>
#include <utility>

#include "toccata/partitions/grid_cells.hpp"

namespace toccata::command {
namespace {

/// In the order in which a cell that is of several is shown.
enum Group : Index { entered, kept, passed_by, left };

/// The first group of each cell that was noted.
class Noted {
 public:
  void note(const GridCell<3>& cell, Group group) {
    const auto [found, is_new] = group_of_.try_emplace(cell, group);
    if (!is_new && group < found->second) found->second = group;
  }

  [[nodiscard]] BroadPhaseCells cells(const GridCells<3>& grid) const {
    BroadPhaseCells cells;
    cells.groups = {{"entered in this frame", 3}, {"kept", 3}, {"passed on the way", 3}, {"left in this frame", 3}};
    for (const Group group : {entered, kept, passed_by, left})
      for (const auto& [cell, its_group] : group_of_)
        if (its_group == group) cells.cells.push_back({box_of(grid.box(cell)), group});
    return cells;
  }

 private:
  static Aabb box_of(const GridBox<3>& box) {
    return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
  }

  std::map<GridCell<3>, Group> group_of_;
};

GridBox<3> grid_box(const Aabb& box) {
  return {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}};
}

std::array<double, 3> middle_of(const Aabb& box) {
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper;
  return {middle.x, middle.y, middle.z};
}

}  // namespace

TrackedCells::TrackedCells(std::span<const Aabb> boxes) : tracker_(grid_for(boxes)) {}

std::vector<GridCell<3>> TrackedCells::passed(Index number, const Aabb& box) const {
  std::vector<GridCell<3>> cells;
  if (number >= last_.size()) return cells;
  walk_cells<3>(tracker_.grid(), middle_of(last_[number]), middle_of(box), [&](const GridCell<3>& cell) {
    cells.push_back(cell);
    return true;
  });
  return cells;
}

BroadPhaseCells TrackedCells::frame(std::span<const Aabb> boxes) {
  Noted noted;
  for (Index number = 0; number < boxes.size(); ++number) {
    const CellChanges<3>& changes = tracker_.move(number, grid_box(boxes[number]));
    for (const GridCell<3>& cell : changes.entered) noted.note(cell, entered);
    for (const GridCell<3>& cell : changes.left) noted.note(cell, left);
    for (const GridCell<3>& cell : passed(number, boxes[number])) noted.note(cell, passed_by);
    if (const auto range = tracker_.cells_of(number))
      each_cell(*range, [&](const GridCell<3>& cell) { noted.note(cell, kept); });
  }
  last_.assign(boxes.begin(), boxes.end());
  return noted.cells(tracker_.grid());
}

}  // namespace toccata::command
