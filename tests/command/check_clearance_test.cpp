// check --clearance as a person or a script meets it.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

const char* const cell = R"({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [
  {"name": "table", "shape": {"type": "box", "half_extents": [500, 300, 10]}},
  {"name": "tool, left", "shape": {"type": "sphere", "radius": 20}, "pose": {"translation": [0, 0, 32]}},
  {"name": "wall", "shape": {"type": "box", "half_extents": [10, 300, 400]}, "pose": {"translation": [560, 0, 0]}}]})";

class CheckClearanceCommand : public testing::Test {
 protected:
  std::size_t pairs_told(const std::vector<std::string>& options) {
    std::vector<std::string> words{"check", file, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const auto run = run_command(words);
    EXPECT_NE(run.exit_code, 2) << run.err;
    const std::size_t count = Json::parse(run.out)["pairs"].size();
    const bool demands_none = !options.empty() && options.back() == "all";
    EXPECT_EQ(run.exit_code, count > 0 && !demands_none ? 1 : 0);
    return count;
  }

  TemporaryFolder folder;
  std::string file = folder.write("cell.json", cell).string();
};

TEST_F(CheckClearanceCommand, TakesLengthsWithAndWithoutTheirUnit) {
  EXPECT_EQ(pairs_told({}), 0U);
  EXPECT_EQ(pairs_told({"--clearance", "2mm"}), 1U);
  EXPECT_EQ(pairs_told({"--clearance", "2"}), 1U);
  EXPECT_EQ(pairs_told({"--clearance", "1.999"}), 0U);
  EXPECT_EQ(pairs_told({"--clearance", "5cm"}), 2U);
  EXPECT_EQ(pairs_told({"--clearance", "2in"}), 2U);
  EXPECT_EQ(pairs_told({"--clearance", "all"}), 3U);
  EXPECT_EQ(pairs_told({"--clearance-of", "wall,table=5cm"}), 1U);
  EXPECT_EQ(pairs_told({"--clearance", "5cm", "--clearance-of", "table,tool, left=1mm"}), 1U);
  EXPECT_EQ(pairs_told({"--clearance-of", "wall,table=5cm", "--clearance-of", "tool, left,table=2"}), 2U);
}

TEST_F(CheckClearanceCommand, AllDemandsNoneAndTellsDistances) {
  const auto all = run_command({"check", file, "--clearance", "all", "--junit", (folder / "all.xml").string()});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_NE(all.out.find("  table       is apart from  tool, left  2 apart"), std::string::npos) << all.out;
  EXPECT_EQ(all.out.find("clearance clash"), std::string::npos) << all.out;
  const std::string junit = test::text_of(folder / "all.xml");
  EXPECT_NE(junit.find("tests=\"3\" failures=\"0\""), std::string::npos) << junit;
  EXPECT_NE(junit.find("table and tool, left are 2 apart"), std::string::npos) << junit;
  EXPECT_EQ(junit.find("nearer than"), std::string::npos) << junit;
  const std::vector<std::string> one_demanded{"check", file, "--clearance", "all", "--clearance-of", "wall,table=5cm"};
  const auto one = run_command(one_demanded);
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_NE(one.out.find("  table       clearance clash  wall"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("  table       is apart from    tool, left"), std::string::npos) << one.out;
}

TEST_F(CheckClearanceCommand, TellsTheDistance) {
  const auto json = run_command({"check", file, "--clearance", "2mm", "--json"});
  const Json report = Json::parse(json.out);
  EXPECT_EQ(report["clearance"], 2);
  const Json pair = report["pairs"][0];
  EXPECT_EQ(pair["relation"], "apart");
  EXPECT_NEAR(pair["distance"]["upper"], 2, 1e-11);
  EXPECT_NEAR(pair["distance"]["on_b"][2], 12, 1e-9);
  const auto table = run_command({"check", file, "--clearance", "2mm"});
  EXPECT_NE(table.out.find("table  clearance clash  tool, left  2 apart"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("0 pairs in contact and 1 not farther apart than asked"), std::string::npos) << table.out;
  const auto csv = run_command({"check", file, "--clearance", "2mm", "--csv"});
  EXPECT_NE(csv.out.find("status,distance_lower,distance_upper"), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find("table,\"tool, left\",apart,none,false,exact,"), std::string::npos) << csv.out;
}

TEST_F(CheckClearanceCommand, WithinTheIntervalOfASmoothShapeIsToldAsUndecided) {
  const std::string eggs = folder
                               .write("eggs.json", R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "egg", "shape": {"type": "ellipsoid", "half_axes": [1, 2, 3]}},
  {"name": "hat", "shape": {"type": "cone", "radius": 1, "half_height": 2}, "pose": {"translation": [4, 3, 2]}}]})")
                               .string();
  const auto told = [&](const std::string& clearance, const std::string& format) {
    return run_command({"check", eggs, "--clearance", clearance, format});
  };
  const Json apart = Json::parse(told("all", "--json").out)["pairs"][0]["distance"];
  ASSERT_LT(apart["lower"], apart["upper"]);
  const auto open = told(apart["lower"].dump(), "--json"), decided = told(apart["upper"].dump(), "--json");
  EXPECT_EQ(open.exit_code, 1);
  EXPECT_EQ(Json::parse(open.out)["pairs"][0]["relation"], "apart");
  EXPECT_EQ(Json::parse(open.out)["pairs"][0]["status"], "undecided");
  EXPECT_EQ(Json::parse(decided.out)["pairs"][0]["status"], "exact");
  const std::string csv = told(apart["lower"].dump(), "--csv").out;
  EXPECT_NE(csv.find("egg,hat,apart,none,false,undecided,"), std::string::npos) << csv;
  const std::string table = run_command({"check", eggs, "--clearance", apart["lower"].dump()}).out;
  EXPECT_NE(table.find("(undecided: within 10⁻¹² of its clearance)"), std::string::npos) << table;
  EXPECT_NE(table.find("1 not farther apart than asked, 1 undecided and counted."), std::string::npos) << table;
}

