// check --volume, --tolerance and --group as a person or a script meets them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

Json box(const std::string& name, double x, double half = 1) {
  return {{"name", name},
          {"shape", {{"type", "box"}, {"half_extents", {half, half, half}}}},
          {"pose", {1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0, 0}}};
}

/// Boxes in a row: overlapping by 0.0625 and by 0.5, one that touches, and one that is near.
class CheckClashesOfCommand : public testing::Test {
 protected:
  void SetUp() override {
    const Json scene = {{"format", "toccata-scene"},
                        {"version", 1},
                        {"unit", "mm"},
                        {"objects", Json::array({box("a", 0), box("bolt 1", 1.9375), box("bolt 2", -1.5),
                                                 box("c", 3.9375), box("d", 6)})}};
    folder.write("row.json", scene.dump());
  }

  test::CommandResult check(std::vector<std::string> options, const std::string& rules = "") {
    if (!rules.empty()) {
      folder.write("rules.txt", rules);
      options.insert(options.begin(), {"--rules", "rules.txt"});
    }
    options.insert(options.begin(), {"check", "row.json"});
    return run_command(options, folder.path());
  }

  Json report(std::vector<std::string> options, const std::string& rules = "") {
    options.emplace_back("--json");
    const auto run = check(options, rules);
    EXPECT_NE(run.exit_code, 2) << run.err;
    return run.exit_code == 2 ? Json() : Json::parse(run.out);
  }

  static Json pair_of(const Json& report, const std::string& b) {
    for (const Json& pair : report["pairs"])
      if (pair["b"] == b) return pair;
    return {};
  }

  TemporaryFolder folder;
};

TEST_F(CheckClashesOfCommand, WhatIsWithinTheToleranceIsListedAndIsNoClash) {
  const Json found = report({"--tolerance", "0.1mm"});
  EXPECT_EQ(found["tolerance"], 0.1);
  EXPECT_EQ(found["within_tolerance"], 1);
  EXPECT_EQ(pair_of(found, "bolt 1")["tolerance"], "within");
  EXPECT_NEAR(pair_of(found, "bolt 1")["penetration"]["upper"].get<double>(), 0.0625, 1e-9);
  EXPECT_EQ(pair_of(found, "bolt 2")["tolerance"], "beyond");
  EXPECT_FALSE(pair_of(found, "c").contains("tolerance"));
  EXPECT_EQ(check({"--tolerance", "0.1mm", "--touching", "ignore"}).exit_code, 1);
  EXPECT_EQ(check({"--tolerance", "0.1mm", "--touching", "ignore", "--ignore", "bolt 2"}).exit_code, 0);
  EXPECT_EQ(check({"--tolerance", "0.1mm", "--fail-on", "hard", "--ignore", "bolt 2"}).exit_code, 0);
  EXPECT_EQ(check({"--tolerance", "0.01mm", "--fail-on", "hard", "--ignore", "bolt 2"}).exit_code, 1);
}

TEST_F(CheckClashesOfCommand, ToleranceTouchingClearanceAndPenetrationGoTogether) {
  const Json found =
      report({"--tolerance", "0.1", "--touching", "ignore", "--clearance", "0.1", "--penetration", "--volume"});
  EXPECT_EQ(found["pairs"].size(), 3U);
  EXPECT_EQ(found["ignored_touching"], 1);
  EXPECT_EQ(pair_of(found, "bolt 1")["tolerance"], "within");
  EXPECT_EQ(pair_of(found, "d")["relation"], "apart");
  EXPECT_EQ(pair_of(found, "d")["kind"], "clearance");
  EXPECT_EQ(pair_of(found, "bolt 2")["kind"], "protrude");
  EXPECT_LE(pair_of(found, "bolt 2")["volume"]["lower"], 2.0);
  EXPECT_GE(pair_of(found, "bolt 2")["volume"]["upper"], 2.0);
}

