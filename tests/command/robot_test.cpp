#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "support/page.hpp"
#include "toccata/robots/robot_files.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using RobotReport = nlohmann::json;

bool is_told(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class RobotCommand : public ::testing::Test {
 protected:
  RobotCommand() { folder_.write("q.csv", "0 0 0 0 0 0 0\n0 1.5 0 1.9 0 1 0\n0 0.1 0 0.1 0 0 0\n"); }

  [[nodiscard]] test::CommandResult robot(std::vector<std::string> words) const {
    words.insert(words.begin(), "robot");
    return run_command(words, folder_.path());
  }

  [[nodiscard]] RobotReport report(std::vector<std::string> words, int exit_code) const {
    words.emplace_back("--json");
    const auto run = robot(std::move(words));
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    return RobotReport::parse(run.out);
  }

  TemporaryFolder folder_;
};

TEST_F(RobotCommand, TellsWhatMeetsAtConfigurationsAndBetween) {
  const RobotReport json =
      report({"gen:arm", "--scene", "gen:torus?radius=0.5", "--configurations", "q.csv", "--edges", "--distance"}, 1);
  EXPECT_EQ(json["links"].size(), 8U);
  EXPECT_EQ(json["obstacles"], (std::vector<std::string>{"torus"}));
  ASSERT_EQ(json["configurations"].size(), 3U);
  EXPECT_FALSE(json["configurations"][0]["meets"]);
  EXPECT_GT(json["configurations"][0]["distance"]["upper"], 0);
  EXPECT_TRUE(json["configurations"][1]["meets"]);
  EXPECT_EQ(json["configurations"][1]["distance"]["upper"], 0);
  EXPECT_EQ(json["configurations"][1]["contacts"][0]["other"], "torus");
  ASSERT_EQ(json["edges"].size(), 2U);
  EXPECT_FALSE(json["edges"][0]["free"]);
  EXPECT_EQ(json["edges"][1]["upper"], 0);
  EXPECT_EQ(robot({"gen:arm"}).exit_code, 0);
}

TEST_F(RobotCommand, ThreadsChangeNoByte) {
  const std::vector<std::string> words{"gen:arm",          "--scene", "gen:torus?radius=0.5",
                                       "--configurations", "q.csv",   "--edges",
                                       "--distance",       "--json",  "--threads"};
  std::vector<std::string> one = words, three = words;
  one.emplace_back("1");
  three.emplace_back("3");
  EXPECT_EQ(robot(one).out, robot(three).out);
}

TEST_F(RobotCommand, AWrittenRobotAnswersAsTheGeneratedOne) {
  if (!reads_urdf()) GTEST_SKIP() << "urdfdom was not there when this was built";
  EXPECT_EQ(robot({"gen:arm", "--write-urdf", "arm"}).exit_code, 0);
  const auto of = [&](const std::string& file) {
    return report({file, "--scene", "gen:torus?radius=0.5", "--configurations", "q.csv", "--edges"}, 1);
  };
  const RobotReport read = of("arm/robot.urdf"), generated = of("gen:arm");
  EXPECT_EQ(read["configurations"], generated["configurations"]);
  EXPECT_EQ(read["edges"], generated["edges"]);
  const auto srdf = robot({"arm/robot.urdf", "--find-allowed", "200"});
  EXPECT_EQ(srdf.exit_code, 0);
  folder_.write("arm.srdf", srdf.out);
  EXPECT_EQ(robot({"arm/robot.urdf", "--srdf", "arm.srdf"}).exit_code, 0);
}

TEST_F(RobotCommand, ACloudIsAnObstacle) {
  folder_.write("cloud.txt", "0 0 1.2\n5 5 5\n");
  const RobotReport json = report({"gen:arm", "--cloud", "cloud.txt", "--radius", "0.05"}, 1);
  EXPECT_EQ(json["configurations"][0]["contacts"][0]["other"], "cloud");
}

TEST_F(RobotCommand, APageIsWritten) {
  const auto run = robot(
      {"gen:arm", "--configurations", "q.csv", "--edges", "--html", "arm.html", "--scene", "gen:torus?radius=0.5"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_TRUE(is_told(test::page_text(folder_ / "arm.html"), "generated arm"));
}

TEST_F(RobotCommand, TroubleIsNamed) {
  const auto trouble = [&](const std::vector<std::string>& words) {
    const auto run = robot(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  folder_.write("bad.csv", "0 0 0 0 0 0 0\n0 0 9 0 0 0 0\n");
  EXPECT_TRUE(is_told(trouble({"gen:arm", "--configurations", "bad.csv"}),
                      "bad.csv:2: the position of 'joint 3' is 9, beyond its limits"));
  EXPECT_TRUE(is_told(trouble({"none.urdf"}), "none.urdf"));
  EXPECT_TRUE(is_told(trouble({"gen:arm", "--scene", "none.obj"}), "none.obj"));
  EXPECT_NE(trouble({"gen:arm", "--edges"}), "");
}

}  // namespace
}  // namespace toccata