TEST_F(CheckClearanceCommand, OfTwoFiles) {
  const std::vector<std::string> words{"check", "gen:box", "gen:box", "--pose-b", "1", "0", "0", "0",
                                       "1",     "0",       "0",       "0",        "1", "2", "0", "0"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return run_command(all);
  };
  EXPECT_EQ(with({"--clearance", "0.99"}).exit_code, 0);
  EXPECT_EQ(with({"--clearance", "1"}).exit_code, 1);
  EXPECT_EQ(with({"--clearance", "1m", "--unit", "m"}).exit_code, 1);
  const auto unknown = with({"--clearance", "2mm"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("add --unit"), std::string::npos) << unknown.err;
}

TEST_F(CheckClearanceCommand, OfContactIsADistanceOf0) {
  const std::vector<std::string> words{"check", "gen:box", "gen:box", "--pose-b", "1", "0", "0", "0",           "1",
                                       "0",     "0",       "0",       "1",        "1", "0", "0", "--clearance", "0"};
  const auto with = [&](const std::string& format) {
    std::vector<std::string> all = words;
    all.push_back(format);
    const auto run = run_command(all);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return run.out;
  };
  const Json report = Json::parse(with("--json"));
  EXPECT_EQ(report["clearance"], 0);
  ASSERT_EQ(report["pairs"].size(), 1U);
  const Json pair = report["pairs"][0];
  EXPECT_EQ(pair["relation"], "touching");
  EXPECT_EQ(pair["distance"]["lower"], 0);
  EXPECT_EQ(pair["distance"]["upper"], 0);
  EXPECT_EQ(pair["distance"]["on_a"][0], 0.5);
  EXPECT_EQ(pair["distance"]["on_b"], pair["distance"]["on_a"]);
  const std::string csv = with("--csv");
  EXPECT_NE(csv.find(",touching,none,false,exact,0,0,0.5,"), std::string::npos) << csv;
}

TEST_F(CheckClearanceCommand, TellsTheLengthsAsked) {
  const auto run = run_command({"check", file, "--clearance", "2mm", "--clearance-of", "wall,table=5cm",
                                "--clearance-of", "wall,tool, left=all", "--json"});
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["clearance"], 2);
  EXPECT_EQ(report["pair_clearances"],
            Json::parse(R"([{"a": "table", "b": "wall", "a_index": 0, "b_index": 2, "clearance": 50},
                            {"a": "tool, left", "b": "wall", "a_index": 1, "b_index": 2, "clearance": "all"}])"));
}