TEST_F(CheckClashesOfCommand, RulesTellTheTolerancesOfSomePairs) {
  const Json found = report({}, "bolts = bolt*\ntolerance bolts, a = 0.01mm\ntolerance bolt 2 = 1mm\n");
  EXPECT_EQ(found["tolerance"], 0);
  EXPECT_EQ(pair_of(found, "bolt 1")["tolerance"], "beyond");
  EXPECT_EQ(pair_of(found, "bolt 2")["tolerance"], "within");
  for (const auto& [rules, told] : std::vector<std::pair<std::string, std::string>>{
           {"tolerance a, c\n", "rules.txt:1: the tolerance is of no pairs or has no length"},
           {"tolerance a = 3 parsec\n", "rules.txt:1"},
           {"tolerance a = all\n", "rules.txt:1"},
           {"tolerance = a\n", "no set is called 'tolerance'"}}) {
    const auto run = check({}, rules);
    EXPECT_EQ(run.exit_code, 2) << rules;
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  }
  EXPECT_NE(check({}, "tolerance zzz = 1\n").err.find("no object is called 'zzz'"), std::string::npos);
}

TEST_F(CheckClashesOfCommand, WhatWasWithinTheToleranceAndIsDeeperNowIsGraver) {
  folder.write("old.json", check({"--tolerance", "0.1", "--json"}).out);
  const Json found = report({"--tolerance", "0.01", "--baseline", "old.json"});
  EXPECT_EQ(pair_of(found, "bolt 1")["baseline"], "graver");
  EXPECT_EQ(pair_of(found, "bolt 2")["baseline"], "known");
  EXPECT_EQ(check({"--tolerance", "0.01", "--baseline", "old.json", "--fail-on", "new"}).exit_code, 1);
  EXPECT_EQ(check({"--tolerance", "0.1", "--baseline", "old.json", "--fail-on", "new"}).exit_code, 0);
}

TEST_F(CheckClashesOfCommand, WhatWasWithinTheToleranceIsKnownWhereNoneIsAsked) {
  folder.write("old.json", check({"--tolerance", "0.1", "--json"}).out);
  EXPECT_EQ(pair_of(report({"--baseline", "old.json"}), "bolt 1")["baseline"], "known");
  EXPECT_EQ(check({"--baseline", "old.json", "--fail-on", "new"}).exit_code, 0);
}

TEST_F(CheckClashesOfCommand, OptionsOfDepthsGoWithATolerance) {
  const Json found = report({"--tolerance", "0.1", "--precision", "0.5", "--time-per-depth", "9"});
  EXPECT_EQ(found["asked"]["query"]["precision"], 0.5);
  EXPECT_EQ(found["asked"]["query"]["time_per_depth"], 9);
  EXPECT_EQ(report({"--precision", "0.5"}, "tolerance a = 0.1mm\n")["asked"]["query"]["precision"], 0.5);
  for (const char* option : {"--precision", "--time-per-depth"}) {
    for (const auto& run :
         {check({option, "0.5"}), check({option, "0.5", "--volume"}), check({option, "0.5"}, "ignore d\n")}) {
      EXPECT_EQ(run.exit_code, 2);
      EXPECT_NE(run.err.find(std::string(option) + " is about depths, which are not asked for: add --penetration or "
                                                   "--tolerance"),
                std::string::npos)
          << run.err;
    }
  }
}

