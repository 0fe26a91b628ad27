#include "broad/automatic.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

using Method = BroadPhaseMethod;

/// `auto`, whose clock goes on only while a method works, by what is written here. All boxes have just come.
class ScriptedAuto {
 public:
  ScriptedAuto(const std::string& scene, std::size_t count, std::map<Method, double> milliseconds)
      : milliseconds_(std::move(milliseconds)),
        boxes_(Crowd(scene, count).boxes()),
        all_(count),
        automatic_(make_automatic(
            {[this] { return now_; }, [this](Method method) { return std::make_unique<Worker>(*this, method); }})) {
    std::iota(all_.begin(), all_.end(), Index{0});
    update(1);
    worked_.clear();
  }

  void takes(Method method, double milliseconds) { milliseconds_[method] = milliseconds; }
  /// Gives how often the method chosen was another than before.
  int update(int times, double moving = 1) {
    int changes = 0;
    const auto changed =
        std::span<const Index>(all_).first(static_cast<std::size_t>(moving * static_cast<double>(all_.size())));
    for (int i = 0; i < times; ++i) {
      const Method before = chosen();
      (void)automatic_->find({boxes_, changed, {}}, {});
      changes += chosen() == before ? 0 : 1;
    }
    return changes;
  }
  [[nodiscard]] Method chosen() const { return automatic_->chosen(); }
  [[nodiscard]] std::string reason() const { return automatic_->reason(); }
  [[nodiscard]] std::ptrdiff_t updates_by(Method method) const {
    return std::count(worked_.begin(), worked_.end(), method);
  }

 private:
  class Worker final : public PairFinder {
   public:
    Worker(ScriptedAuto& script, Method method) : script_(script), method_(method) {}
    PairList find(const BoxesNow&, PairList storage) override {
      script_.now_ += script_.milliseconds_.at(method_);
      script_.worked_.push_back(method_);
      return storage;
    }
    [[nodiscard]] std::size_t bytes() const override { return 0; }

   private:
    ScriptedAuto& script_;
    Method method_;
  };

  double now_ = 0;
  std::map<Method, double> milliseconds_;
  std::vector<Aabb> boxes_;
  std::vector<Index> all_;
  std::vector<Method> worked_;
  std::unique_ptr<PairFinder> automatic_;
};

/// About what 2000 boxes take.
const std::map<Method, double> similar{{Method::uniform_grid, 0.2},
                                       {Method::sort_and_sweep, 0.18},
                                       {Method::kd_tiles, 0.3},
                                       {Method::brute_force, 1},
                                       {Method::layers, 0.02}};

TEST(Automatic, KeepsWhatIsSlowerByLessThanAFifth) {
  ScriptedAuto script("uniform", 2000, similar);
  EXPECT_EQ(script.update(1000), 1);  // the first
  EXPECT_EQ(script.chosen(), Method::uniform_grid);
  EXPECT_GE(script.updates_by(Method::sort_and_sweep), 3);
  EXPECT_LE(script.updates_by(Method::sort_and_sweep), 60);
}

TEST(Automatic, LeavesWhatHasBecomeSlowerAndDoesNotComeBackForATenth) {
  ScriptedAuto script("uniform", 2000, similar);
  script.update(100);
  script.takes(Method::uniform_grid, 0.4);
  EXPECT_EQ(script.update(400), 1);
  EXPECT_EQ(script.chosen(), Method::sort_and_sweep);
  script.takes(Method::uniform_grid, 0.162);
  EXPECT_EQ(script.update(1000), 0);
  script.takes(Method::uniform_grid, 0.1);
  EXPECT_EQ(script.update(2000), 1);
  EXPECT_EQ(script.chosen(), Method::uniform_grid);
}

TEST(Automatic, EndsATrialThatCannotWin) {
  for (const bool is_near : {false, true}) {
    ScriptedAuto script("uniform", 2000, similar);
    script.takes(Method::sort_and_sweep, is_near ? 0.18 : 0.28);
    script.update(20);
    EXPECT_EQ(script.updates_by(Method::sort_and_sweep), is_near ? 3 : 2);
  }
}

/// However fast they would be by the clock.
TEST(Automatic, TriesNothingThatIsExpectedToBeMuchWorse) {
  ScriptedAuto script("sizes", 2000, similar);
  script.takes(Method::uniform_grid, 0.002);
  script.update(1000);
  EXPECT_EQ(script.updates_by(Method::uniform_grid), 0);
  EXPECT_EQ(script.chosen(), Method::sort_and_sweep);
}