TEST_F(CheckClearanceCommand, TellsOfEachPairHowFarApartItHasToBe) {
  const std::vector<std::string> words{"check", file, "--clearance", "all", "--clearance-of", "wall,table=5cm"};
  const auto with = [&](const std::string& format) {
    std::vector<std::string> all = words;
    all.push_back(format);
    return run_command(all).out;
  };
  std::map<std::string, Json> of_pair;
  const Json report = Json::parse(with("--json"));
  for (const Json& pair : report["pairs"])
    of_pair[pair["a"].get<std::string>() + " " + pair["b"].get<std::string>()] = pair["clearance"];
  const std::map<std::string, Json> wanted{{"table tool, left", "all"}, {"table wall", 50}, {"tool, left wall", "all"}};
  EXPECT_EQ(of_pair, wanted);
  const std::string csv = with("--csv");
  EXPECT_NE(csv.find(",distance_status,clearance\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",exact,50\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",exact,all\n"), std::string::npos) << csv;
}

TEST_F(CheckClearanceCommand, CountsThePairsThatAreAsNearAsTheirOwnLength) {
  const auto candidates = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"check", file, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return Json::parse(run_command(words).out)["candidate_pairs"];
  };
  EXPECT_EQ(candidates({"--clearance-of", "tool, left,wall=all"}), 1);
  EXPECT_EQ(candidates({"--clearance", "2mm", "--clearance-of", "table,wall=49mm"}), 1);
  EXPECT_EQ(candidates({"--clearance", "2mm", "--clearance-of", "table,wall=50mm"}), 2);
}

TEST_F(CheckClearanceCommand, RefusesWhatContradictsItself) {
  const auto error_of = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"check", file};
    words.insert(words.end(), options.begin(), options.end());
    const auto run = run_command(words);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(run.out.empty()) << run.out;
    return run.err;
  };
  const std::string twice = error_of({"--clearance-of", "table,wall=1", "--clearance-of", "wall,table=2"});
  EXPECT_NE(twice.find("\"table\""), std::string::npos) << twice;
  EXPECT_NE(twice.find("\"wall\""), std::string::npos) << twice;
  EXPECT_EQ(pairs_told({"--clearance-of", "table,wall=50", "--clearance-of", "wall,table=5cm"}), 1U);
}

TEST_F(CheckClearanceCommand, OfWhatMerelyTouchesIsLeftOutWhereTouchingIsIgnored) {
  const std::string bolted = folder
                                 .write("bolted.json", R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "plate", "shape": {"type": "box", "half_extents": [1, 1, 1]}},
  {"name": "head", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"translation": [0, 0, 2]}},
  {"name": "near", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"translation": [2.25, 0, 0]}},
  {"name": "nearly", "shape": {"type": "box", "half_extents": [1, 1, 1]},
   "pose": {"translation": [0, 0, -2.00000000001]}},
  {"name": "deep", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"translation": [0, 0, 3]}}]})")
                                 .string();
  const auto told = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"check", bolted, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const Json report = Json::parse(run_command(words).out);
    std::string text = std::to_string(report["ignored_touching"].get<int>());
    for (const Json& pair : report["pairs"])
      text += " " + pair["a"].get<std::string>() + "-" + pair["b"].get<std::string>();
    return text;
  };
  EXPECT_EQ(told({"--clearance", "0"}), "0 plate-head head-deep");
  EXPECT_EQ(told({"--clearance", "0", "--touching", "ignore"}), "1 head-deep");
  EXPECT_EQ(told({"--clearance", "0.25", "--touching", "ignore"}), "1 plate-near plate-nearly head-near head-deep");
  EXPECT_EQ(told({"--clearance-of", "plate,head=1", "--touching", "ignore"}), "1 head-deep");
  const std::string table = run_command({"check", bolted, "--clearance=0.1", "--touching=ignore"}).out;
  EXPECT_NE(table.find("1 pair merely touching, ignored as asked.\n"), std::string::npos) << table;
}

