#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "oracle/rational.hpp"
#include "support/data.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/box_runs.hpp"
#include "trees/wide_boxes.hpp"
#include "trees/wide_check.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

/// The place of a lane's item in the order of items.
std::size_t place_of(const WideBlock& block, std::size_t lane) {
  const std::int32_t place = ~block.child[lane];
  return static_cast<std::size_t>(place);
}

Aabb box_of_point(double x, double y, double z) { return {{x, y, z}, {x, y, z}}; }

std::vector<Aabb> boxes_of(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  for (const auto& corners : mesh.triangles()) {
    Aabb& box = boxes.emplace_back();
    for (const Index corner : corners) box = merge(box, mesh.vertices()[corner]);
  }
  return boxes;
}

/// Random boxes with edges up to `size`, within a cube of edge 2 · reach around a centre.
std::vector<Aabb> random_boxes(Random& random, std::size_t count, const Vec3& centre, double reach, double size) {
  const auto coordinate = [&] { return reach * random.between(-1, 1); };
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = centre + Vec3{coordinate(), coordinate(), coordinate()};
    boxes.push_back(
        merge(merge(Aabb{}, a), a + Vec3{size * random.unit(), size * random.unit(), size * random.unit()}));
  }
  return boxes;
}

/// Whether the lane's interval on an axis holds [lower, upper], all of them as real numbers.
bool holds(const WideBvh& tree, const WideBlock& block, std::size_t lane, int axis, double lower, double upper) {
  const auto i = static_cast<std::size_t>(axis);
  const Rational centre = exact(double{block.centre[i][lane]}), extent = exact(double{block.extent[i][lane]});
  const Rational origin = exact(tree.origin[axis]), unit = exact(tree.unit);
  return origin + unit * (centre - extent) <= exact(lower) && exact(upper) <= origin + unit * (centre + extent);
}

/// Checks everything that the header promises of a tree. Returns its depth.
class Checker {
 public:
  Checker(const WideBvh& tree, std::span<const Aabb> boxes) : tree_(tree), boxes_(boxes) {}

  int check() {
    check_frame();
    EXPECT_EQ(tree_.items.size(), boxes_.size());
    std::vector<Index> sorted = tree_.items;
    std::sort(sorted.begin(), sorted.end());
    for (Index i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
    if (boxes_.empty()) {
      EXPECT_TRUE(tree_.blocks.empty());
      return 0;
    }
    seen_.assign(tree_.items.size(), 0);
    around_.resize(tree_.blocks.size());
    parents_.assign(tree_.blocks.size(), 0);
    std::vector<int> depth(tree_.blocks.size(), 1);
    for (std::size_t block = 0; block < tree_.blocks.size(); ++block) check_children(block, depth);
    for (std::size_t block = tree_.blocks.size(); block > 0; --block) check_lanes(block - 1);
    EXPECT_EQ(parents_[0], 0);
    EXPECT_TRUE(std::all_of(parents_.begin() + 1, parents_.end(), [](int parents) { return parents == 1; }));
    EXPECT_TRUE(std::all_of(seen_.begin(), seen_.end(), [](int times) { return times == 1; }));
    EXPECT_EQ(around_[0], tree_.box);
    return *std::max_element(depth.begin(), depth.end());
  }

 private:
  void check_frame() const {
    int exponent = 0;
    EXPECT_EQ(std::frexp(tree_.unit, &exponent), 0.5) << "the unit is a power of two";
    EXPECT_GE(tree_.unit, 0x1p-1000);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(tree_.blocks.data()) % 64, 0U);
    EXPECT_EQ(tree_.blocks.capacity(), tree_.blocks.size());
    EXPECT_EQ(tree_.items.capacity(), tree_.items.size());
  }