/// A machine may be slower than expected, but not as slow as that: boxes lie otherwise than the sample says.
TEST(Automatic, DoubtsWhatItExpectedWhereTheBestTakesManyTimesAsLong) {
  for (const double times_as_long : {2.0, 20.0}) {
    ScriptedAuto script("uniform", 2000, similar);
    script.takes(Method::uniform_grid, 0.2 * times_as_long);
    script.takes(Method::sort_and_sweep, 0.2 * times_as_long);
    script.update(100);
    EXPECT_EQ(script.chosen(), times_as_long > 10 ? Method::kd_tiles : Method::uniform_grid);
  }
}

TEST(Automatic, FollowsTheMotionButNotEachTime) {
  ScriptedAuto script("uniform", 2000, similar);
  script.update(50);
  EXPECT_EQ(script.update(4, 0.01), 1);
  EXPECT_EQ(script.chosen(), Method::layers);
  EXPECT_EQ(script.update(100, 0.01), 0);
  EXPECT_EQ(script.update(4, 1), 1);
  EXPECT_NE(script.chosen(), Method::layers);
  int changes = 0;
  for (int i = 0; i < 200; ++i) changes += script.update(1, i % 2 == 0 ? 0.01 : 1);
  EXPECT_GE(changes, 1);
  EXPECT_LE(changes, 20);
}

/// The longer the motion goes back and forth, the more seldom it is followed.
TEST(Automatic, LosesItsPatienceWithMotionThatGoesBackAndForth) {
  ScriptedAuto script("uniform", 2000, similar);
  const auto changes_in = [&](int updates) {
    int changes = 0;
    for (int i = 0; i < updates; ++i) changes += script.update(1, i % 3 == 0 ? 0.01 : 1);
    return changes;
  };
  changes_in(600);
  EXPECT_LE(changes_in(1280), 1280 / 128 + 10);
  script.update(300);
  EXPECT_EQ(script.update(4, 0.01), 1) << "calm motion is followed at once again";
}

TEST(Automatic, TakesWhatComesForRestingUnlessItIsAskedOnce) {
  const std::vector<Aabb> boxes(Crowd("uniform", 2000).boxes());
  std::vector<Index> all(boxes.size());
  std::iota(all.begin(), all.end(), Index{0});
  for (const bool is_only : {false, true}) {
    const auto automatic = make_automatic(usual_means());
    const PairList found = automatic->find({boxes, all, {}, 1, nullptr, is_only}, {});
    EXPECT_EQ(automatic->chosen() == Method::layers, !is_only);
    EXPECT_EQ(found, make_pair_finder({Method::brute_force})->find({boxes, all, {}}, {}));
    if (is_only) continue;
    EXPECT_EQ(automatic->find({boxes, all, found}, {}), found);
    EXPECT_NE(automatic->chosen(), Method::layers);
  }
}

TEST(Automatic, SaysWhatTheBoxesAreLikeWhatItChoseAndWhatCameNext) {
  ScriptedAuto script("uniform", 2000, similar);
  EXPECT_TRUE(script.reason().starts_with("2000 boxes, of similar sizes, 0 % move: layers; next")) << script.reason();
  script.update(3);
  const std::string begin = "2000 boxes, of similar sizes, 100 % move: grid, 0.2 ms; next";
  const std::string first = script.reason();
  EXPECT_TRUE(first.starts_with(begin + " sort-and-sweep, expected to take 1.")) << first;
  EXPECT_TRUE(first.ends_with(" times as long, not tried")) << first;
  script.update(20);
  EXPECT_EQ(script.reason(), begin + " best sort-and-sweep, took 0.18 ms");
  script.update(4, 0.01);
  EXPECT_EQ(script.reason(),
            "2000 boxes, of similar sizes, 1 % move: layers, 0.02 ms; next best sort-and-sweep, took 0.18 ms");

  ScriptedAuto sizes("sizes", 2000, similar);
  sizes.update(1, 0.5);
  EXPECT_TRUE(sizes.reason().starts_with("2000 boxes, sizes over ")) << sizes.reason();
  EXPECT_NE(sizes.reason().find(" decades, 50 % move"), std::string::npos) << sizes.reason();
}

}  // namespace
}  // namespace toccata