TEST_F(CheckClearanceCommand, WithoutAUnitIsInThatOfTheFiles) {
  // A box from -0.5 to 0.5, and one that begins 4 beside it, in the unit of the file.
  const std::string far = folder.write("far.obj", "v 4.5 0 0\nv 5 1 0\nv 5 0 1\nf 1 2 3\n").string();
  const auto told = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"check", "gen:box", far};
    all.insert(all.end(), options.begin(), options.end());
    return run_command(all);
  };
  EXPECT_EQ(told({"--clearance", "4"}).exit_code, 1);
  EXPECT_EQ(told({"--clearance", "3.9"}).exit_code, 0);
  for (const std::string unit : {"mm", "in", "0.25"}) {
    EXPECT_EQ(told({"--unit", unit, "--clearance", "4.001"}).exit_code, 1) << unit;
    EXPECT_EQ(told({"--unit", unit, "--clearance", "3.9"}).exit_code, 0) << unit;
    EXPECT_EQ(told({"--unit", unit, "--clearance-of", "box,far=3.9"}).exit_code, 0) << unit;
  }
  EXPECT_EQ(told({"--unit", "mm", "--clearance", "1cm"}).exit_code, 1);
  EXPECT_EQ(Json::parse(told({"--unit", "mm", "--clearance", "5", "--json"}).out)["clearance"], 0.005);
  const auto line = [&](const std::vector<std::string>& options) {
    const std::string out = told(options).out;
    const std::size_t start = out.find("Clearance");
    return start == std::string::npos ? out : out.substr(start, out.find('\n', start) - start);
  };
  EXPECT_EQ(line({"--unit", "mm", "--clearance", "5"}), "Clearance 5 mm.");
  EXPECT_EQ(line({"--unit", "m", "--clearance", "5"}), "Clearance 5 m.");
  EXPECT_EQ(line({"--clearance", "5"}), "Clearance 5.");
  EXPECT_EQ(line({"--clearance", "all"}), "Clearance all.");
  EXPECT_EQ(line({"--unit", "m", "--clearance", "1", "--clearance-of", "far,box=5cm"}),
            "Clearance 1 m; 50 mm between box and far.");
}

TEST_F(CheckClearanceCommand, RefusesALengthWithinAGroup) {
  const auto grouped = folder.write("grouped.json", R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "left", "group": "arm", "shape": {"type": "sphere", "radius": 1}},
  {"name": "right", "group": "arm", "shape": {"type": "sphere", "radius": 1}}]})");
  const auto run = run_command({"check", grouped.string(), "--clearance-of", "left,right=1"});
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_NE(run.err.find("group \"arm\""), std::string::npos) << run.err;
}

TEST_F(CheckClearanceCommand, NamesTheWholeArgumentAndItsForm) {
  for (const std::string wrong : {"table,wall=", "table,wall=-3", "table,wall=x", "table,wall", "table,wall=2 mm"}) {
    const auto run = run_command({"check", file, "--clearance-of", wrong});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("--clearance-of " + wrong + ": write NAME,NAME=LENGTH"), std::string::npos) << run.err;
  }
  const auto common = run_command({"check", file, "--clearance=-3"});
  EXPECT_NE(common.err.find("--clearance -3: write LENGTH"), std::string::npos) << common.err;
}

