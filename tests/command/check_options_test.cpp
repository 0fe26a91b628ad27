// Every option of `toccata check` beside every other one: it works, or is refused with the reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Words = std::vector<std::string>;

/// Words for each option that say something; for some options with what they need beside them.
const std::map<std::string, Words>& samples() {
  const Words pose{"1", "0", "0", "0", "1", "0", "0", "0", "1", "0.5", "0", "0"};
  const auto posed = [&](const char* option) {
    Words words{option};
    words.insert(words.end(), pose.begin(), pose.end());
    return words;
  };
  static const std::map<std::string, Words> all = {{"--unit", {"--unit", "mm"}},
                                                   {"--scale", {"--scale", "2"}},
                                                   {"--pose-a", posed("--pose-a")},
                                                   {"--pose-b", posed("--pose-b")},
                                                   {"--poses", {"--poses", "poses.txt"}},
                                                   {"--solid", {"--solid", "none"}},
                                                   {"--touching", {"--touching", "ignore"}},
                                                   {"--penetration", {"--penetration"}},
                                                   {"--precision", {"--penetration", "--precision", "0.5"}},
                                                   {"--time-per-depth", {"--penetration", "--time-per-depth", "9"}},
                                                   {"--clearance", {"--clearance", "3"}},
                                                   {"--clearance-of", {"--clearance-of", "a,b=3"}},
                                                   {"--rules", {"--rules", "rules.txt"}},
                                                   {"--ignore", {"--ignore", "c*"}},
                                                   {"--between", {"--between", "a,b"}},
                                                   {"--baseline", {"--baseline", "old.json"}},
                                                   {"--fail-on", {"--fail-on", "hard"}},
                                                   {"--sort", {"--sort", "severity"}},
                                                   {"--group", {"--group", "part"}},
                                                   {"--tolerance", {"--tolerance", "0.5"}},
                                                   {"--volume", {"--volume"}},
                                                   {"--self", {"--self"}},
                                                   {"--faces", {"--faces"}},
                                                   {"--names", {}},   // another file than the two
                                                   {"--format", {}},  // needs standard input
                                                   {"--split", {"--split"}},
                                                   {"--close", {"--close", "0.001"}},
                                                   {"--tessellation", {"--tessellation", "1mm"}},
                                                   {"--stream", {"--stream"}},
                                                   {"--stop-after", {"--stop-after", "600"}},
                                                   {"--junit", {"--junit", "found.xml"}},
                                                   {"--sarif", {"--sarif", "found.sarif"}},
                                                   {"--bcf", {"--bcf", "found.bcf"}},
                                                   {"--bcf-version", {"--bcf", "found.bcf", "--bcf-version", "3.0"}},
                                                   {"--overlap-bodies", {"--overlap-bodies", "bodies.glb"}},
                                                   {"--json", {"--json"}},
                                                   {"--csv", {"--csv"}},
                                                   {"--threads", {"--threads", "2"}},
                                                   {"--cache", {"--cache", "trees"}},
                                                   {"--html", {"--html", "page.html"}},
                                                   {"--png", {}},   // needs a browser
                                                   {"--size", {}},  // needs --png, as does --look
                                                   {"--look", {}},
                                                   {"--glb", {"--glb", "scene.glb"}},
                                                   {"--save-case", {"--save-case", "case.json"}}};
  return all;
}

/// The options that the help tells.
std::set<std::string> options_told() {
  const std::string help = run_command({"check", "--help"}).out;
  std::set<std::string> options;
  for (std::size_t line = 0; line != std::string::npos; line = help.find("\n  -", line + 1)) {
    const std::size_t end_of_line = help.find('\n', line + 1), name = help.find("--", line);
    if (line == 0 || name == std::string::npos || name > end_of_line) continue;
    options.insert(help.substr(name, help.find_first_of(" \n,", name) - name));
  }
  options.erase("--help");
  options.erase("--distributed");  // becomes another program (over_ranks_test.cpp)
  return options;
}

class CheckOptionsTogether : public testing::Test {
 protected:
  void SetUp() override {
    const std::string box =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    folder.write("a.obj", box);
    folder.write("b.obj", box);
    folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.25 0 0\n");
    folder.write("rules.txt", "boxes = a, b\nbetween boxes, boxes\n");
    folder.write("old.json", run_command({"check", "a.obj", "b.obj", "--json"}, folder.path()).out);
  }

  test::CommandResult check(const Words& one, const Words& other) {
    Words words{"check", "a.obj", "b.obj"};
    words.insert(words.end(), one.begin(), one.end());
    // What both samples begin with is said once.
    const auto differ = std::mismatch(one.begin(), one.end(), other.begin(), other.end()).second;
    words.insert(words.end(), one == other ? other.begin() : differ, other.end());
    return run_command(words, folder.path());
  }

  TemporaryFolder folder;
};

