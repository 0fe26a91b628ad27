// Trouble: exit code 2, one message on standard error that says where and what to do, nothing on standard output.
#include <gtest/gtest.h>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;

const char* const good_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

struct BadFile {
  const char* name;
  std::string text;
  const char* message;  ///< must occur in what is said
};

void expect_trouble(const test::CommandResult& result, const std::string& message) {
  EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("toccata: error: ", 0), 0U) << result.err;
  EXPECT_NE(result.err.find(message), std::string::npos) << "expected '" << message << "' in: " << result.err;
}

class BadFileTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadFileTest, IsTroubleThatNamesTheFile) {
  const TemporaryFolder folder;
  folder.write(GetParam().name, GetParam().text);
  folder.write("good.off", good_off);
  const auto result = run_command({"check", GetParam().name, "good.off"}, folder.path());
  expect_trouble(result, GetParam().message);
  EXPECT_NE(result.err.find(GetParam().name), std::string::npos) << result.err;
  expect_trouble(run_command({"inspect", GetParam().name, "--json"}, folder.path()), GetParam().message);
}

const char* const claiming_ply =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const char* const scene_of_missing_file =
    R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "a", "file": "gone.obj"}]})";
const char* const scene_of_two_alike =
    R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "twin", "file": "good.off"},
       {"name": "twin", "file": "good.off"}]})";

INSTANTIATE_TEST_SUITE_P(Files, BadFileTest,
                         testing::Values(BadFile{"empty.obj", "", "empty.obj"},
                                         BadFile{"truncated.off", "OFF\n3 1 0\n0 0 0\n1 0", "truncated.off"},
                                         BadFile{"liar.stl", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "liar.stl"},
                                         BadFile{"unknown.xyz", "1 2 3\n", "unknown.xyz"},
                                         BadFile{"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "index.obj:4"},
                                         BadFile{"nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "nan.obj:2"},
                                         BadFile{"huge.obj", "v 0 0 0\nv 1 1e999 0\nv 0 1 0\nf 1 2 3\n", "huge.obj:2"},
                                         BadFile{"claims.ply", claiming_ply, "claims.ply"},
                                         BadFile{"missing-part.json", scene_of_missing_file, "gone.obj"},
                                         BadFile{"alike.json", scene_of_two_alike, "twin"}),
                         [](const testing::TestParamInfo<BadFile>& file) {
                           std::string name = file.param.name;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

class BadQuestion : public testing::Test {
 protected:
  TemporaryFolder folder;
  void SetUp() override { folder.write("good.off", good_off); }

  test::CommandResult check_posed(std::vector<std::string> pose, const std::string& file = "good.off") {
    pose.insert(pose.begin(), {"check", "good.off", file, "--pose-b"});
    return run_command(pose, folder.path());
  }
};

TEST_F(BadQuestion, MissingFile) {
  expect_trouble(run_command({"check", "good.off", "gone.stl"}, folder.path()), "gone.stl");
}

TEST_F(BadQuestion, FolderInsteadOfFile) {
  expect_trouble(run_command({"check", "good.off", "."}, folder.path()), ".");
}

TEST_F(BadQuestion, PoseThatIsNotFinite) {
  for (const char* const number : {"inf", "1e999", "nan", "0x1p0", ""})
    expect_trouble(check_posed({"1", "0", "0", "0", "1", "0", "0", "0", "1", "0", number, "0"}), "--pose-b");
}

TEST_F(BadQuestion, PoseOfElevenNumbers) {
  expect_trouble(check_posed({"1", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0"}), "pose-b");
}

TEST_F(BadQuestion, PosedVertexThatOverflows) {
  folder.write("large.off", "OFF\n3 1 0\n0 0 0\n1e308 0 0\n0 1 0\n3 0 1 2\n");
  expect_trouble(check_posed({"1e10", "0", "0", "0", "1", "0", "0", "0", "1", "0", "0", "0"}, "large.off"), "large");
}

TEST_F(BadQuestion, OpenMeshAsSolid) {
  expect_trouble(run_command({"check", "good.off", "good.off", "--solid=all"}, folder.path()), "open");
}

TEST_F(BadQuestion, OneObjectIsNoPair) {
  expect_trouble(run_command({"check", "good.off"}, folder.path()), "needs two");
}

TEST_F(BadQuestion, PosesForThreeFiles) {
  expect_trouble(run_command({"check", "good.off", "good.off", "good.off", "--pose-a", "1", "0", "0", "0", "1", "0",
                              "0", "0", "1", "0", "0", "0"},
                             folder.path()),
                 "two files");
}

TEST_F(BadQuestion, MistypedSubcommandIsToldTheRightOne) {
  expect_trouble(run_command({"chekc", "good.off"}), "did you mean 'check'");
}

TEST_F(BadQuestion, UnknownOption) { expect_trouble(run_command({"check", "a.obj", "b.obj", "--fast"}), "--fast"); }

TEST_F(BadQuestion, FileNamesCannotSmuggleControlCharacters) {
  const auto result = run_command({"check", "evil\x1b[31m.obj", "good.off"}, folder.path());
  expect_trouble(result, "evil");
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace toccata