  void check_children(std::size_t number, std::vector<int>& depth) {
    const WideBlock& block = tree_.blocks[number];
    ASSERT_GE(block.count, 1U);
    ASSERT_LE(block.count, WideBlock::width);
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (block.is_item(lane)) {
        ++seen_.at(place_of(block, lane));
        continue;
      }
      const auto child = static_cast<std::size_t>(block.child[lane]);
      ASSERT_GT(child, number) << "children come after their parent";
      ++parents_.at(child);
      depth[child] = depth[number] + 1;
    }
  }

  void check_lanes(std::size_t number) {
    const WideBlock& block = tree_.blocks[number];
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
      EXPECT_TRUE(lane < block.count || block.child[lane] == 0);
      const bool used = lane < block.count;
      const Aabb box = used ? child_box(block, lane) : Aabb{};
      for (int axis = 0; axis < 3; ++axis) check_interval(block, lane, axis, used, box);
      if (!used) continue;
      around_[number] = merge(around_[number], box);
      EXPECT_TRUE(contains(box_of(tree_, number, lane), box));
    }
  }

  Aabb child_box(const WideBlock& block, std::size_t lane) const {
    if (!block.is_item(lane)) return around_[static_cast<std::size_t>(block.child[lane])];
    return boxes_[tree_.items[place_of(block, lane)]];
  }

  void check_interval(const WideBlock& block, std::size_t lane, int axis, bool used, const Aabb& box) const {
    const auto i = static_cast<std::size_t>(axis);
    const double centre = block.centre[i][lane], extent = block.extent[i][lane];
    if (!used) {
      EXPECT_EQ(centre, 0);
      EXPECT_EQ(extent, 0);
      return;
    }
    EXPECT_TRUE(holds(tree_, block, lane, axis, box.lower[axis], box.upper[axis]))
        << box.lower[axis] << " … " << box.upper[axis] << " in " << tree_.origin[axis] << " + " << tree_.unit << " · ("
        << centre << " ± " << extent << ")";
    const double greatest = tree_.unit < 0x1p1023 ? 1 : 2;
    EXPECT_LE(std::abs(centre) + extent, greatest * (1 + 0x1p-22));
  }

  const WideBvh& tree_;
  std::span<const Aabb> boxes_;
  std::vector<int> seen_;
  std::vector<Aabb> around_;
  std::vector<int> parents_;
};

int check(std::span<const Aabb> boxes) {
  const WideBvh tree = build_wide_bvh(boxes);
  EXPECT_EQ(fault_of(tree, boxes), "");
  return Checker(tree, boxes).check();
}

bool same(const WideBvh& a, const WideBvh& b) {
  return a.origin == b.origin && a.unit == b.unit && a.box == b.box && a.items == b.items &&
         a.blocks.size() == b.blocks.size() &&
         std::memcmp(a.blocks.data(), b.blocks.data(), a.blocks.size() * sizeof(WideBlock)) == 0;
}

TEST(WideBuild, NoItemsNoBlocks) { EXPECT_EQ(check({}), 0); }

TEST(WideBuild, UpToEightItemsAreOneBlock) {
  Random random(1);
  for (std::size_t count = 1; count <= 8; ++count) {
    const auto boxes = random_boxes(random, count, {}, 1, 0.1);
    EXPECT_EQ(check(boxes), 1);
    EXPECT_EQ(build_wide_bvh(boxes).blocks.size(), 1U);
    EXPECT_EQ(build_wide_bvh(boxes).blocks[0].count, count);
  }
}

TEST(WideBuild, HoldsRandomBoxes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::size_t count = 1 + random.below(400);
    check(random_boxes(random, count, {}, 1, random.unit()));
  }
}

TEST(WideBuild, HoldsBoxesAtAllScalesAndFarFromTheOrigin) {
  for (const double scale : {1e-320, 1e-300, 1e-150, 1e-40, 1e-3, 1e6, 1e40, 1e150, 1e300, 1.7e308}) {
    for (const double offset : {0.0, 1e-2, 1e6, 1e15, 1e18}) {
      SCOPED_TRACE(testing::Message() << "scale " << scale << ", offset " << offset);
      if (scale * offset > 1e300) continue;
      Random random(7);
      const Vec3 centre{scale * offset, -scale * offset, 0};
      check(random_boxes(random, 60, centre, scale, scale > 1e300 ? 0 : 0.1 * scale));
    }
  }
}