TEST_F(CheckOptionsTogether, EveryOptionHasASample) {
  std::set<std::string> known;
  for (const auto& [option, words] : samples()) known.insert(option);
  EXPECT_EQ(options_told(), known);
}

TEST_F(CheckOptionsTogether, EveryPairWorksOrIsRefusedWithTheReason) {
  const std::set<std::pair<std::string, std::string>> refused = {{"--baseline", "--stream"},
                                                                 {"--csv", "--stream"},
                                                                 {"--json", "--stream"},
                                                                 {"--save-case", "--stream"},
                                                                 {"--sort", "--stream"},
                                                                 {"--poses", "--stream"},
                                                                 {"--self", "--stream"},
                                                                 {"--poses", "--stop-after"},
                                                                 {"--self", "--stop-after"},
                                                                 {"--bcf", "--poses"},
                                                                 {"--bcf", "--self"},
                                                                 {"--bcf-version", "--poses"},
                                                                 {"--bcf-version", "--self"},
                                                                 {"--junit", "--poses"},
                                                                 {"--junit", "--self"},
                                                                 {"--poses", "--sarif"},
                                                                 {"--sarif", "--self"},
                                                                 {"--baseline", "--poses"},
                                                                 {"--baseline", "--self"},
                                                                 {"--between", "--poses"},
                                                                 {"--between", "--self"},
                                                                 {"--clearance", "--poses"},
                                                                 {"--clearance", "--self"},
                                                                 {"--clearance-of", "--poses"},
                                                                 {"--clearance-of", "--self"},
                                                                 {"--csv", "--json"},
                                                                 {"--fail-on", "--self"},
                                                                 {"--ignore", "--poses"},
                                                                 {"--ignore", "--self"},
                                                                 {"--penetration", "--self"},
                                                                 {"--pose-a", "--poses"},
                                                                 {"--pose-b", "--poses"},
                                                                 {"--poses", "--rules"},
                                                                 {"--poses", "--self"},
                                                                 {"--poses", "--sort"},
                                                                 {"--precision", "--self"},
                                                                 {"--rules", "--self"},
                                                                 {"--self", "--solid"},
                                                                 {"--self", "--sort"},
                                                                 {"--self", "--time-per-depth"},
                                                                 {"--self", "--touching"},
                                                                 {"--group", "--stream"},
                                                                 {"--group", "--poses"},
                                                                 {"--group", "--self"},
                                                                 {"--poses", "--tolerance"},
                                                                 {"--self", "--tolerance"},
                                                                 {"--poses", "--volume"},
                                                                 {"--self", "--volume"},
                                                                 {"--overlap-bodies", "--poses"},
                                                                 {"--overlap-bodies", "--self"}};
  std::size_t pairs = 0;
  for (auto one = samples().begin(); one != samples().end(); ++one)
    for (auto other = std::next(one); other != samples().end(); ++other) {
      if (one->second.empty() || other->second.empty()) continue;
      const auto run = check(one->second, other->second);
      const std::string both = one->first + " and " + other->first + ": " + run.err;
      const bool is_refused = refused.contains({one->first, other->first});
      EXPECT_EQ(run.exit_code == 2, is_refused) << both;
      if (is_refused) {
        EXPECT_TRUE(run.out.empty()) << both;
        EXPECT_NE(run.err.find(one->second[0]), std::string::npos) << both;
        EXPECT_NE(run.err.find(other->second[0]), std::string::npos) << both;
      } else {
        EXPECT_FALSE(run.out.empty()) << both;
        EXPECT_EQ(run.err.find("error"), std::string::npos) << both;
      }
      ++pairs;
    }
  EXPECT_EQ(pairs, 40U * 39 / 2);
}

TEST_F(CheckOptionsTogether, WhatIsGivenTwiceIsTroubleUnlessItMayBeRepeated) {
  const std::set<std::string> repeatable = {"--clearance-of", "--rules", "--ignore", "--between"};
  const std::set<std::string> flags = {"--penetration", "--self",  "--faces",  "--json",
                                       "--csv",         "--split", "--stream", "--volume"};
  for (const auto& [option, words] : samples()) {
    if (words.empty() || words[0] != option || flags.contains(option)) continue;
    const int code = check(words, words).exit_code;
    if (option == "--rules")
      EXPECT_EQ(code, 2) << "its set would be there twice";
    else
      EXPECT_EQ(code == 2, !repeatable.contains(option)) << option;
  }
}

TEST(CheckOptions, AnEmptyWordIsToldByItsOption) {
  const test::TemporaryFolder folder;
  for (const auto& [option, missing] :
       {std::pair("--precision", "a number must be given"), std::pair("--time-per-depth", "seconds must be given"),
        std::pair("--unit", "a unit must be given"), std::pair("--tolerance", "a length must be given")}) {
    const auto result =
        test::run_command({"check", "gen:box", "gen:torus", "--penetration", option, ""}, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(std::string(option) + ": " + missing), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace toccata
