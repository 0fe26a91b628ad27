// Cages of subdivision surfaces, as a person or a script asks about them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

class SubdivideCommand : public testing::Test {
 protected:
  test::CommandResult run(std::vector<std::string> words) {
    words.insert(words.begin(), "subdivide");
    return run_command(words, folder.path());
  }
  Json json_of(std::vector<std::string> words) {
    words.emplace_back("--json");
    const auto asked = run(words);
    EXPECT_EQ(asked.err, "");
    return Json::parse(asked.out);
  }
  TemporaryFolder folder;
};

TEST_F(SubdivideCommand, AMeshIsWrittenThatIsAsNearAsWasAsked) {
  const auto written = run({"gen:box", "--within", "0.05", "-o", "limit.obj"});
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_NE(written.out.find("a closed cage of 6 faces"), std::string::npos) << written.out;
  const auto read = run_command({"inspect", "limit.obj", "--json"}, folder.path());
  EXPECT_EQ(read.exit_code, 0) << read.err;
  const Json report = json_of({"gen:box", "--within", "0.05"});
  EXPECT_EQ(report["schema"], "toccata/subdivide/1");
}

TEST_F(SubdivideCommand, HowFarACageIsFromAnObjectIsToldWithProof) {
  const auto apart = run({"gen:box", "gen:box", "--within", "0.05", "--pose-b", "1", "0", "0", "0", "1", "0", "0", "0",
                          "1", "4", "0", "0"});
  EXPECT_EQ(apart.exit_code, 0) << apart.err << apart.out;
  const auto meeting = run({"gen:box", "gen:box", "--within", "0.05", "--pose-b", "1", "0", "0", "0", "1", "0", "0",
                            "0", "1", "0.5", "0.3", "0.2"});
  EXPECT_EQ(meeting.exit_code, 1) << meeting.err << meeting.out;
}

TEST_F(SubdivideCommand, CreasesAreReadFromAFileThatIsNamedWhereItIsWrong) {
  folder.write("sharp.txt", "crease 0 1\n");
  folder.write("wrong.txt", "crease 0 1\nfold 2 3\n");
  EXPECT_NE(run({"gen:box", "--within", "0.1", "--creases", "sharp.txt"}).exit_code, 2);
  const auto wrong = run({"gen:box", "--within", "0.1", "--creases", "wrong.txt"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.out, "");
  EXPECT_NE(wrong.err.find("wrong.txt"), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find('2'), std::string::npos) << wrong.err;
}

TEST_F(SubdivideCommand, WhatIsNotReachedIsSaid) {
  const auto few = run({"gen:box", "--within", "1e-6", "--triangles", "100"});
  EXPECT_EQ(few.exit_code, 1);
  EXPECT_NE(few.out.find("not reached"), std::string::npos) << few.out;
}

TEST_F(SubdivideCommand, ACaseKeepsItToTheBit) {
  const auto saved = run({"gen:box", "--within", "0.1", "--crease-angle", "60", "--save-case", "case.json"});
  EXPECT_EQ(saved.exit_code, 0) << saved.err;
  EXPECT_EQ(run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
}

TEST_F(SubdivideCommand, WhatIsOfNoUseIsRefused) {
  const auto refusal = [&](const std::vector<std::string>& words) {
    const auto refused = run(words);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.out, "");
    return refused.err;
  };
  const auto names = [](const std::string& error, const std::string& words) {
    EXPECT_NE(error.find(words), std::string::npos) << error;
  };
  names(refusal({"gen:box", "gen:box", "--levels", "2"}), "--levels is about the mesh of one cage");
  names(refusal({"gen:box", "gen:box", "-o", "limit.obj"}), "-o writes the mesh of one cage");
  names(refusal({"gen:box", "--solid", "all"}), "--solid tells what is taken for a solid where two objects");
  names(refusal({"gen:box", "--both"}), "--both is about two cages");
  EXPECT_EQ(run({"gen:box", "--within", "0.1", "--save-case", "case.json"}).exit_code, 0);
  const auto beside = run({"case.json", "--triangles", "4194304", "--within", "0.1"});
  EXPECT_EQ(beside.exit_code, 0) << beside.err;
  names(beside.err, "as --within --triangles asks another");
}

TEST_F(SubdivideCommand, OfSurfacesThatCoincideItIsToldThatItIsUndecided) {
  const auto same = run({"gen:box", "gen:box", "--both", "--triangles", "800"});
  EXPECT_EQ(same.exit_code, 1) << same.err;
  EXPECT_NE(same.out.find("whether they meet is undecided"), std::string::npos) << same.out;
  EXPECT_NE(same.out.find("not reached"), std::string::npos) << same.out;
}

TEST_F(SubdivideCommand, FacesThatMeetInAVertexAreACageAndErrorsNameVerticesOfTheFile) {
  folder.write("pinch.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nf 2 3 4\nf 4 5 6\n");
  EXPECT_EQ(run({"pinch.obj", "--within", "0.1"}).exit_code, 0);
  folder.write("fins.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 2 3 4\nf 3 2 5\nf 2 3 6\n");
  const auto fins = run({"fins.obj", "--within", "0.1"});
  EXPECT_EQ(fins.exit_code, 2);
  EXPECT_NE(fins.err.find("the edge 1–2, from (0, 0, 0) to (1, 0, 0),"), std::string::npos) << fins.err;
}

}  // namespace
}  // namespace toccata
