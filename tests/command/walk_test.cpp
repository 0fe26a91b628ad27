// A character that walks in a level, as a person or a script asks about it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/page.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// A floor, a step of 0.2 from x = 2 on, and a wall from x = 6 on that ends at y = 4.
constexpr const char* walk_level = R"({"format": "toccata-scene", "version": 1, "unit": "m", "objects": [
  {"name": "floor", "shape": {"type": "box", "half_extents": [9, 9, 0.5]}, "pose": {"translation": [0, 0, -0.5]}},
  {"name": "step", "shape": {"type": "box", "half_extents": [3, 9, 0.1]}, "pose": {"translation": [5, 0, 0.1]}},
  {"name": "wall", "shape": {"type": "box", "half_extents": [0.5, 4, 2]}, "pose": {"translation": [6.5, 0, 2]}}]})";

class WalkCommand : public testing::Test {
 protected:
  WalkCommand() { folder.write("level.json", walk_level); }
  test::CommandResult run(std::vector<std::string> words) {
    words.insert(words.begin(), {"walk", "level.json"});
    return run_command(words, folder.path());
  }
  std::string error_of(const std::vector<std::string>& words) {
    const auto failed = run(words);
    EXPECT_EQ(failed.exit_code, 2);
    EXPECT_EQ(failed.out, "");
    return failed.err;
  }
  TemporaryFolder folder;
};

TEST_F(WalkCommand, ItArrivesUpAStep) {
  const auto walked = run({"--from", "0", "0", "0", "--to", "4", "0", "0.2", "--json"});
  EXPECT_EQ(walked.exit_code, 0) << walked.err;
  const Json report = Json::parse(walked.out);
  EXPECT_EQ(report["schema"], "toccata/walk/1");
  EXPECT_EQ(report["end"], "arrived");
  const Json& last = report["steps"].back();
  EXPECT_EQ(last["ground"]["object"], "step");
  EXPECT_NEAR(last["position"][0].get<double>(), 4, 0.011);
  EXPECT_NEAR(last["position"][2].get<double>(), 0.21, 0.005);
  EXPECT_EQ(last["position"], report["position"]);
  int climbed = 0;
  for (const Json& step : report["steps"]) climbed += step["stepped"].get<bool>() ? 1 : 0;
  EXPECT_GE(climbed, 1);
}

TEST_F(WalkCommand, AWallHindersIt) {
  const auto walked = run({"--from", "3", "0", "0.2", "--to", "8", "0", "0.2"});
  EXPECT_EQ(walked.exit_code, 1) << walked.err;
  EXPECT_NE(walked.out.find("it gets no nearer to (8, 0, 0.2)"), std::string::npos) << walked.out;
  EXPECT_NE(walked.out.find("wall"), std::string::npos) << walked.out;
  EXPECT_EQ(walked.out.find("floor"), std::string::npos) << walked.out;
}

TEST_F(WalkCommand, MotionsAreTakenOneByOne) {
  folder.write("round.txt", "0 0 -0.1\n0 1 0\n0 4 0 # beside the wall\n4 0 0\n");
  const auto walked = run({"--from", "3", "0", "0.25", "--motion", "round.txt", "--csv"});
  EXPECT_EQ(walked.exit_code, 0) << walked.err;
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < walked.out.size(); at = walked.out.find('\n', at) + 1)
    lines.push_back(walked.out.substr(at, walked.out.find('\n', at) - at));
  ASSERT_EQ(lines.size(), 5U) << walked.out;
  EXPECT_EQ(lines[0], "step,x,y,z,ground,contacts,met_wall,met_ceiling,stepped,tight,stuck,crushed,cut_short");
  EXPECT_NEAR(std::stod(lines[4].substr(2)), 7, 1e-9) << walked.out;
  EXPECT_NE(lines[4].find(",step,"), std::string::npos) << walked.out;
}

TEST_F(WalkCommand, TheSkinIsNoWiderThanTheWalker) {
  for (const char* skin : {"0", "0.41", "1e9"}) {
    const auto refused = run({"--from", "0", "0", "0", "--to", "1", "0", "0", "--skin", skin});
    EXPECT_EQ(refused.exit_code, 2) << skin;
    EXPECT_NE(refused.err.find("no more than its radius, 0.4"), std::string::npos) << refused.err;
  }
}

TEST_F(WalkCommand, WhoLeavesTheLevelFalls) {
  const auto walked = run({"--from", "-8", "0", "0", "--to", "-20", "0", "0"});
  EXPECT_EQ(walked.exit_code, 1) << walked.err;
  EXPECT_NE(walked.out.find("it falls, and nothing is below it"), std::string::npos) << walked.out;
}

TEST_F(WalkCommand, StandardLengthsAreMetresOfTheScene) {
  folder.write("small.json", R"({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [
    {"name": "floor", "shape": {"type": "half-space", "point": [0, 0, 0], "normal": [0, 0, 1]}}]})");
  const auto walked =
      run_command({"walk", "small.json", "--from", "0", "0", "0", "--to", "1000", "0", "0", "--height", "2m", "--json"},
                  folder.path());
  EXPECT_EQ(walked.exit_code, 0) << walked.err;
  const Json walk = Json::parse(walked.out)["walk"];
  EXPECT_EQ(walk["walker"]["radius"], 400);
  EXPECT_EQ(walk["walker"]["end"], (Json{0, 0, 1600}));
  EXPECT_EQ(walk["options"]["skin"], 10);
  EXPECT_EQ(walk["stride"], 100);
}