TEST_F(CheckClashesOfCommand, ClashesAreGroupedByParts) {
  const Json found = report({"--group", "part"});
  EXPECT_EQ(found["group_by"], "part");
  ASSERT_EQ(found["groups"].size(), 2U);
  EXPECT_EQ(found["groups"][0]["part"], "a");
  EXPECT_EQ(found["groups"][0]["pairs"].size(), 2U);
  EXPECT_NE(check({"--group", "part"}).out.find("a: 2 pairs\n  a"), std::string::npos)
      << check({"--group", "part"}).out;
  const std::string csv = check({"--group", "part", "--csv"}).out;
  EXPECT_NE(csv.find("status,group\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("exact,1\n"), std::string::npos) << csv;
}

TEST_F(CheckClashesOfCommand, CsvHasAsManyFieldsInEachLineAndListsWhatIsGone) {
  folder.write("old.json", check({"--json"}).out);
  const std::string csv = check({"--csv", "--baseline", "old.json", "--tolerance", "0.1", "--volume", "--clearance",
                                 "0.1", "--group", "region", "--ignore", "bolt 2"})
                              .out;
  std::size_t fields = 0, lines = 0;
  for (std::size_t at = 0; at < csv.size(); ++lines) {
    const std::size_t end = csv.find('\n', at);
    const auto count = static_cast<std::size_t>(
        std::count(csv.begin() + static_cast<std::ptrdiff_t>(at), csv.begin() + static_cast<std::ptrdiff_t>(end), ','));
    if (lines == 0) fields = count;
    EXPECT_EQ(count, fields) << csv;
    at = end + 1;
  }
  EXPECT_EQ(lines, 5U) << csv;
  EXPECT_NE(csv.find("a,bolt 2,left_out,,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",gone,overlapping,none,"), std::string::npos) << csv;
}

TEST_F(CheckClashesOfCommand, ASavedCaseAndAReportAskTheSameAgain) {
  EXPECT_EQ(check({"--tolerance", "0.1", "--volume", "--group", "region", "--save-case", "case.json"},
                  "tolerance bolt 2 = 1mm\n")
                .exit_code,
            1);
  EXPECT_EQ(run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
}

TEST_F(CheckClashesOfCommand, ByWhichDepthTheToleranceWasDecidedIsTold) {
  // A crate pressed 0.05 into both walls of a channel, and a shape that is no mesh.
  folder.write("channel.obj",
               "v -2 -1 0\nv 2 -1 0\nv 2 2 0\nv 1 2 0\nv 1 0 0\nv -1 0 0\nv -1 2 0\nv -2 2 0\n"
               "v -2 -1 4\nv 2 -1 4\nv 2 2 4\nv 1 2 4\nv 1 0 4\nv -1 0 4\nv -1 2 4\nv -2 2 4\n"
               "f 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\nf 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 5 13 12\n"
               "f 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 1 9 16\n");
  folder.write("scene.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "channel", "file": "channel.obj"},
    {"name": "crate", "generate": "box", "parameters": {"half-x": 1.05, "half-y": 0.9, "half-z": 0.9},
     "pose": {"translation": [0, 1.2, 2]}},
    {"name": "ball", "shape": {"type": "sphere", "radius": 1}, "pose": {"translation": [0, 3.05, 2]}}]})");
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"check", "scene.json"});
    return run_command(words, folder.path());
  };
  const Json found = Json::parse(run({"--tolerance", "0.06", "--json"}).out);
  ASSERT_EQ(found["pairs"].size(), 2U);
  const Json &meshes = found["pairs"][0], &other = found["pairs"][1];
  EXPECT_EQ(meshes["tolerance"], "within");
  EXPECT_EQ(meshes["tolerance_by"], "local_depth");
  EXPECT_NEAR(meshes["local_depth"]["upper"].get<double>(), 0.05, 1e-9);
  EXPECT_TRUE(meshes["penetration"].is_null());
  EXPECT_EQ(other["tolerance"], "within");
  EXPECT_EQ(other["tolerance_by"], "penetration");
  EXPECT_FALSE(other.contains("local_depth"));
  const auto table = run({"--tolerance", "0.06"});
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_NE(table.out.find("within the tolerance: nowhere more than 0.05 deep"), std::string::npos) << table.out;
  EXPECT_NE(
      table.out.find("2 pairs within the tolerance of 60 mm: 1 by the deepest place, 1 by what parts the two: no"),
      std::string::npos)
      << table.out;
  const auto deeper = run({"--tolerance", "0.04", "--sarif", "deep.sarif"});
  EXPECT_EQ(deeper.exit_code, 1);
  EXPECT_NE(deeper.out.find("beyond the tolerance: 0.05 deep or more in one place"), std::string::npos) << deeper.out;
  EXPECT_NE(test::text_of(folder.path() / "deep.sarif").find("\"tolerance_by\": \"local_depth\""), std::string::npos);
  const std::string csv = run({"--tolerance", "0.06", "--csv"}).out;
  EXPECT_NE(csv.find(",tolerance,tolerance_by,local_depth_lower,local_depth_upper\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",within,local_depth,0.0"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",within,penetration,,\n"), std::string::npos) << csv;
}

TEST_F(CheckClashesOfCommand, WhatGoesThroughWhatIsSaidInEitherOrder) {
  const std::string plate = "gen:box?half-x=2&half-y=2&half-z=0.25", rod = "gen:box?half-x=0.5&half-y=0.25&half-z=2";
  const auto told = [&](const std::string& a, const std::string& b, const char* format) {
    return run_command({"check", a, b, "--volume", format}, folder.path()).out;
  };
  for (const char* format : {"--json", "--csv"}) {
    EXPECT_NE(told(plate, rod, format).find("b_through_a"), std::string::npos) << told(plate, rod, format);
    EXPECT_NE(told(rod, plate, format).find("a_through_b"), std::string::npos) << told(rod, plate, format);
  }
  const std::string rows = run_command({"check", plate, rod, "--volume"}, folder.path()).out;
  EXPECT_NE(rows.find("  is pierced by  "), std::string::npos) << rows;
  EXPECT_NE(run_command({"check", rod, plate, "--volume"}, folder.path()).out.find("  pierces  "), std::string::npos);
}

TEST_F(CheckClashesOfCommand, WhichOfTheTwoMovesIsSaid) {
  const std::string told = check({"--penetration", "--ignore", "bolt 2", "--junit", "row.xml"}).out;
  EXPECT_NE(told.find("      0.0625 deep along (1, 0, 0), moving bolt 1\n"), std::string::npos) << told;
  EXPECT_NE(test::text_of(folder.path() / "row.xml").find("0.0625 deep along (1, 0, 0), moving bolt 1"),
            std::string::npos);
}

TEST_F(CheckClashesOfCommand, AnOutputThatIsALinkIsWrittenToWhatItLeadsTo) {
  std::filesystem::create_symlink("there.xml", folder.path() / "link.xml");
  for (int i = 0; i < 2; ++i) {  // where there is nothing, and where there is a report
    EXPECT_EQ(check({"--junit", "link.xml"}).exit_code, 1);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.xml"));
    EXPECT_NE(test::text_of(folder.path() / "there.xml").find("JUnit XML of Toccata"), std::string::npos);
  }
}

TEST_F(CheckClashesOfCommand, AGlbOfAStoppedCheckSaysSo) {
  const auto marks_in = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--glb", "row.glb", "--overlap-bodies", "bodies.glb"});
    check(more);
    std::string names;
    for (const char* file : {"row.glb", "bodies.glb"})
      if (test::text_of(folder.path() / file).find(R"("extras":{"unfinished":)") != std::string::npos) names += file;
    return names;
  };
  EXPECT_EQ(marks_in({}), "");
  EXPECT_EQ(marks_in({"--stop-after", "1e-9"}), "row.glbbodies.glb");
}

TEST_F(CheckClashesOfCommand, ThatCoordinatesAreRoundedByAUnitIsSaid) {
  const auto told = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"check", "gen:box", "gen:icosphere"});
    return run_command(options, folder.path()).out;
  };
  const std::string rounded = "and rounded: slanted faces that touch in the files may be apart or overlap";
  EXPECT_NE(told({"--unit", "mm"}).find("Coordinates were multiplied by 0.001 " + rounded), std::string::npos);
  EXPECT_NE(told({"--scale", "3"}).find("multiplied by 3 " + rounded), std::string::npos);
  EXPECT_EQ(told({"--unit", "m"}).find(rounded), std::string::npos);
  EXPECT_EQ(told({"--scale", "0.25"}).find(rounded), std::string::npos);
  EXPECT_EQ(told({}).find(rounded), std::string::npos);
}

