// The page of a crowd: what it holds is what the broad phase found, and it stays within what a page may hold.
#include "toccata/reports/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/page.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;

Json header_of(const std::string& page) { return test::Page(page).header; }

CrowdRecording recording_of(const char* scene, std::size_t count, int frames, BroadPhaseMethod method) {
  Crowd crowd(scene, count);
  BroadPhase phase({method, 1});
  phase.add(crowd.boxes());
  CrowdRecording recording;
  for (int frame = 0; frame < frames; ++frame) {
    const std::span<const Index> moved = frame == 0 ? std::span<const Index>{} : crowd.step();
    std::vector<Aabb> to;
    for (const Index number : moved) to.push_back(crowd.boxes()[number]);
    phase.move(moved, to);
    phase.update();
    recording.add(phase);
  }
  return recording;
}

TEST(CrowdPage, HoldsBoxesPairsAndCellsOfEveryFrame) {
  const CrowdRecording recording = recording_of("static", 300, 5, BroadPhaseMethod::uniform_grid);
  const Json header = header_of(crowd_page(recording, {.title = "</script>"}));
  EXPECT_EQ(header["title"], "</script>");
  EXPECT_EQ(header["summary"], "300 boxes · 5 frames");
  ASSERT_EQ(header["time"]["moments"].size(), 5U);
  const Json& layers = header["layers"];
  ASSERT_EQ(layers.size(), 3U);
  for (std::size_t i = 0; i < 5; ++i) {
    const CrowdRecording::Frame& frame = recording.frames()[i];
    EXPECT_EQ(layers[0]["moments"][i], Json({300 * i, 300}));
    EXPECT_EQ(layers[1]["moments"][i][1], frame.pairs.size());
    EXPECT_GT(frame.pairs.size(), 100U);
    EXPECT_EQ(layers[2]["moments"][i][1], frame.space.cells.size());
  }
  EXPECT_EQ(layers[0]["data"]["count"], 7 * 5 * 300);
  std::size_t movers = 0;
  for (Index i = 0; i < 300; ++i) {
    const bool is_elsewhere = recording.frames().front().boxes[i] != recording.frames().back().boxes[i];
    EXPECT_EQ(recording.has_moved(i), is_elsewhere);
    movers += is_elsewhere ? 1 : 0;
  }
  EXPECT_GT(movers, 5U);
  EXPECT_LT(movers, 30U);
}

TEST(CrowdPage, OfAMethodWithoutCellsHasNoLayerOfThem) {
  const Json header = header_of(crowd_page(recording_of("uniform", 40, 2, BroadPhaseMethod::brute_force)));
  EXPECT_EQ(header["layers"].size(), 2U);
}

TEST(CrowdPage, HoldsEverySecondFrameWhenThereAreTooMany) {
  const CrowdRecording recording = recording_of("uniform", 20'000, 60, BroadPhaseMethod::uniform_grid);
  EXPECT_EQ(recording.seen(), 60U);
  EXPECT_GT(recording.stride(), 1U);
  EXPECT_EQ(recording.frames().size(), (59 / recording.stride()) + 1);
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const CrowdRecording::Frame& frame = recording.frames()[i];
    EXPECT_EQ(frame.number, i * recording.stride());
    bytes += 14 * (frame.boxes.size() + frame.space.cells.size()) + 4 * frame.pairs.size();
  }
  EXPECT_LE(bytes, CrowdRecording::most_bytes);
  EXPECT_GT(bytes, CrowdRecording::most_bytes / 4);

  // What has begun and ended is told against the frame that is shown before.
  const Json moments = header_of(crowd_page(recording))["time"]["moments"];
  for (std::size_t i = 1; i < recording.frames().size(); ++i) {
    const std::vector<IndexPair>&before = recording.frames()[i - 1].pairs, &now = recording.frames()[i].pairs;
    const auto stays = [&](const IndexPair& pair) { return std::binary_search(before.begin(), before.end(), pair); };
    const auto kept = static_cast<std::size_t>(std::count_if(now.begin(), now.end(), stays));
    const std::string told = std::to_string(now.size()) + " pairs, " + std::to_string(now.size() - kept) + " begun, " +
                             std::to_string(before.size() - kept) + " ended; ";
    EXPECT_EQ(moments[i]["note"].get<std::string>().find(told), 0U) << moments[i]["note"];
  }
}

TEST(CrowdPage, RefusesAFrameThatIsMoreThanAPage) {
  BroadPhase phase;
  std::vector<Aabb> boxes;
  for (int i = 0; i < 1'200'000; ++i) boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  phase.add(boxes);
  phase.update();
  CrowdRecording recording;
  try {
    recording.add(phase);
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "a frame of 1200000 boxes takes 17 MB in a page, which may hold 16 MB: show fewer, at most about 1028571");
  }
  EXPECT_TRUE(recording.frames().empty());
}

TEST(CrowdPage, IsOfAnyBoxes) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();
  for (const BroadPhaseMethod method : broad_phase_methods()) {
    BroadPhase phase({method, 1});
    const std::vector<Index> numbers = phase.add(
        std::vector<Aabb>{{{-most, 0, 0}, {most, 1, 1}}, {{-infinity, 0, 0}, {infinity, 1, infinity}}, Aabb{}});
    phase.update();
    CrowdRecording recording;
    recording.add(phase);
    phase.remove(std::vector<Index>{numbers[0]});
    EXPECT_THROW(recording.add(phase), Error);
    phase.update();
    recording.add(phase);
    const Json header = header_of(crowd_page(recording));
    EXPECT_EQ(header["layers"][1]["moments"], Json::parse("[[0,1],[1,0]]")) << name_of(method);
  }
  EXPECT_THROW((void)crowd_page(CrowdRecording{}), Error);
}

}  // namespace
}  // namespace toccata
