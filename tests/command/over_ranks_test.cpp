// --distributed: the program over ranks that lies beside the command runs in its place, with the same words.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// The command alone in a folder, where no program of the build lies beside it, and none on the path.
class OverRanks : public testing::Test {
 protected:
  OverRanks() {
    fs::copy_file(test::command_file(), folder_.path() / "toccata");
    setenv("TOCCATA_TEST_COMMAND", (folder_.path() / "toccata").c_str(), 1);
    setenv("PATH", "/nowhere", 1);
  }
  ~OverRanks() override {
    command_.empty() ? unsetenv("TOCCATA_TEST_COMMAND") : setenv("TOCCATA_TEST_COMMAND", command_.c_str(), 1);
    setenv("PATH", path_.c_str(), 1);
  }

  static std::string in_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  }

  void add_program(const std::string& name) {
    folder_.write(name, "#!/bin/sh\nfor word; do echo \"$word\"; done\nexit 7\n");
    fs::permissions(folder_.path() / name, fs::perms::owner_all);
  }

  TemporaryFolder folder_;

 private:
  std::string command_ = in_environment("TOCCATA_TEST_COMMAND"), path_ = in_environment("PATH");
};

TEST_F(OverRanks, TellHowTheirProgramIsBuiltWhereItIsMissing) {
  for (const std::string subcommand : {"check", "crowd"}) {
    const auto result = test::run_command({subcommand, "--distributed", "a.obj", "b.obj"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    const std::vector<std::string> told{"toccata-" + subcommand + "-ranks, which is not there", "openmpi-bin",
                                        "-DTOCCATA_WITH_MPI=ON", "--target toccata_" + subcommand + "_ranks"};
    for (const std::string& words : told) EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  }
}

TEST_F(OverRanks, RunTheirProgramWithTheSameWords) {
  add_program("toccata-check-ranks");
  add_program("toccata-crowd-ranks");
  const auto check = test::run_command({"check", "a b.obj", "--distributed", "--clearance", "2 mm", "--json"});
  EXPECT_EQ(check.exit_code, 7);
  EXPECT_EQ(check.out, "a b.obj\n--clearance\n2 mm\n--json\n");
  const auto crowd = test::run_command({"crowd", "--count", "10", "--distributed"});
  EXPECT_EQ(crowd.exit_code, 7);
  EXPECT_EQ(crowd.out, "--count\n10\n");
}

TEST_F(OverRanks, AreForNoOtherSubcommand) {
  add_program("toccata-distance-ranks");
  const auto result = test::run_command({"distance", "a.obj", "b.obj", "--distributed"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("--distributed"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace toccata