TEST_F(CheckClearanceCommand, OfPatternsIsToldByRules) {
  const std::string rules = (folder.path() / "rules.txt").string();
  const auto told = [&](const std::string& text, std::vector<std::string> options) {
    folder.write("rules.txt", text);
    options.insert(options.end(), {"--rules", rules});
    return pairs_told(options);
  };
  EXPECT_EQ(told("clearance tool*, t* = 2mm\n", {}), 1U);
  EXPECT_EQ(told("clearance tool*, t* = 1.9mm\n", {}), 0U);
  EXPECT_EQ(told("clearance wall = 5cm\n", {}), 1U) << "of it and all others";
  EXPECT_EQ(told("walls = wall\nclearance walls, table = 50\nclearance tool* = 2\n", {}), 2U);
  EXPECT_EQ(told("clearance * = 5cm\nclearance wall, * = 1mm\n", {}), 1U) << "the last counts";
  EXPECT_EQ(told("clearance wall, * = 1mm\nclearance * = 5cm\n", {}), 2U) << "the last counts";
  EXPECT_EQ(told("clearance wall = 1mm\n", {"--clearance", "5cm"}), 1U) << "in place of that of all";
  EXPECT_EQ(told("clearance wall = 1mm\n", {"--clearance-of", "wall,table=5cm"}), 1U) << "that of two counts more";
  EXPECT_EQ(told("clearance wall = 5cm\nignore wall, table\n", {}), 0U);
  EXPECT_EQ(told("clearance * = 9m\n", {"--clearance", "all"}), 3U);
}

TEST_F(CheckClearanceCommand, OfRulesIsToldAndAskedAgain) {
  folder.write("rules.txt", "steel = wall, table, beam*\nclearance steel = 5cm\nclearance tool*, table = 2mm\n");
  const auto table = run_command({"check", "cell.json", "--rules", "rules.txt"}, folder.path());
  EXPECT_NE(table.out.find("Clearance 0 mm; 50 mm between wall, table, beam* and *; 2 mm between tool* and table.\n"),
            std::string::npos)
      << table.out;
  const auto json =
      run_command({"check", "cell.json", "--rules", "rules.txt", "--json", "--save-case", "case.json"}, folder.path());
  const Json report = Json::parse(json.out);
  EXPECT_EQ(report["clearance"], 0);
  EXPECT_EQ(report["asked"]["query"]["clearances"][1],
            Json::parse(R"({"a": ["tool*"], "b": ["table"], "clearance": 2})"));
  EXPECT_EQ(report["pairs"].size(), 2U);
  EXPECT_EQ(report["candidate_pairs"], 2) << "tool and wall are far from each other by their own clearance";
  folder.write("report.json", json.out);
  const auto drawn = run_command({"view", "report.json", "-o", "page.html"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.err.find("another answer"), std::string::npos) << drawn.err;
  EXPECT_EQ(run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
  for (const auto& [rule, told] : std::vector<std::pair<std::string, std::string>>{
           {"clearance a, c\n", "rules.txt:1: the clearance is of no pairs or has no length"},
           {"clearance table = all\n", "rules.txt:1"},
           {"clearance table = 3 parsec\n", "rules.txt:1"},
           {"clearance table = -1\n", "rules.txt:1"},
           {"clearance = table\n", "no set is called 'clearance'"}}) {
    folder.write("rules.txt", rule);
    const auto run = run_command({"check", "cell.json", "--rules", "rules.txt"}, folder.path());
    EXPECT_EQ(run.exit_code, 2) << rule;
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  }
}

TEST_F(CheckClearanceCommand, RefusesWhatIsNoLength) {
  for (const std::string wrong : {"-1", "2 mm", "mm", "nan", "inf", "", "2mile"}) {
    const auto run = run_command({"check", file, "--clearance=" + wrong});
    EXPECT_EQ(run.exit_code, 2) << wrong << run.out;
    EXPECT_TRUE(run.out.empty()) << wrong;
  }
  EXPECT_NE(run_command({"check", file, "--clearance=2mile"}).err.find("'mile' is no unit of length"),
            std::string::npos);
  for (const std::string wrong : {"table,door=1", "table=1", "table,wall", "table,table=1", "table,wall=x"})
    EXPECT_EQ(run_command({"check", file, "--clearance-of", wrong}).exit_code, 2) << wrong;
  EXPECT_EQ(run_command({"check", file, "--self", "--clearance", "1"}).exit_code, 2);
}

}  // namespace
}  // namespace toccata
