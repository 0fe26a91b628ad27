#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "partitions.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/random.hpp"
#include "toccata/partitions/cell_tracker.hpp"
#include "toccata/partitions/grid_cells.hpp"
#include "toccata/partitions/partition.hpp"
#include "toccata/partitions/uniform_grid.hpp"

// Which cells objects are in as they move: kept, beside rasterising anew (METHODS C17).
namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;
using CellBox = GridBox<3>;
using CellPoint = std::array<double, 3>;

/// Boxes that fly straight, each its own way, `step` cells a frame.
class FlyingBoxes {
 public:
  FlyingBoxes(std::span<const Aabb> boxes, double step, std::uint64_t seed) {
    Random random(seed);
    for (const Aabb& box : boxes) {
      boxes_.push_back({{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}});
      const double z = random.between(-1, 1), angle = random.between(0, 6.283185307179586), r = std::sqrt(1 - z * z);
      motions_.push_back({step * r * std::cos(angle), step * r * std::sin(angle), step * z});
    }
  }
  void fly() {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        boxes_[i].lower[axis] += motions_[i][axis];
        boxes_[i].upper[axis] += motions_[i][axis];
      }
  }
  [[nodiscard]] const std::vector<CellBox>& boxes() const { return boxes_; }

 private:
  std::vector<CellBox> boxes_;
  std::vector<CellPoint> motions_;
};

/// Per move of an object; times in nanoseconds.
struct TrackRow {
  double step = 0;     ///< in cells
  double cells = 0;    ///< that the object is in
  double changed = 0;  ///< entered and left
  double kept_ns = 0;
  double put_anew_ns = 0;        ///< the same tracker, out of all its cells and into all of the new ones
  double all_rasterised_ns = 0;  ///< a grid of all objects made anew
  std::size_t wrong = 0;         ///< cells whose objects are others than in the grid made anew
};

std::size_t wrong_cells(const CellTracker<3>& tracker, const UniformGrid<3>& anew) {
  std::size_t wrong = tracker.cells_in_use() == anew.cell_count() ? 0 : 1;
  for (std::size_t i = 0; i < anew.cell_count(); ++i)
    wrong += std::ranges::equal(tracker.objects_in(anew.cell(i)), anew.items_in(i)) ? 0 : 1;
  return wrong;
}

TrackRow tracked(std::span<const Aabb> objects, double step, const PartitionsArguments& arguments, Clock clock) {
  const GridCells<3> grid = grid_for(objects);
  FlyingBoxes flying(objects, step * grid.size()[0], arguments.seed);
  CellTracker<3> kept(grid), put_anew(grid);
  for (Index i = 0; i < objects.size(); ++i) {
    kept.move(i, flying.boxes()[i]);
    put_anew.move(i, flying.boxes()[i]);
  }
  TrackRow row{.step = step};
  const double moves = static_cast<double>(objects.size()) * arguments.rounds;
  for (int frame = 0; frame < arguments.rounds; ++frame) {
    flying.fly();
    std::size_t changed = 0;
    row.kept_ns += 1e9 / moves *
                   seconds_of(
                       [&] {
                         for (Index i = 0; i < objects.size(); ++i) {
                           const CellChanges<3>& changes = kept.move(i, flying.boxes()[i]);
                           changed += changes.entered.size() + changes.left.size();
                         }
                       },
                       clock);
    row.changed += static_cast<double>(changed) / moves;
    row.put_anew_ns += 1e9 / moves *
                       seconds_of(
                           [&] {
                             for (Index i = 0; i < objects.size(); ++i) {
                               put_anew.remove(i);
                               put_anew.move(i, flying.boxes()[i]);
                             }
                           },
                           clock);
    std::optional<UniformGrid<3>> anew;
    row.all_rasterised_ns += 1e9 / moves * seconds_of([&] { anew.emplace(grid, flying.boxes()); }, clock);
    row.wrong += wrong_cells(kept, *anew) + wrong_cells(put_anew, *anew);
  }
  for (Index i = 0; i < objects.size(); ++i)
    if (const auto range = kept.cells_of(i))
      row.cells += static_cast<double>(cell_count(*range)) / static_cast<double>(objects.size());
  return row;
}

/// Per way of a point; times in nanoseconds.
struct WalkRow {
  double length = 0;  ///< in cells
  double walked = 0;  ///< cells on the way
  double in_box = 0;  ///< cells of the box around the way
  double walk_ns = 0;
  double rasterise_ns = 0;  ///< every cell of that box compared with the way
  std::size_t wrong = 0;    ///< ways on which a cell walked through is not found so
};

/// Whether the way comes into the closed cell, by clipping it; a tolerance is left on every side for rounding.
bool passes(const CellPoint& from, const CellPoint& to, const CellBox& cell) {
  double first = 0, last = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double tolerance = 1e-12 * (std::fabs(cell.lower[axis]) + std::fabs(cell.upper[axis]));
    const double lower = cell.lower[axis] - tolerance, upper = cell.upper[axis] + tolerance, by = to[axis] - from[axis];
    if (by == 0) {
      if (from[axis] < lower || from[axis] > upper) return false;
      continue;
    }
    const double one = (lower - from[axis]) / by, other = (upper - from[axis]) / by;
    first = std::max(first, std::min(one, other) - 1e-12);
    last = std::min(last, std::max(one, other) + 1e-12);
  }
  return first <= last;
}

