// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <vector>

#include "oracle/rational.hpp"
#include "toccata/partitions/grid_cells.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata {
namespace {

using oracle::exact;

TEST(ProofConstants, AMovingBoxIsWhereItIsAtATimeInBetween) {
  const double begin = -0x1.6babea6ecacccp-1, end = 0x1.58c9a7829e0eap-1;
  const double from = 0x1.2170511424ec9p-1, until = 0x1.117da1700ec1ap+0, time = 0x1.0ca51b6a13baep+0;
  const auto box_at = [](double x) { return Aabb{{x, x, x}, {x, x, x}}; };
  const GridBox<4> box = swept({box_at(begin), box_at(end), from, until}, time, time);
  const auto part = (exact(time) - exact(from)) / (exact(until) - exact(from));
  const auto place = exact(begin) + part * (exact(end) - exact(begin));
  EXPECT_LE(exact(box.lower[0]), place);
  EXPECT_GE(exact(box.upper[0]), place);
}

// Planes belong to the cells above them.
TEST(ProofConstants, AWalkDownwardsThroughAGridComesToTheNextCell) {
  const GridCells<2> grid({0, 0}, {1, 1});
  std::vector<GridCell<2>> found;
  walk_cells<2>(grid, {2.5, 0.5}, {0.5, 0.5}, [&](const GridCell<2>& cell) {
    found.push_back(cell);
    return found.size() < 4;
  });
  EXPECT_EQ(found, (std::vector<GridCell<2>>{{2, 0}, {1, 0}, {0, 0}}));
}

// The farthest plane belongs to no cell.
TEST(ProofConstants, ABoxBeyondTheGridMeetsWhatIsInIt) {
  const std::vector<GridBox<2>> boxes{{{0.25, 0.25}, {0.75, 0.75}}};
  const UniformGrid<2> grid(GridCells<2>({0, 0}, {1, 1}), boxes);
  EXPECT_EQ(grid.candidates(GridBox<2>{{0, 0}, {0x1p40, 0x1p40}}), std::vector<Index>{0});
}

}  // namespace
}  // namespace toccata
