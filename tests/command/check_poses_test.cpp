// `toccata check A B --poses F`: a line per query.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

const std::string rows = "1 0 0 0 1 0 0 0 1 ";

/// The boxes have the side 1 and a corner in the origin of their files.
class CheckPoses : public testing::Test {
 protected:
  TemporaryFolder folder;

  void SetUp() override {
    const char* box =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    folder.write("a.obj", box);
    folder.write("b.obj", box);
    folder.write("poses.txt", "# apart, touching, overlapping, apart\n" + rows + "2 0 0\n" + rows + "1 0 0\n" + rows +
                                  "5 0 0 " + rows + "5.5 0.25 0.125\n" + rows + "5 0 0, " + rows + "0 0 0\n");
  }

  test::CommandResult check(std::vector<std::string> words) {
    words.insert(words.begin(), {"check", "a.obj", "b.obj", "--poses", "poses.txt"});
    return run_command(words, folder.path());
  }
};

TEST_F(CheckPoses, TableHasALinePerQuery) {
  const auto result = check({});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(result.out,
            "  query 0  a  is apart from  b  (both solids)\n"
            "  query 1  a  touches        b  (both solids)\n"
            "  query 2  a  overlaps       b  (both solids)\n"
            "  query 3  a  is apart from  b  (both solids)\n"
            "2 of 4 queries in contact, decided exactly.\n");
}

TEST_F(CheckPoses, DepthsAreOfWhatMeets) {
  const std::string out = check({"--penetration"}).out;
  EXPECT_NE(out.find("query 0  a  is apart from  b  (both solids)\n"), std::string::npos) << out;
  EXPECT_NE(out.find("query 1  a  touches        b  (both solids)  0 deep\n"), std::string::npos) << out;
  EXPECT_NE(out.find("query 2  a  overlaps       b  (both solids)  0.5 deep along ("), std::string::npos) << out;
}

TEST_F(CheckPoses, CsvHasALinePerQuery) {
  EXPECT_EQ(check({"--csv"}).out,
            "query,relation,containment,side_unresolved,status,contact\n"
            "0,apart,none,false,exact,false\n1,touching,none,false,exact,true\n"
            "2,overlapping,none,false,exact,true\n3,apart,none,false,exact,false\n");
}

TEST_F(CheckPoses, JsonTellsThePosesThatWereUsed) {
  const Json json = Json::parse(check({"--json", "--faces"}).out);
  EXPECT_EQ(json["schema"], "toccata/check-poses/2");
  EXPECT_EQ(json["in_contact"], 2);
  EXPECT_EQ(json["objects"][1]["name"], "b");
  ASSERT_EQ(json["queries"].size(), 4U);
  const Json& overlapping = json["queries"][2];
  EXPECT_EQ(overlapping["query"], 2);
  EXPECT_EQ(overlapping["relation"], "overlapping");
  EXPECT_EQ(overlapping["pose_b"], Json::parse("[1,0,0,0,1,0,0,0,1,5.5,0.25,0.125]"));
  EXPECT_EQ(overlapping["face_pairs"], 6) << "three faces of either box, each with two of the other's";
  EXPECT_EQ(json["queries"][0]["pose_a"], Json::parse("[1,0,0,0,1,0,0,0,1,0,0,0]"));
}

TEST_F(CheckPoses, TouchingCanBeIgnored) {
  const auto result = check({"--touching=ignore"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("1 of 4 queries in contact"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1 merely touching, ignored as asked"), std::string::npos) << result.out;
  folder.write("poses.txt", rows + "1 0 0\n");
  EXPECT_EQ(check({"--touching=ignore"}).exit_code, 0);
}

TEST_F(CheckPoses, UnitsGoBeforeThePose) {
  const Json json = Json::parse(check({"--json", "--unit", "mm"}).out);
  EXPECT_EQ(json["queries"][0]["pose_b"], Json::parse("[0.001,0,0,0,0.001,0,0,0,0.001,2,0,0]"));
  EXPECT_EQ(json["queries"][1]["relation"], "apart");
}

TEST_F(CheckPoses, AnswerDoesNotDependOnThreads) {
  EXPECT_EQ(check({"--json", "--faces", "--threads", "1"}).out, check({"--json", "--faces", "--threads", "3"}).out);
}

TEST_F(CheckPoses, TroubleIsToldWithFileAndLineOrQuery) {
  const auto expect_trouble = [&](const test::CommandResult& result, const std::string& message) {
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  folder.write("poses.txt", rows + "0 0 0\n" + rows + "0 0\n");
  expect_trouble(check({}), "poses.txt:2: a line of 12 or 24 numbers has 11; ");
  folder.write("poses.txt", rows + "0 0 0\n1e308 1e308 0 0 1 0 0 0 1 0 0 0\n");
  expect_trouble(check({}), "query 1: model b: vertex 3 (1, 1, 0) is not finite in the world");
  expect_trouble(check({"b.obj"}), "two objects");
  expect_trouble(run_command({"check", "a.obj", "--poses", "poses.txt"}, folder.path()), "two objects");
  expect_trouble(run_command({"check", "a.obj", "b.obj", "--poses", "no.txt"}, folder.path()), "no.txt: there is no");
}

TEST_F(CheckPoses, AsASingleCheckAtThatPose) {
  const Json single = Json::parse(run_command({"check", "a.obj", "b.obj", "--json", "--pose-b", "1", "0", "0", "0", "1",
                                               "0", "0", "0", "1", "1", "0", "0"},
                                              folder.path())
                                      .out);
  EXPECT_EQ(single["pairs"][0]["relation"], Json::parse(check({"--json"}).out)["queries"][1]["relation"]);
}

}  // namespace
}  // namespace toccata