WalkRow walked(std::span<const Aabb> objects, double length, const PartitionsArguments& arguments, Clock clock) {
  const GridCells<3> grid = grid_for(objects);
  FlyingBoxes flying(objects.first(std::min(objects.size(), arguments.queries)), length * grid.size()[0],
                     arguments.seed);
  const std::vector<CellBox> from = flying.boxes();
  flying.fly();
  WalkRow row{.length = length};
  const double ways = static_cast<double>(from.size());
  std::vector<std::vector<GridCell<3>>> walks(from.size()), rasters(from.size());
  row.walk_ns = 1e9 / ways *
                seconds_of(
                    [&] {
                      for (std::size_t i = 0; i < from.size(); ++i)
                        walk_cells<3>(grid, from[i].lower, flying.boxes()[i].lower, [&](const GridCell<3>& cell) {
                          walks[i].push_back(cell);
                          return true;
                        });
                    },
                    clock);
  row.rasterise_ns = 1e9 / ways *
                     seconds_of(
                         [&] {
                           for (std::size_t i = 0; i < from.size(); ++i) {
                             const CellPoint &a = from[i].lower, &b = flying.boxes()[i].lower;
                             CellBox around;
                             for (std::size_t axis = 0; axis < 3; ++axis) {
                               around.lower[axis] = std::min(a[axis], b[axis]);
                               around.upper[axis] = std::max(a[axis], b[axis]);
                             }
                             const CellRange<3> range = grid.range(around).value();
                             row.in_box += static_cast<double>(cell_count(range)) / ways;
                             each_cell(range, [&](const GridCell<3>& cell) {
                               if (passes(a, b, grid.box(cell))) rasters[i].push_back(cell);
                             });
                           }
                         },
                         clock);
  for (std::size_t i = 0; i < from.size(); ++i) {
    row.walked += static_cast<double>(walks[i].size()) / ways;
    std::sort(walks[i].begin(), walks[i].end());
    std::sort(rasters[i].begin(), rasters[i].end());
    row.wrong += std::ranges::includes(rasters[i], walks[i]) ? 0 : 1;
  }
  return row;
}

void print_tables(const std::vector<TrackRow>& tracks, const std::vector<WalkRow>& walks) {
  fmt::print("a move of an object, in ns\n{:>12}{:>10}{:>18}{:>10}{:>12}{:>18}{:>8}\n", "step, cells", "cells in",
             "entered and left", "persist", "put anew", "all rasterised", "wrong");
  for (const TrackRow& row : tracks)
    fmt::print("{:>12}{:>10.2f}{:>18.3f}{:>10.0f}{:>12.0f}{:>18.0f}{:>8}\n", row.step, row.cells, row.changed,
               row.kept_ns, row.put_anew_ns, row.all_rasterised_ns, row.wrong);
  fmt::print("the way of a point, in ns\n{:>14}{:>15}{:>12}{:>10}{:>16}{:>8}\n", "length, cells", "cells passed",
             "in its box", "walked", "every cell", "wrong");
  for (const WalkRow& row : walks)
    fmt::print("{:>14}{:>15.2f}{:>12.1f}{:>10.0f}{:>16.0f}{:>8}\n", row.length, row.walked, row.in_box, row.walk_ns,
               row.rasterise_ns, row.wrong);
}

Json json_of(const TrackRow& row) {
  return {{"step_cells", row.step},
          {"cells", row.cells},
          {"changed", row.changed},
          {"kept_ns", row.kept_ns},
          {"put_anew_ns", row.put_anew_ns},
          {"all_rasterised_ns", row.all_rasterised_ns},
          {"wrong", row.wrong}};
}
Json json_of(const WalkRow& row) {
  return {{"length_cells", row.length},       {"walked", row.walked}, {"in_box", row.in_box}, {"walk_ns", row.walk_ns},
          {"rasterise_ns", row.rasterise_ns}, {"wrong", row.wrong}};
}

}  // namespace

int run_partition_cells(const PartitionsArguments& arguments) {
  const Clock clock = arguments.clock == "thread" ? Clock::thread : Clock::wall;
  const PartitionItems items(*single_mesh(arguments.mesh));
  std::vector<TrackRow> tracks;
  std::vector<WalkRow> walks;
  std::size_t wrong = 0;
  for (const double step : {0.01, 0.1, 1.0})
    wrong += tracks.emplace_back(tracked(items.boxes(), step, arguments, clock)).wrong;
  for (const double length : {1.0, 8.0, 32.0})
    wrong += walks.emplace_back(walked(items.boxes(), length, arguments, clock)).wrong;
  if (!arguments.json) {
    print_tables(tracks, walks);
    return wrong > 0 ? 1 : 0;
  }
  Json report = report_of("partitions", {{"mesh", arguments.mesh},
                                         {"triangles", items.size()},
                                         {"task", arguments.task},
                                         {"seed", arguments.seed},
                                         {"rounds", arguments.rounds}});
  for (const TrackRow& row : tracks) report["tracks"].push_back(json_of(row));
  for (const WalkRow& row : walks) report["walks"].push_back(json_of(row));
  report["wrong"] = wrong;
  fmt::print("{}\n", report.dump(2));
  return wrong > 0 ? 1 : 0;
}

}  // namespace toccata::bench