TEST(WideBuild, HoldsBoxesAroundTheEndsOfDoubles) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  std::vector<Aabb> boxes;
  for (int i = 0; i < 50; ++i) {
    boxes.push_back({{-huge, -huge, -huge}, {huge, huge, huge}});
    boxes.push_back(box_of_point(i % 2 == 0 ? huge : -huge, 0, 0));
    boxes.push_back(box_of_point(0, i * tiny, -tiny));
  }
  check(boxes);
  boxes.clear();
  for (int i = 0; i < 50; ++i) boxes.push_back(box_of_point(0, i * tiny, -0.0));
  check(boxes);
}

TEST(WideBuild, ItemsOverManyOrdersOfMagnitudeStayShallow) {
  std::vector<Aabb> boxes;
  for (int exponent = -1074; exponent < 1023; ++exponent) {
    for (int copy = 0; copy < 4; ++copy) {
      const double x = std::ldexp(1.0, exponent);
      boxes.push_back(copy == 0 ? Aabb{{-x, 0, 0}, {x, x, 0}} : box_of_point(x, 0, copy == 1 ? -x : 0));
    }
  }
  EXPECT_LE(check(boxes), 64 + 14);
}

TEST(WideBuild, CoincidentItemsFillTheirBlocks) {
  for (const Aabb& box : {box_of_point(0.1, 0.2, 0.3), Aabb{{0, 0, 0}, {1, 1, 1}}}) {
    const std::vector<Aabb> boxes(4096, box);
    EXPECT_EQ(check(boxes), 4);
    EXPECT_EQ(build_wide_bvh(boxes).blocks.size(), 512U + 64 + 8 + 1);
  }
}

TEST(WideBuild, ItemsOnALineAndInAPlane) {
  std::vector<Aabb> line, grid;
  for (int i = 0; i < 1000; ++i) line.push_back(box_of_point(i, 0, 0));
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) grid.push_back(box_of_point(x, y, 0));
  EXPECT_LE(check(line), 8);
  EXPECT_LE(check(grid), 6);
}

TEST(WideBuild, FlatBoxesStayFlat) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back({{i * 0.1, 1, 0}, {i * 0.1 + 0.05, 2, 0}});
  for (const WideBlock& block : build_wide_bvh(boxes).blocks)
    for (std::size_t lane = 0; lane < block.count; ++lane) EXPECT_EQ(block.extent[2][lane], 0);
}

TEST(WideBuild, BoxesAreTight) {
  Random random(3);
  const auto boxes = random_boxes(random, 500, {1, 2, 3}, 1, 0.1);
  const WideBvh tree = build_wide_bvh(boxes);
  for (std::size_t number = 0; number < tree.blocks.size(); ++number) {
    const WideBlock& block = tree.blocks[number];
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      if (!block.is_item(lane)) continue;
      const Aabb& item = boxes[tree.items[place_of(block, lane)]];
      const Aabb box = box_of(tree, number, lane);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_LE((box.upper[axis] - box.lower[axis]) - (item.upper[axis] - item.lower[axis]), 1e-6);
    }
  }
}

