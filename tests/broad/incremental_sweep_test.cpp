#include "broad/incremental_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "broad/box_families.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

/// Boxes shown to the method itself, so that it can be asked what it did.
class ShownBoxes {
 public:
  explicit ShownBoxes(std::size_t count) {
    // As dense as each other, however many.
    const double side = std::cbrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) boxes_.push_back(box(side));
    std::vector<Index> all(count);
    std::iota(all.begin(), all.end(), Index{0});
    show(all);
  }
  /// `count` boxes go, and as many come in other places.
  std::vector<Index> replace(std::size_t count) {
    const double side = std::cbrt(static_cast<double>(boxes_.size()));
    std::vector<Index> changed;
    for (std::size_t i = 0; i < count; ++i) {
      const Index gone = static_cast<Index>(random_.below(boxes_.size()));
      if (is_empty(boxes_[gone])) continue;
      boxes_[gone] = {};
      changed.push_back(gone);
    }
    for (std::size_t i = 0; i < count; ++i) {
      changed.push_back(static_cast<Index>(boxes_.size()));
      boxes_.push_back(box(side));
    }
    return changed;
  }
  std::vector<Index> nudge(std::size_t count) {
    std::vector<Index> changed;
    for (Index number = 0; number < boxes_.size() && changed.size() < count; ++number) {
      if (is_empty(boxes_[number])) continue;
      const Vec3 by = test::vector_between(random_, -1e-3, 1e-3);
      boxes_[number] = {boxes_[number].lower + by, boxes_[number].upper + by};
      changed.push_back(number);
    }
    return changed;
  }
  void show(const std::vector<Index>& changed) { pairs_ = sweep_.find({boxes_, changed, pairs_, 1}, {}); }
  [[nodiscard]] bool is_right() const { return pairs_ == overlapping_pairs_by_brute_force(boxes_); }
  [[nodiscard]] const IncrementalSweep::Work& work() const { return sweep_.work(); }
  [[nodiscard]] const PairList& pairs() const { return pairs_; }

 private:
  [[nodiscard]] Aabb box(double side) {
    return test::box_around_point(test::vector_between(random_, 0, side), test::vector_between(random_, 0.2, 0.6));
  }

  Random random_{4};
  std::vector<Aabb> boxes_;
  IncrementalSweep sweep_;
  PairList pairs_;
};

TEST(IncrementalSweep, SortsNothingAnewWhereSomeComeAndGo) {
  ShownBoxes boxes(2'000);
  EXPECT_TRUE(boxes.work().sorted_anew);
  for (int frame = 0; frame < 8; ++frame) {
    boxes.show(boxes.replace(40));
    EXPECT_FALSE(boxes.work().sorted_anew);
    EXPECT_EQ(boxes.work().swaps, 0U) << "nothing moved";
    EXPECT_TRUE(boxes.is_right());
  }
  EXPECT_GT(boxes.pairs().size(), 500U);
}

TEST(IncrementalSweep, TestsOnlyWhatComesAndOnlyWithWhatItOverlapsAlongAnAxis) {
  ShownBoxes boxes(2'000);
  boxes.show(boxes.replace(20));
  // A box is about 0.8 long, and the space 12.6: a box that comes overlaps one in eight along an axis.
  EXPECT_GT(boxes.work().tests, 20U * 2'000 / 16);
  EXPECT_LT(boxes.work().tests, 20U * 2'000 / 5);
  boxes.show(boxes.nudge(100));
  EXPECT_EQ(boxes.work().tests, 0U);
  EXPECT_GT(boxes.work().swaps, 0U);
  EXPECT_FALSE(boxes.work().sorted_anew);
  EXPECT_TRUE(boxes.is_right());
}

/// The lecture: coherence fails for bouncing objects. In a pile the ends of a layer all lie within the way that a box
/// trembles, and pass each other all the time.
TEST(IncrementalSweep, KeepsUpWithWhatMovesLittleAndNotWithAPile) {
  for (const std::string scene : {"uniform", "static", "pile"}) {
    SCOPED_TRACE(scene);
    Crowd crowd(scene, 2'000);
    IncrementalSweep sweep;
    std::vector<Index> all(crowd.boxes().size());
    std::iota(all.begin(), all.end(), Index{0});
    PairList pairs = sweep.find({crowd.boxes(), all, {}, 1}, {});
    for (int frame = 0; frame < 3; ++frame) {
      const std::span<const Index> moved = crowd.step();
      pairs = sweep.find({crowd.boxes(), moved, pairs, 1}, {});
      EXPECT_EQ(sweep.work().sorted_anew, scene == "pile");
      EXPECT_TRUE(pairs == overlapping_pairs_by_brute_force(crowd.boxes()));
    }
  }
}

TEST(IncrementalSweep, MovesAndBatchesInOneUpdate) {
  ShownBoxes boxes(600);
  for (int frame = 0; frame < 20; ++frame) {
    std::vector<Index> changed = boxes.nudge(100);
    for (const Index number : boxes.replace(15))
      if (std::find(changed.begin(), changed.end(), number) == changed.end()) changed.push_back(number);
    boxes.show(changed);
    EXPECT_FALSE(boxes.work().sorted_anew);
    EXPECT_TRUE(boxes.is_right());
  }
}

TEST(IncrementalSweep, FindsAllAnewWhereMostAreNew) {
  ShownBoxes boxes(300);
  boxes.show(boxes.replace(200));
  EXPECT_TRUE(boxes.work().sorted_anew);
  EXPECT_TRUE(boxes.is_right());
  boxes.show(boxes.replace(10));
  EXPECT_FALSE(boxes.work().sorted_anew);
  EXPECT_TRUE(boxes.is_right());
}

}  // namespace
}  // namespace toccata
