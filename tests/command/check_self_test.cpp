// `toccata check FILE… --self`: each object against itself.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

class CheckSelf : public testing::Test {
 protected:
  TemporaryFolder folder;

  void SetUp() override {
    // Two triangles of one vertex that cross; and the same soup as an STL file would hold it, with proper neighbours.
    folder.write("bow.off", "OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n");
    folder.write("soup.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 1 0\n1 0 0\n1 1 1\n3 0 1 2\n3 3 4 5\n");
    // A quad that crosses itself: its two triangles meet.
    folder.write("quad.off", "OFF\n4 1 0\n0 0 0\n4 0 0\n0 1 0\n4 1 0\n4 0 1 2 3\n");
  }

  test::CommandResult check(std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    words.emplace_back("--self");
    return run_command(words, folder.path());
  }
};

TEST_F(CheckSelf, ExitCodeTells) {
  EXPECT_EQ(check({"bow.off"}).exit_code, 1);
  EXPECT_EQ(check({"soup.off"}).exit_code, 0);
  EXPECT_EQ(check({"soup.off", "bow.off"}).exit_code, 1);
  EXPECT_EQ(check({"none.off"}).exit_code, 2);
}

TEST_F(CheckSelf, TableNamesEveryObject) {
  const std::string text = check({"soup.off", "bow.off", "--faces"}).out;
  EXPECT_EQ(text,
            "2 objects with 4 triangles, each against itself.\n"
            "  soup  does not intersect itself\n"
            "  bow  self-intersects in 1 pair of faces\n"
            "      face 0  face 1  cross in a segment  (0, 0, 0) (1, 1, 0)\n"
            "1 object self-intersects, decided exactly.\n");
  EXPECT_NE(check({"soup.off"}).out.find("Nothing intersects itself"), std::string::npos);
}

TEST_F(CheckSelf, JsonListsEveryObject) {
  const Json json = Json::parse(check({"soup.off", "bow.off", "--json", "--faces"}).out);
  EXPECT_EQ(json["schema"], "toccata/check-self/2");
  EXPECT_EQ(json["self_intersecting"], 1);
  ASSERT_EQ(json["self_contacts"].size(), 2U);
  EXPECT_EQ(json["self_contacts"][0]["triangle_pairs"], 0);
  EXPECT_TRUE(json["self_contacts"][0]["faces"].empty());
  const Json& bow = json["self_contacts"][1];
  EXPECT_EQ(bow["object"], "bow");
  EXPECT_EQ(bow["face_pairs"], 1);
  EXPECT_EQ(bow["faces"][0]["crossing"], true);
  EXPECT_EQ(bow["faces"][0]["intersections"][0]["points"], Json::parse("[[0,0,0],[1,1,0]]"));
}

TEST_F(CheckSelf, CsvHasALinePerObjectOrPair) {
  EXPECT_EQ(check({"soup.off", "bow.off", "--csv"}).out, "object,triangle_pairs,face_pairs\nsoup,0,0\nbow,1,1\n");
  EXPECT_EQ(check({"soup.off", "bow.off", "--csv", "--faces"}).out, "object,face_a,face_b,crossing\nbow,0,1,true\n");
}

TEST_F(CheckSelf, AFaceMayMeetItself) {
  const Json json = Json::parse(check({"quad.off", "--json", "--faces"}).out);
  const Json& pair = json["self_contacts"][0]["faces"][0];
  EXPECT_EQ(pair["face_a"], 0);
  EXPECT_EQ(pair["face_b"], 0);
}

TEST_F(CheckSelf, ObjectsAreNotCheckedAgainstEachOther) {
  EXPECT_EQ(check({"soup.off", "soup.off"}).exit_code, 0);
  EXPECT_EQ(run_command({"check", "soup.off", "soup.off"}, folder.path()).exit_code, 1);
}

TEST_F(CheckSelf, AnswerDoesNotDependOnThreads) {
  EXPECT_EQ(check({"soup.off", "bow.off", "--json", "--faces", "--threads", "1"}).out,
            check({"soup.off", "bow.off", "--json", "--faces", "--threads", "3"}).out);
}

TEST_F(CheckSelf, OptionsWithoutMeaningAreTrouble) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"bow.off", "--solid=none"},
                                                {"bow.off", "--touching=ignore"},
                                                {"bow.off", "--poses", "p"}}) {
    const auto result = check(words);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("excludes"), std::string::npos) << result.err;
  }
}

TEST_F(CheckSelf, OneObjectAloneIsToldOfIt) {
  EXPECT_NE(run_command({"check", "bow.off"}, folder.path()).err.find("--self"), std::string::npos);
}

}  // namespace
}  // namespace toccata