TEST(WideBuild, HoldsManyBoxes) {
  Random random(13);
  check(random_boxes(random, 40'000, {}, 1, 0.01));
}

TEST(WideBuild, HoldsManyBoxesOfWhichMostAreInACorner) {
  Random random(17);
  auto boxes = random_boxes(random, 40'000, {1e3, 1e3, 1e3}, 1e-3, 1e-5);
  for (int i = 0; i < 100; ++i) boxes.push_back(box_of_point(-1e3 * random.unit(), 0, 0));
  EXPECT_LE(check(boxes), 14);
}

TEST(WideBuild, HoldsManyBoxesThatCoincide) {
  const std::vector<Aabb> boxes(40'000, box_of_point(0.1, 0.2, 0.3));
  EXPECT_LE(check(boxes), 9);
}

TEST(WideBuild, TheSameTreeOnAnyNumberOfThreads) {
  Random random(11);
  const auto boxes = random_boxes(random, 60'000, {5, 0, 0}, 1, 0.01);
  const WideBvh one = build_wide_bvh(boxes, {.threads = 1});
  for (const int threads : {1, 2, 3, 0}) EXPECT_TRUE(same(one, build_wide_bvh(boxes, {.threads = threads})));
}

TEST(WideBuild, TheSameTreeOverAMeshAndOverItsBoxes) {
  for (const double subdivisions : {1.0, 3.0, 6.0}) {
    const TriangleMesh mesh = generate_mesh("noise-sphere", {{"subdivisions", subdivisions}});
    const WideBvh tree = build_wide_bvh(mesh, {.threads = 2});
    EXPECT_TRUE(same(tree, build_wide_bvh(boxes_of(mesh))));
    EXPECT_EQ(fault_of(tree, mesh), "");
    WideBvh damaged = tree;
    std::swap(damaged.items.front(), damaged.items.back());
    EXPECT_EQ(fault_of(damaged, mesh), fault_of(damaged, boxes_of(mesh)));
    EXPECT_NE(fault_of(damaged, mesh), "");
  }
}

TEST(WideBuild, TooManyItemsAreRefused) {
  const std::vector<Aabb> boxes(10, box_of_point(1, 2, 3));
  EXPECT_NO_THROW((void)build_wide_bvh(boxes, {.most_items = 10}));
  try {
    (void)build_wide_bvh(boxes, {.most_items = 9});
    FAIL() << "ten items were taken where nine are allowed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("10 items"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("at most 9"), std::string::npos) << error.what();
  }
}

double bytes_per_item(const WideBvh& tree) {
  return static_cast<double>(tree.blocks.size() * sizeof(WideBlock) + tree.items.size() * sizeof(Index)) /
         static_cast<double>(tree.items.size());
}

/// How many blocks a random line that meets the whole meets: their areas over the whole's.
double blocks_met(const WideBvh& tree) {
  double area = half_area(tree.box);
  for (std::size_t block = 0; block < tree.blocks.size(); ++block)
    for (std::size_t lane = 0; lane < tree.blocks[block].count; ++lane)
      if (!tree.blocks[block].is_item(lane)) area += half_area(box_of(tree, block, lane));
  return area / half_area(tree.box);
}

/// The children of a node when it takes up to eight, of which the largest are opened first.
std::vector<Index> greedy_children(const Bvh<Aabb>& tree, Index node) {
  std::vector<Index> children{node};
  const auto size = [&](Index i) { return tree.nodes[i].is_leaf() ? -1 : half_area(tree.nodes[i].volume); };
  while (children.size() < WideBlock::width) {
    const auto largest =
        std::max_element(children.begin(), children.end(), [&](Index a, Index b) { return size(a) < size(b); });
    if (tree.nodes[*largest].is_leaf()) break;
    const Index first = tree.nodes[*largest].first;
    *largest = first;
    children.push_back(first + 1);
  }
  return children;
}

/// The same of the binary tree over single items, collapsed from the top by opening the largest boxes.
double blocks_met_greedily(std::span<const Aabb> boxes) {
  const Bvh<Aabb> tree = build_bvh(boxes, {.leaf_size = 1});
  double area = 0;
  std::vector<Index> open{0};
  while (!open.empty()) {
    const Index node = open.back();
    open.pop_back();
    area += half_area(tree.nodes[node].volume);
    for (const Index child : greedy_children(tree, node))
      if (!tree.nodes[child].is_leaf()) open.push_back(child);
  }
  return area / half_area(tree.nodes[0].volume);
}

void check_quality(const TriangleMesh& mesh) {
  const auto boxes = boxes_of(mesh);
  const WideBvh tree = build_wide_bvh(boxes, {.threads = 2});
  EXPECT_LE(bytes_per_item(tree), 60);
  EXPECT_LE(blocks_met(tree), 0.97 * blocks_met_greedily(boxes));
}

TEST(WideBuild, MeshesFillTheirBlocksAndBoxesAreSmall) {
  check_quality(generate_mesh("noise-sphere", {{"subdivisions", 5}}));
  check_quality(generate_mesh("torus-knot"));
}

TEST(WideBuild, RealMeshesFillTheirBlocksAndBoxesAreSmall) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA";
  for (const char* name : {"stanford-bunny.obj", "fandisk.obj", "teapot.obj", "rocker-arm.obj", "env.obj"}) {
    SCOPED_TRACE(name);
    check_quality(read_mesh(*data / "meshes" / name));
  }
}

}  // namespace
}  // namespace toccata::test
