#include "robots/obstacle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/constants.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

Vec3 between(Random& random, double low, double high) {
  return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

/// Every tenth is empty, and one in a hundred has no end.
std::vector<Aabb> some_boxes(std::size_t count, double spread, Random& random) {
  std::vector<Aabb> boxes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 centre = between(random, -spread, spread), half = between(random, 0, 0.1 * spread);
    if (i % 10 != 3) boxes[i] = {centre - half, centre + half};
    if (i % 100 == 50) boxes[i].upper.y = infinity;
  }
  return boxes;
}

TurnedBox some_turned_box(double spread, Random& random) {
  const Quaternion turn{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
  const Vec3 half = between(random, 0, 0.3 * spread);
  return turned_box({between(random, -0.1 * spread, 0.1 * spread), half, 3 * spread},
                    Pose::rigid(turn, between(random, -spread, spread)));
}

double distance_of_point(const Vec3& point, const Aabb& box) {
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    const double beyond = std::max({box.lower[i] - point[i], point[i] - box.upper[i], 0.0});
    squared += beyond * beyond;
  }
  return std::sqrt(squared);
}

TEST(ObstacleTree, SeesAllThatIsWithinTheDistanceAndNotMuchMore) {
  Random random(7);
  for (const double spread : {1.0, 1e-9, 1e12}) {
    const std::vector<Aabb> boxes = some_boxes(400, spread, random);
    const ObstacleTree tree(boxes);
    std::size_t seen_count = 0, within_count = 0;
    for (int question = 0; question < 100; ++question) {
      const TurnedBox box = some_turned_box(spread, random);
      const double distance = question % 2 == 0 ? 0 : random.between(0, 0.2 * spread);
      std::set<Index> seen;
      tree.visit_near(box, distance, [&](Index number) { return seen.insert(number).second; });
      for (const Index number : seen) seen_count += boxes[number].upper.y < infinity ? 1U : 0U;
      for (Index i = 0; i < boxes.size(); ++i) {
        if (is_empty(boxes[i])) {
          EXPECT_FALSE(seen.contains(i));
          continue;
        }
        bool is_within = false;
        for (int sample = 0; sample < 60 && !is_within; ++sample) {
          Vec3 point = box.centre;
          for (const Vec3& edge : box.edges) point = point + std::clamp(random.between(-2, 2), -1.0, 1.0) * edge;
          is_within = distance_of_point(point, boxes[i]) <= distance;
        }
        within_count += is_within ? 1U : 0U;
        EXPECT_TRUE(!is_within || seen.contains(i))
            << "spread " << spread << ", question " << question << ", box " << i;
      }
    }
    EXPECT_GT(within_count, 300U);
    EXPECT_LT(seen_count, 2 * within_count);
  }
}

TEST(ObstacleTree, EndsWhereNoMoreIsWanted) {
  Random random(3);
  const ObstacleTree tree(some_boxes(300, 1, random));
  int seen = 0;
  tree.visit_near(turned_box({{}, {2, 2, 2}, 2}, {}), 0, [&](Index) { return ++seen < 5; });
  EXPECT_EQ(seen, 5);
  ObstacleTree().visit_near(turned_box({{}, {2, 2, 2}, 2}, {}), 0, [&](Index) { return ++seen < 5; });
  EXPECT_EQ(seen, 5);
}

TEST(ObstacleTree, OfWhatNothingIsKnownEveryBoxIsNear) {
  Random random(5);
  const std::vector<Aabb> boxes = some_boxes(100, 1, random);
  std::size_t seen = 0;
  TurnedBox unknown;
  unknown.slack = infinity;
  ObstacleTree(boxes).visit_near(unknown, 0, [&](Index) { return ++seen > 0; });
  EXPECT_EQ(seen, static_cast<std::size_t>(std::ranges::count_if(boxes, [](const Aabb& b) { return !is_empty(b); })));
}

}  // namespace
}  // namespace toccata
