#include "toccata/partitions/uniform_grid.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "partitions/partition_families.hpp"
#include "toccata/core/error.hpp"
#include "toccata/partitions/grid_cells.hpp"

namespace toccata {
namespace {

static_assert(SpacePartition<UniformGrid<2>> && SpacePartition<UniformGrid<3>>);

std::array<double, 2> in_plane(const Vec3& point) { return {point.x, point.y}; }

TEST(UniformGrid2, FindsRectanglesByBruteForce) {
  for (const std::string_view family : test::partition_families) {
    Random random(3);
    std::vector<GridBox<2>> boxes;
    for (const Aabb& box : test::random_finite_boxes(family, 150, random))
      boxes.push_back({in_plane(box.lower), in_plane(box.upper)});
    const UniformGrid<2> grid(GridCells<2>({0, 0}, {0.7, 1.3}), boxes);
    std::vector<IndexPair> expected;
    const auto meet = [&](const GridBox<2>& a, const GridBox<2>& b) {
      return a.lower[0] <= b.upper[0] && b.lower[0] <= a.upper[0] && a.lower[1] <= b.upper[1] &&
             b.lower[1] <= a.upper[1];
    };
    for (Index a = 0; a < boxes.size(); ++a)
      for (Index b = a + 1; b < boxes.size(); ++b)
        if (meet(boxes[a], boxes[b])) expected.push_back({a, b});
    EXPECT_EQ(grid.candidate_pairs(), expected) << family;
    for (Index a = 0; a < boxes.size(); a += 10) {
      std::vector<Index> around;
      for (Index b = 0; b < boxes.size(); ++b)
        if (meet(boxes[a], boxes[b])) around.push_back(b);
      EXPECT_EQ(grid.candidates(boxes[a]), around) << family;
    }
  }
}

TEST(UniformGrid, RasterisesTrianglesExactly) {
  // In the plane x + y + z = 2: of eight cells it misses those at the two far corners.
  const PartitionItems items(std::vector<Triangle>{{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}}});
  const GridCells<3> cells({0, 0, 0}, {1.5, 1.5, 1.5});
  const UniformGrid<3> grid(items, cells);
  std::vector<GridCell<3>> found;
  for (std::size_t i = 0; i < grid.cell_count(); ++i) found.push_back(grid.cell(i));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<GridCell<3>>{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_TRUE(items_intersecting(grid, items, {{1.6, 1.6, 0}, {2, 2, 2}}).empty());
  EXPECT_EQ(items_intersecting(grid, items, {{0, 0, 2}, {1, 1, 3}}), (std::vector<Index>{0}));
}

TEST(UniformGrid, FallsBackWhereCellsWouldBeTooManyOrWrap) {
  const std::vector<Aabb> boxes{{{0, 0, 0}, {1, 1, 1}},
                                {{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}},
                                {{1e300, 0, 0}, {1e300, 1, 1}},
                                {{0.5, 0.5, 0.5}, {0.6, 0.6, 0.6}}};
  const UniformGrid<3> grid(PartitionItems(boxes), GridCells<3>({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(std::vector<Index>(grid.without_cells().begin(), grid.without_cells().end()), (std::vector<Index>{1, 2}));
  EXPECT_EQ(grid.candidate_pairs(), (std::vector<IndexPair>{{0, 1}, {0, 3}, {1, 3}}));
  EXPECT_EQ(grid.candidates(Aabb{{-1e308, -1e308, -1e308}, {1e308, 1e308, 1e308}}), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(grid.candidates(Aabb{{1e299, 0, 0}, {1e301, 1, 1}}), (std::vector<Index>{2}));
}

TEST(UniformGrid, MemoryIsBounded) {
  Random random(1);
  std::vector<Aabb> boxes(500, Aabb{{0, 0, 0}, {1e7, 1e7, 1e7}});
  boxes.push_back({{0, 0, 0}, {1e-9, 1e-9, 1e-9}});
  const UniformGrid<3> grid(PartitionItems(boxes), GridCells<3>({0, 0, 0}, {1e-3, 1e-3, 1e-3}));
  EXPECT_LT(grid.bytes(), 100'000U);
  EXPECT_EQ(grid.without_cells().size(), 500U);
}

__extension__ using Int128 = __int128;

/// Some of the time from 0 to 1, its ends as fractions.
struct TimeSpan {
  Int128 low_over, low_under, high_over, high_under;
  bool empty = false;
  /// Keeps the times at which base + slope · t ≥ 0.
  void keep(Int128 base, Int128 slope) {
    if (slope == 0) empty |= base < 0;
    if (slope > 0 && -base * low_under > low_over * slope) low_over = -base, low_under = slope;
    if (slope < 0 && base * high_under < high_over * -slope) high_over = base, high_under = -slope;
    empty |= low_over * high_under > high_over * low_under;
  }
};

/// Exact for motions in whole numbers from the time 0 until 1.
bool ever_meet(const MovingBox& a, const MovingBox& b) {
  TimeSpan times{0, 1, 1, 1};
  const auto keep_above = [&](double u0, double u1, double l0, double l1) {
    times.keep(static_cast<std::int64_t>(u0 - l0), static_cast<std::int64_t>((u1 - u0) - (l1 - l0)));
  };
  for (int axis = 0; axis < 3; ++axis) {
    keep_above(a.begin.upper[axis], a.end.upper[axis], b.begin.lower[axis], b.end.lower[axis]);
    keep_above(b.begin.upper[axis], b.end.upper[axis], a.begin.lower[axis], a.end.lower[axis]);
  }
  return !times.empty;
}

Aabb whole_box(Random& random) {
  const auto step = [&](std::uint64_t count) { return static_cast<double>(random.below(count)); };
  const Vec3 lower{step(40), step(40), step(40)};
  return {lower, lower + Vec3{step(4), step(4), step(4)}};
}

TEST(UniformGrid4, MissesNoMeetingOnTheWay) {
  std::size_t intersections = 0, candidates = 0, by_space = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Random random(seed);
    std::vector<MovingBox> motions;
    for (int i = 0; i < 80; ++i) motions.push_back({whole_box(random), whole_box(random), 0, 1});
    const std::uint64_t most = seed % 4 == 3 ? 60 : 4096;
    const UniformGrid<4> grid(GridCells<4>({0, 0, 0, 0}, {5, 5, 5, 0.125}), motions, {most});
    EXPECT_EQ(grid.without_cells().empty(), seed % 4 != 3);
    const std::vector<IndexPair> found = grid.candidate_pairs();
    candidates += found.size();
    for (Index a = 0; a < motions.size(); ++a)
      for (Index b = a + 1; b < motions.size(); ++b) {
        const Aabb all_a = merge(motions[a].begin, motions[a].end), all_b = merge(motions[b].begin, motions[b].end);
        by_space += overlap(all_a, all_b) ? 1 : 0;
        if (!ever_meet(motions[a], motions[b])) continue;
        ++intersections;
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), IndexPair{a, b})) << seed << ": " << a << ", " << b;
      }
  }
  EXPECT_GT(intersections, 100U);
  EXPECT_LT(2 * candidates, by_space);  // what cells of time are good for
}

TEST(UniformGrid4, MovingPointsAreInTheCellsThatTheyWalkThrough) {
  Random random(5);
  const GridCells<4> cells({0, 0, 0, 0}, {1, 1, 1, 0.25});
  for (int i = 0; i < 100; ++i) {
    const Vec3 from = test::vector_between(random, -3, 3), to = test::vector_between(random, -3, 3);
    const UniformGrid<4> grid(cells, std::vector<MovingBox>{{{from, from}, {to, to}, 0.1, 2.1}});
    std::vector<GridCell<4>> held;
    for (std::size_t k = 0; k < grid.cell_count(); ++k) held.push_back(grid.cell(k));
    std::sort(held.begin(), held.end());
    walk_cells<4>(cells, {from.x, from.y, from.z, 0.1}, {to.x, to.y, to.z, 2.1}, [&](const GridCell<4>& cell) {
      EXPECT_TRUE(std::binary_search(held.begin(), held.end(), cell));
      return true;
    });
  }
}

TEST(UniformGrid4, HoldsMotionsOfGreatAndTinyNumbers) {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  const Aabb far{{most, most, most}, {most, most, most}}, near{{-most, -most, -most}, {-most, -most, -most}};
  const GridBox<4> all = swept({near, far, -most, most}, -most, most);
  EXPECT_EQ(all.lower[0], -most);
  EXPECT_EQ(all.upper[2], most);
  const GridBox<4> half = swept({near, far, -most, most}, -most, 0);
  EXPECT_GE(half.upper[0], 0);
  EXPECT_LE(half.upper[0], most * 0x1p-40);
  const GridBox<4> tiny = swept({{{0, 0, 0}, {0, 0, 0}}, {{1, 1, 1}, {1, 1, 1}}, 0, 3 * least}, least, least);
  EXPECT_LE(tiny.lower[0], 1.0 / 3);
  EXPECT_GE(tiny.upper[0], 1.0 / 3);
}

template <class Call>
std::string message_of_partition(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(PartitionItems, RefuseWhatIsNoBox) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Aabb> infinite{{{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, infinity, 1}}};
  EXPECT_EQ(message_of_partition([&] { PartitionItems{infinite}; }),
            "box 1 has a coordinate that is not finite: leave it out of the partition");
  EXPECT_EQ(message_of_partition([&] {
              PartitionItems(std::vector<Aabb>{{{0, 2, 0}, {1, 1, 1}}});
            }),
            "box 0: its lower y 2 is above its upper one, 1");
  EXPECT_EQ(message_of_partition([&] {
              PartitionItems(std::vector<Triangle>{{{{{0, 0, 0}, {0, -infinity, 0}, {}}}}});
            }),
            "triangle 0 has a coordinate that is not finite");
  const GridCells<4> cells({0, 0, 0, 0}, {1, 1, 1, 1});
  EXPECT_EQ(message_of_partition([&] {
              UniformGrid<4>(cells, std::vector<MovingBox>{{infinite[0], infinite[0], 1, 0}});
            }),
            "motion 0: a motion from 1 until 0: the times must be finite and ascending");
  EXPECT_EQ(message_of_partition([&] {
              UniformGrid<4>(cells, std::vector<MovingBox>{{infinite[0], infinite[1], 0, 1}});
            }),
            "motion 0: the box's y at its end is not finite");
}

}  // namespace
}  // namespace toccata