TEST_F(WalkCommand, YIsUpWhereItIsSaid) {
  folder.write("flat.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "floor", "shape": {"type": "half-space", "point": [0, 0, 0], "normal": [0, 1, 0]}}]})");
  const auto walked = run_command(
      {"walk", "flat.json", "--from", "0", "1", "0", "--to", "0", "0", "1", "--up", "y", "--json"}, folder.path());
  EXPECT_EQ(walked.exit_code, 0) << walked.err << walked.out;
  EXPECT_NEAR(Json::parse(walked.out)["position"][1].get<double>(), 0.01, 0.002);
}

TEST_F(WalkCommand, ACaseIsAskedAgain) {
  const auto saved = run({"--from", "0", "0", "0", "--to", "3", "0", "0.2", "--save-case", "case.json"});
  EXPECT_EQ(saved.exit_code, 0) << saved.err;
  const auto again = run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST_F(WalkCommand, BesideACaseNoOptionIsUnheard) {
  EXPECT_EQ(run({"--from", "0", "0", "0", "--to", "1", "0", "0", "--save-case", "case.json"}).exit_code, 0);
  EXPECT_EQ(run_command({"walk", "case.json", "--json"}, folder.path()).exit_code, 0);
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--stride", "0.1"},
                                                 {"--most-steps", "10000"},
                                                 {"--skin", "0.01"},
                                                 {"--max-slope", "45"},
                                                 {"--radius", "0.4"},
                                                 {"--height", "1.8"},
                                                 {"--fall", "0.01"},
                                                 {"--step-height", "0.3"},
                                                 {"--snap", "0.3"},
                                                 {"--up", "z"},
                                                 {"--solid", "auto"}}) {
    std::vector<std::string> words{"walk", "case.json"};
    words.insert(words.end(), option.begin(), option.end());
    const auto refused = run_command(words, folder.path());
    EXPECT_EQ(refused.exit_code, 2) << option[0];
    EXPECT_NE(refused.err.find("as " + option[0] + " asks another"), std::string::npos) << refused.err;
  }
}

TEST_F(WalkCommand, ARecordedWalkIsDrawn) {
  const auto walked =
      run({"--from", "0", "0", "0", "--to", "8", "0", "0.2", "--json", "--html", "now.html", "--glb", "now.glb"});
  EXPECT_EQ(walked.exit_code, 1) << walked.err;
  folder.write("walk.json", walked.out);
  const auto drawn = run_command({"view", "walk.json", "-o", "later.html"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("a walk of "), std::string::npos) << drawn.out;
  const std::string now = test::page_text(folder.path() / "now.html"),
                    later = test::page_text(folder.path() / "later.html");
  for (const std::string& page : {now, later})
    for (const char* told : {"\"Path\"", "\"Normals\"", "\"Contact points\"", "on step, meets wall", ", up a step"})
      EXPECT_NE(page.find(told), std::string::npos) << told;
  EXPECT_EQ(test::text_of(folder.path() / "now.glb").substr(0, 4), "glTF");
}

TEST_F(WalkCommand, ErrorsSayWhatToDo) {
  folder.write("bad.txt", "0 0 0\n1 2\n");
  EXPECT_NE(error_of({"--to", "1", "0", "0"}).find("name the point that it stands on with --from"), std::string::npos);
  EXPECT_NE(error_of({"--from", "1", "0", "0"}).find("name a point with --to X Y Z, or a file"), std::string::npos);
  EXPECT_NE(error_of({"--from", "0", "0", "0", "--motion", "bad.txt"}).find("bad.txt:2"), std::string::npos);
  for (const std::vector<std::string>& of_a_place :
       {std::vector<std::string>{"--to", "1", "0", "0"}, {"--stride", "0.2"}, {"--most-steps", "10000"}}) {
    std::vector<std::string> words{"--from", "0", "0", "0", "--motion", "bad.txt"};
    words.insert(words.end(), of_a_place.begin(), of_a_place.end());
    const std::string error = error_of(words);
    EXPECT_NE(error.find(of_a_place[0] == "--to" ? " excludes " : " is about a walk --to a point; "), std::string::npos)
        << error;
    for (const std::string& option : {std::string("--motion"), of_a_place[0]})
      EXPECT_NE(error.find(option), std::string::npos) << error;
  }
  const std::vector<std::string> way{"--from", "0", "0", "0", "--to", "1", "0", "0"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = way;
    words.insert(words.end(), more.begin(), more.end());
    return error_of(words);
  };
  EXPECT_NE(with({"--height", "0.5"}).find("say another --height or --radius"), std::string::npos);
  EXPECT_NE(with({"--radius", "0"}).find("--radius 0"), std::string::npos);
  EXPECT_NE(with({"--stride", "0"}).find("stride is 0; it has to be a length above 0"), std::string::npos);
  EXPECT_NE(with({"--stride", "far"}).find("--stride far"), std::string::npos);
  EXPECT_NE(with({"--max-slope", "90"}).find("from 0 to less than 90 degrees"), std::string::npos);
  EXPECT_NE(with({"--skin", "0"}).find("skin of the walker is 0"), std::string::npos);
}

}  // namespace
}  // namespace toccata