TEST_F(CheckClashesOfCommand, OverlapBodiesAreOfThePairsThatAreTold) {
  const auto told = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--overlap-bodies", "bodies.glb"});
    const auto run = check(options);
    EXPECT_NE(run.exit_code, 2) << run.err;
    return run.out.substr(std::min(run.out.find("bodies.glb: "), run.out.size())) + run.err;
  };
  EXPECT_EQ(told({}), "bodies.glb: 2 overlap bodies.\n");
  EXPECT_EQ(told({"--ignore", "bolt 2", "--touching", "ignore", "--threads", "2"}), "bodies.glb: 1 overlap body.\n");
  EXPECT_EQ(told({"--tolerance", "0.1mm"}), "bodies.glb: 2 overlap bodies.\n");
  const std::string file = test::text_of(folder.path() / "bodies.glb");
  EXPECT_NE(file.find(R"("name":"a × bolt 1","extras":{"a":"a","b":"bolt 1","tolerance":"within")"), std::string::npos);
  EXPECT_EQ(told({"--ignore", "a"}), "bodies.glb: 0 overlap bodies.\n");
  const auto none = run_command({"check",
                                 "gen:torus",
                                 "gen:torus",
                                 "--pose-b",
                                 "1",
                                 "0",
                                 "0",
                                 "0",
                                 "1",
                                 "0",
                                 "0",
                                 "0",
                                 "1",
                                 "0.5",
                                 "0",
                                 "0",
                                 "--solid",
                                 "none",
                                 "--overlap-bodies",
                                 "bodies.glb"},
                                folder.path());
  EXPECT_NE(none.out.find("bodies.glb: 0 overlap bodies; 1 pair that overlaps has none.\n"), std::string::npos)
      << none.out;
  EXPECT_NE(none.err.find("1 pair that overlaps has no body: torus"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find(": a surface takes part, which has no inside"), std::string::npos) << none.err;
}

