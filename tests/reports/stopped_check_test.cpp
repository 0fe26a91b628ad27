// Who looks on while `check` asks: pairs are told as they are found, and it can be stopped between two of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {
namespace {

/// Boxes in a row, each of which overlaps the next.
Scene row_of_boxes(int count) {
  Scene scene = read_scene("gen:box");
  const SceneObject box = scene.objects[0];
  scene.objects.clear();
  for (int i = 0; i < count; ++i) {
    scene.objects.push_back(box);
    scene.objects.back().name = "box " + std::to_string(i);
    scene.objects.back().pose = Pose::translation(0.75 * i, 0, 0);
  }
  return scene;
}

CheckReport checked(const Scene& scene, const AskOptions& options) {
  return std::get<CheckReport>(ask(scene_models(scene), CheckQuestion{}, options));
}

TEST(StoppedCheck, EveryPairThatIsReportedIsToldOnceAsItIsReported) {
  const Scene scene = row_of_boxes(50);
  for (const int threads : {1, 4}) {
    std::vector<std::string> told, reported;
    AskOptions options{.threads = threads};
    options.found = [&](const CheckReport& one) {
      ASSERT_EQ(one.pairs.size(), 1U);
      told.push_back(pair_line_json(scene, one, 0));
    };
    const CheckReport report = checked(scene, options);
    for (std::size_t i = 0; i < report.pairs.size(); ++i) reported.push_back(pair_line_json(scene, report, i));
    if (threads > 1) std::sort(told.begin(), told.end());
    if (threads > 1) std::sort(reported.begin(), reported.end());
    EXPECT_EQ(told, reported);
    EXPECT_EQ(report.pairs.size(), 49U);
    EXPECT_EQ(report.unfinished, 0U);
  }
}

TEST(StoppedCheck, PairsThatAreToldNeedNotBeKept) {
  const Scene scene = row_of_boxes(50);
  const CheckReport whole = checked(scene, {.threads = 1});
  std::size_t told = 0;
  AskOptions options{.threads = 4};
  options.found = [&](const CheckReport&) { ++told; };
  options.keeps_found = false;
  const CheckReport report = checked(scene, options);
  EXPECT_TRUE(report.pairs.empty());
  EXPECT_EQ(report.not_kept, whole.pairs.size());
  EXPECT_EQ(told, whole.pairs.size());
  EXPECT_EQ(report.candidate_pairs, whole.candidate_pairs);
  EXPECT_EQ(report.unfinished, 0U);
  EXPECT_EQ(whole.not_kept, 0U);

  CheckQuestion sorted;
  sorted.order = PairOrder::severity;
  EXPECT_THROW((void)ask(scene_models(scene), sorted, options), Error);
  options.found = {};  // nobody has seen them
  EXPECT_EQ(checked(scene, options).pairs.size(), whole.pairs.size());
}

TEST(StoppedCheck, WhatIsLeftIsCountedAndWhatIsToldIsRight) {
  const Scene scene = row_of_boxes(50);
  const CheckReport whole = checked(scene, {.threads = 1});
  for (const int stop_after : {0, 1, 20, 48}) {
    std::atomic<int> asked = 0;
    AskOptions options{.threads = 1};
    options.stop = [&] { return asked++ >= stop_after; };
    const CheckReport report = checked(scene, options);
    EXPECT_EQ(report.candidate_pairs, whole.candidate_pairs);
    EXPECT_EQ(report.unfinished, whole.candidate_pairs - static_cast<std::size_t>(stop_after));
    ASSERT_EQ(report.pairs.size(), static_cast<std::size_t>(stop_after));
    for (std::size_t i = 0; i < report.pairs.size(); ++i) EXPECT_EQ(report.pairs[i].relation, whole.pairs[i].relation);
  }
}

}  // namespace
}  // namespace toccata