TEST_F(CheckClashesOfCommand, OverlapBodiesOfASavedCaseAreThose) {
  check({"--overlap-bodies", "bodies.glb", "--save-case", "case.json"});
  const auto again = run_command({"check", "case.json", "--overlap-bodies", "again.glb"}, folder.path());
  EXPECT_EQ(again.exit_code, 1) << again.err;
  EXPECT_NE(again.out.find("again.glb: 2 overlap bodies.\n"), std::string::npos) << again.out;
  const auto bodies_in = [&](const char* file) {
    const std::string bytes = test::text_of(folder.path() / file);
    return bytes.substr(std::min(bytes.find("BIN"), bytes.size()));
  };
  EXPECT_FALSE(bodies_in("again.glb").empty());
  EXPECT_EQ(bodies_in("again.glb"), bodies_in("bodies.glb"));
}

TEST_F(CheckClashesOfCommand, OverlapBodiesOfAStoppedCheckAreToldToBeMissing) {
  const auto run = check({"--stop-after", "1e-9", "--overlap-bodies", "bodies.glb"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("bodies.glb: 0 overlap bodies.\n"), std::string::npos) << run.out;
}

TEST_F(CheckClashesOfCommand, AFileForOverlapBodiesThatCannotBeWrittenIsTold) {
  folder.write("mine.glb", "not Toccata's");
  for (const auto& [file, reason] : {std::pair("nowhere/bodies.glb", "nowhere"), std::pair("bodies.obj", ".glb"),
                                     std::pair("mine.glb", "not a GLB file of Toccata")}) {
    const auto run = check({"--overlap-bodies", file});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
  }
  EXPECT_EQ(test::text_of(folder.path() / "mine.glb"), "not Toccata's");
  const auto same = check({"--overlap-bodies", "one.glb", "--glb", "one.glb"});
  EXPECT_EQ(same.exit_code, 2);
  EXPECT_NE(same.err.find("--overlap-bodies"), std::string::npos) << same.err;
}

}  // namespace
}  // namespace toccata
