// check --baseline, --fail-on and --sort as a person or a script meets them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// A box of side 2 along x, from a place on.
struct Placed {
  std::string name;
  double x = 0;
  std::string group{};
};

std::string scene_of_boxes(const std::vector<Placed>& boxes) {
  Json scene = {{"format", "toccata-scene"}, {"version", 1}, {"objects", Json::array()}};
  for (const Placed& box : boxes)
    scene["objects"].push_back({{"name", box.name},
                                {"group", box.group},
                                {"shape", {{"type", "box"}, {"half_extents", {1, 1, 1}}}},
                                {"pose", {{"translation", {box.x, 0, 0}}}}});
  return scene.dump();
}

class CheckBaseline : public testing::Test {
 protected:
  test::CommandResult check(const std::vector<Placed>& boxes, std::vector<std::string> options) {
    folder.write("scene.json", scene_of_boxes(boxes));
    options.insert(options.begin(), {"check", "scene.json"});
    return run_command(options, folder.path());
  }

  void keep(const std::vector<Placed>& boxes, std::vector<std::string> options = {}) {
    options.emplace_back("--json");
    folder.write("old.json", check(boxes, options).out);
  }

  /// The report since then.
  Json since(const std::vector<Placed>& boxes, std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--baseline", "old.json", "--json"});
    const auto run = check(boxes, options);
    EXPECT_NE(run.exit_code, 2) << run.err;
    return run.exit_code == 2 ? Json() : Json::parse(run.out);
  }

  TemporaryFolder folder;
  const std::vector<Placed> row = {{"a", 0}, {"b", 1.5}, {"c", 3.5}, {"ü", 9}};  // a overlaps b, which touches c
};

TEST_F(CheckBaseline, TellsWhatIsNewKnownGraverAndGone) {
  keep(row);
  const Json same = since(row);
  EXPECT_EQ(same["baseline"],
            Json::parse(R"({"file": "old.json", "new": 0, "known": 2, "moved": 0, "graver": 0, "gone": []})"));
  for (const Json& pair : same["pairs"]) {
    EXPECT_EQ(pair["baseline"], "known");
    EXPECT_FALSE(pair.contains("was"));
  }
  const Json moved = since({{"c", 3.25}, {"b", 1.5}, {"a", -4}, {"ü", 4}});
  ASSERT_EQ(moved["pairs"].size(), 2U);
  EXPECT_EQ(moved["pairs"][0]["baseline"], "graver") << moved["pairs"][0];
  EXPECT_EQ(moved["pairs"][0]["was"], Json::parse(R"({"relation": "touching", "containment": "none"})"));
  EXPECT_EQ(moved["pairs"][1]["baseline"], "new");
  EXPECT_EQ(
      moved["baseline"]["gone"],
      Json::parse(R"([{"a": "a", "b": "b", "relation": "overlapping", "containment": "none", "reason": "apart"}])"));
}

/// A report of how far apart all are has told no clash of these.
TEST_F(CheckBaseline, WhatWasApartAndDemandedNothingIsNew) {
  const std::vector<Placed> near = {{"a", 0}, {"b", 2.005}};
  const std::vector<std::string> too_near = {"--clearance", "0.01"};
  keep({{"a", 0}, {"b", 6}}, {"--clearance", "all"});
  EXPECT_EQ(since(near, too_near)["pairs"][0]["baseline"], "new");
  EXPECT_EQ(check(near, {"--clearance", "0.01", "--baseline", "old.json", "--fail-on", "new"}).exit_code, 1);
  EXPECT_EQ(since(near, {"--clearance", "all"})["pairs"][0]["baseline"], "moved");
  keep(near, {"--clearance", "all", "--clearance-of", "a,b=0.01"});
  EXPECT_EQ(since(near, too_near)["pairs"][0]["baseline"], "known");
}

TEST_F(CheckBaseline, TellsWhatIsNoGraverAndHasMoved) {
  keep(row);
  const Json slid = since({{"a", 0.25}, {"b", 1.5}, {"c", 3.5}, {"ü", 9}});
  EXPECT_EQ(slid["baseline"]["moved"], 1);
  EXPECT_EQ(slid["pairs"][0]["baseline"], "moved");
  EXPECT_EQ(slid["pairs"][0]["moved_by"], 0.25);
  EXPECT_FALSE(slid["pairs"][0].contains("was"));
  EXPECT_EQ(slid["pairs"][1]["baseline"], "known");
  EXPECT_FALSE(slid["pairs"][1].contains("moved_by"));
  const Json all = since({{"a", 5}, {"b", 6.5}, {"c", 8.5}});
  EXPECT_EQ(all["baseline"]["known"], 2) << "the whole assembly has moved, and nothing in it";
  const Json apart = since({{"b", 4}, {"a", 2}});
  EXPECT_EQ(apart["pairs"][0]["baseline"], "moved") << "less grave, and elsewhere";
  EXPECT_EQ(apart["pairs"][0]["was"]["relation"], "overlapping");
  const Json graver = since({{"c", 3.25}, {"b", 1.5}});
  EXPECT_EQ(graver["pairs"][0]["baseline"], "graver");
  EXPECT_EQ(graver["pairs"][0]["moved_by"], 0.25);
  const std::vector<Placed> nearly = {{"a", 0.0625}, {"b", 1.5}};
  EXPECT_EQ(since(nearly)["pairs"][0]["baseline"], "moved");
  EXPECT_EQ(since(nearly, {"--tolerance", "0.0625"})["pairs"][0]["baseline"], "known")
      << "no farther than the tolerance";
  folder.write("rules.txt", "tolerance a, b = 0.0625\n");
  EXPECT_EQ(since(nearly, {"--rules", "rules.txt"})["pairs"][0]["baseline"], "known");
  EXPECT_EQ(check(nearly, {"--baseline", "old.json"}).out,
            "2 objects with 0 triangles; the bounding boxes of 1 pair overlap.\n"
            "  moved by 0.0625  a  overlaps  b  (both solids)\n"
            "1 pair in contact, decided exactly.\n"
            "  gone  b  touches  c  (not in the files now)\n"
            "Since old.json: 0 new, 0 graver, 1 moved, 0 known, 1 gone.\n"
            "Of 1 that moved it is not known whether the overlap has grown: ask for --penetration or --volume both "
            "times.\n");
  EXPECT_EQ(check(nearly, {"--baseline", "old.json", "--fail-on", "new"}).exit_code, 0);
}

/// A cube of side 2 about a place on the x-axis, which is in its vertices.
std::string cube_at(double x) {
  std::string off = "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i)
    off +=
        std::to_string(x + ((i & 1) != 0 ? 1 : -1)) + ((i & 2) != 0 ? " 1" : " -1") + ((i & 4) != 0 ? " 1\n" : " -1\n");
  return off + "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
}

TEST_F(CheckBaseline, SeesMovesThatAreInTheVertices) {
  const auto state = [&](double a, double b, std::vector<std::string> options) {
    folder.write("a.off", cube_at(a));
    folder.write("b.off", cube_at(b));
    options.insert(options.begin(), {"check", "a.off", "b.off", "--json"});
    const auto run = run_command(options, folder.path());
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return Json::parse(run.out);
  };
  folder.write("old.json", state(0, 1.5, {"--unit", "m"}).dump());
  const std::vector<std::string> compared = {"--unit", "m", "--baseline", "old.json"};
  EXPECT_EQ(state(0, 1.5, compared)["pairs"][0]["baseline"], "known");
  EXPECT_EQ(state(7, 8.5, compared)["pairs"][0]["baseline"], "known") << "both have moved";
  EXPECT_EQ(state(0, 1.500001, compared)["pairs"][0]["baseline"], "known") << "as floats are rounded";
  const Json moved = state(7, 8.25, compared);
  EXPECT_EQ(moved["pairs"][0]["baseline"], "moved");
  EXPECT_NEAR(moved["pairs"][0]["moved_by"], 0.25, 1e-9);
  EXPECT_EQ(state(0, 1.5, {"--baseline", "old.json"})["pairs"][0]["baseline"], "known") << "in an unknown unit";
  // A report of before, which told no boxes, knows poses alone.
  Json old = Json::parse(state(0, 1.5, {"--unit", "m"}).dump());
  for (Json& object : old["objects"]) object.erase("box");
  folder.write("old.json", old.dump());
  EXPECT_EQ(state(0, 1.25, compared)["pairs"][0]["baseline"], "known");
  old["objects"][0]["pose"][10] = 0.5;
  folder.write("old.json", old.dump());
  EXPECT_EQ(state(0, 1.5, compared)["pairs"][0]["moved_by"], 0.5);
}

TEST_F(CheckBaseline, SeesTurnsAndOtherUnits) {
  const auto state = [&](const std::string& unit, double factor, const std::string& turn) {
    Json scene = {{"format", "toccata-scene"}, {"version", 1}, {"unit", unit}, {"objects", Json::array()}};
    const Json ground = {{"type", "half-space"}, {"point", {0, 0, -0.5 * factor}}, {"normal", {0, 0, 1}}};
    const Json box = {{"type", "box"}, {"half_extents", {factor, factor, factor}}};
    scene["objects"].push_back({{"name", "ground"}, {"shape", ground}});
    scene["objects"].push_back({{"name", "box"}, {"shape", box}, {"pose", Json::parse(turn)}});
    folder.write("scene.json", scene.dump());
    const auto run = run_command({"check", "scene.json", "--json", "--baseline", "old.json"}, folder.path());
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return Json::parse(run.out)["pairs"][0];
  };
  const std::string straight = "[1,0,0, 0,1,0, 0,0,1, 0,0,0]", turned = "[0,-1,0, 1,0,0, 0,0,1, 0,0,0]";
  folder.write("old.json", R"({"schema": "toccata/check/2", "objects": [{"name": "box"}], "pairs": []})");
  Json first = {{"schema", "toccata/check/2"}, {"unit", "m"}};
  first["pairs"] = Json::array({state("m", 1, straight)});  // braces alone copy the pair, as some compilers see them
  first["objects"] = Json::parse(run_command({"check", "scene.json", "--json"}, folder.path()).out)["objects"];
  folder.write("old.json", first.dump());
  EXPECT_EQ(state("m", 1, straight)["baseline"], "known");
  EXPECT_DOUBLE_EQ(state("m", 1, turned)["moved_by"], 2) << "a corner that went from one corner to the next";
  EXPECT_EQ(state("mm", 1000, straight)["baseline"], "known");
  EXPECT_DOUBLE_EQ(state("mm", 1500, straight)["moved_by"], std::hypot(500, 500, 750))
      << "a larger box, whose upper corners are so far from where the ground would have carried them";
}

TEST_F(CheckBaseline, TellsWhyAPairIsGone) {
  keep(row);
  const auto reasons = [&](const std::vector<Placed>& boxes, const std::vector<std::string>& options) {
    std::string text;
    const Json report = since(boxes, options);
    for (const Json& pair : report["baseline"]["gone"])
      text +=
          pair["a"].get<std::string>() + pair["b"].get<std::string>() + " " + pair["reason"].get<std::string>() + " ";
    return text;
  };
  EXPECT_EQ(reasons(row, {"--touching", "ignore"}), "bc touching ");
  EXPECT_EQ(reasons(row, {"--ignore", "a,b"}), "ab left_out ");
  EXPECT_EQ(reasons({{"a", 0, "arm"}, {"b", 1.5, "arm"}, {"c", 3.5}}, {}), "ab left_out ");
  EXPECT_EQ(reasons({{"a", 0}, {"b", 1.5}}, {}), "bc no_object ");
  EXPECT_EQ(reasons({{"a", 0}, {"b", 7}, {"c", 3.5}}, {}), "ab apart bc apart ");
}

TEST_F(CheckBaseline, KnowsPairsAndContainmentInEitherOrder) {
  keep({{"a", 0}, {"b", 0}, {"c", 9}});
  EXPECT_EQ(since({{"b", 0}, {"a", 0}})["pairs"][0]["baseline"], "known");
  folder.write("old.json", R"({"schema": "toccata/check/2", "objects": [{"name": "a"}, {"name": "b"}],
    "pairs": [{"a": "a", "b": "b", "relation": "overlapping", "containment": "a_in_b"}]})");
  EXPECT_EQ(since({{"b", 0}, {"a", 0.5}})["pairs"][0]["was"]["containment"], "b_in_a");
  EXPECT_EQ(since({{"a", 0}, {"b", 0.5}})["pairs"][0]["was"]["containment"], "a_in_b");
}

TEST_F(CheckBaseline, AnOverlapThatGrowsIsGraver) {
  const std::vector<Placed> then = {{"a", 0}, {"b", 1.5}}, deeper = {{"a", 0}, {"b", 1.25}};
  const std::vector<std::string> depths = {"--penetration"}, volumes = {"--volume"};
  const auto told = [&](const std::vector<Placed>& boxes, const std::vector<std::string>& options) {
    return Json(since(boxes, options)["pairs"][0]);
  };
  for (const auto& options : {depths, volumes}) {
    keep(then, options);
    const std::string measure = options == depths ? "penetration" : "volume";
    const Json grown = told(deeper, options);
    EXPECT_EQ(grown["baseline"], "graver");
    EXPECT_EQ(grown["was"]["relation"], "overlapping");
    const double was = options == depths ? 0.5 : 2;
    EXPECT_NEAR(grown["was"][measure]["lower"].get<double>(), was, 1e-9);
    EXPECT_NEAR(grown["was"][measure]["upper"].get<double>(), was, 1e-9);
    EXPECT_EQ(told({{"a", 0}, {"b", 1.75}}, options)["baseline"], "moved") << "it is less than before";
    EXPECT_EQ(told({{"a", 0}, {"b", 1.499}}, options)["baseline"], "moved") << "by less than a hundredth";
    EXPECT_EQ(told(then, options)["baseline"], "known");
    EXPECT_EQ(told(deeper, {})["baseline"], "moved") << "how deep it is now is not known";
    std::vector<std::string> failing = options;
    failing.insert(failing.end(), {"--baseline", "old.json", "--fail-on", "new"});
    EXPECT_EQ(check(deeper, failing).exit_code, 1);
    EXPECT_EQ(check(then, failing).exit_code, 0);
  }
  EXPECT_EQ(told(deeper, {"--volume", "--tolerance", "0.3"})["was"].contains("penetration"), false);
  keep(then, depths);
  EXPECT_EQ(told(deeper, {"--penetration", "--tolerance", "0.3"})["baseline"], "known") << "by less than the tolerance";
  EXPECT_NE(check(deeper, {"--penetration", "--baseline", "old.json"}).out.find("  graver (before: 0.5 deep)  a  "),
            std::string::npos);
  const std::string blind = check(deeper, {"--baseline", "old.json"}).out;
  EXPECT_NE(blind.find("Of 1 that moved it is not known whether the overlap has grown"), std::string::npos) << blind;
}

TEST_F(CheckBaseline, IsToldInTheTableAndInCsv) {
  keep(row);
  const std::vector<Placed> moved = {{"a", -4}, {"b", 1.5}, {"c", 3.25}, {"ü", 4}};
  EXPECT_EQ(check(moved, {"--baseline", "old.json"}).out,
            "4 objects with 0 triangles; the bounding boxes of 2 pairs overlap.\n"
            "  graver (before: touches)  b  overlaps  c  (both solids)\n"
            "  new                       c  overlaps  ü  (both solids)\n"
            "2 pairs in contact, decided exactly.\n"
            "  gone  a  overlaps  b  (no clash now)\n"
            "Since old.json: 1 new, 1 graver, 0 moved, 0 known, 1 gone.\n");
  EXPECT_EQ(check(moved, {"--baseline", "old.json", "--csv"}).out,
            "a,b,relation,containment,side_unresolved,status,baseline,was_relation,was_containment,moved_by\n"
            "b,c,overlapping,none,false,exact,graver,touching,none,0.25\nc,ü,overlapping,none,false,exact,new,,,\n"
            "a,b,apart,,,,gone,overlapping,none,\n");
}

TEST_F(CheckBaseline, DecidesTheExitCodeWhereThatIsAsked) {
  keep(row);
  const auto code = [&](const std::vector<Placed>& boxes, const std::string& fail_on,
                        std::vector<std::string> options = {"--baseline", "old.json"}) {
    options.insert(options.end(), {"--fail-on", fail_on});
    return check(boxes, options).exit_code;
  };
  EXPECT_EQ(code(row, "any"), 1);
  EXPECT_EQ(code(row, "new"), 0);
  EXPECT_EQ(code(row, "hard"), 1);
  const std::vector<Placed> graver = {{"a", 0}, {"b", 1.5}, {"c", 3.25}}, touching = {{"b", 1.5}, {"c", 3.5}};
  EXPECT_EQ(code(graver, "new"), 1);
  EXPECT_EQ(code({{"a", 0}, {"b", 2}, {"c", 4}}, "new"), 0) << "a pair that is less grave than before";
  EXPECT_EQ(code({{"a", 0}, {"b", 9}, {"ü", 11}}, "new"), 1);
  EXPECT_EQ(code(touching, "hard", {}), 0);
  EXPECT_EQ(code(touching, "any", {}), 1);
  EXPECT_EQ(code(touching, "hard", {"--clearance", "5"}), 0);
  folder.write("far.txt", "1 0 0 0 1 0 0 0 1 0 0 0\n");
  EXPECT_EQ(code(touching, "hard", {"--poses", "far.txt"}), 0);
  EXPECT_EQ(code(touching, "any", {"--poses", "far.txt"}), 1);
  folder.write("far.txt", "1 0 0 0 1 0 0 0 1 -1 0 0\n");
  EXPECT_EQ(code(touching, "hard", {"--poses", "far.txt"}), 1);
}

TEST_F(CheckBaseline, MayOverlapIsHard) {
  const std::string flat = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  folder.write("flat.off", flat);
  const auto run = run_command({"check", "flat.off", "flat.off", "--fail-on", "hard"}, folder.path());
  EXPECT_EQ(run.exit_code, 1) << "surfaces of which the faces cannot tell whether they pass through each other";
}

TEST_F(CheckBaseline, ThatIsNoneIsTrouble) {
  const auto error = [&](const std::string& text) {
    folder.write("old.json", text);
    const auto run = check(row, {"--baseline", "old.json"});
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(run.out.empty());
    EXPECT_NE(run.err.find("old.json"), std::string::npos) << run.err;
    return run.err;
  };
  for (const std::string text : {"{}", "[]", R"({"schema": "toccata/distance/1"})", R"({"schema": 3})"})
    EXPECT_NE(error(text).find("no report that can be a baseline"), std::string::npos) << text;
  EXPECT_NE(error("").find("empty"), std::string::npos);
  EXPECT_NE(error("a b").find("old.json:1"), std::string::npos);
  EXPECT_NE(error(R"({"schema": "toccata/check/2", "objects": [{"name": "x"}, {"name": "y"}], "pairs": []})")
                .find("another model: none of its 2 objects"),
            std::string::npos);
  EXPECT_NE(error(R"({"schema": "toccata/check/2", "objects": [{"name": "a"}], "pairs":
                    [{"a": "a", "b": "b", "relation": "near", "containment": "none"}]})")
                .find("/pairs/0/relation"),
            std::string::npos);
  EXPECT_EQ(check(row, {"--baseline", "gone.json"}).exit_code, 2);
  EXPECT_EQ(check(row, {"--baseline", "old.json", "--baseline", "old.json"}).exit_code, 2);
  EXPECT_NE(check(row, {"--fail-on", "new"}).err.find("add --baseline"), std::string::npos);
  EXPECT_EQ(check(row, {"--fail-on", "soft"}).exit_code, 2);
}

TEST_F(CheckBaseline, IsPartOfWhatIsAskedAgain) {
  keep(row);
  const std::vector<Placed> moved = {{"a", -4}, {"b", 1.5}, {"c", 3.25}, {"ü", 4}};
  const auto asked =
      check(moved, {"--baseline", "old.json", "--sort", "severity", "--json", "--save-case", "case.json"});
  folder.write("old.json", "something else by now");
  EXPECT_EQ(run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
  folder.write("report.json", asked.out);
  const auto drawn = run_command({"view", "report.json", "-o", "page.html"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.err.find("another answer"), std::string::npos) << drawn.err;
}

TEST_F(CheckBaseline, SeverityOrdersThePairs) {
  // Near, touching, shallow, deep, and near again, but less so.
  const std::vector<Placed> mixed = {{"n", 0},     {"m", 2.25}, {"t", 10}, {"u", 12}, {"s", 20},
                                     {"r", 21.75}, {"d", 30},   {"e", 31}, {"x", 40}, {"y", 42.125}};
  const auto order = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--json", "--clearance", "0.5"});
    std::string text;
    const Json report = Json::parse(check(mixed, options).out);
    for (const Json& pair : report["pairs"]) text += pair["a"].get<std::string>();
    return text;
  };
  EXPECT_EQ(order({}), "ntsdx");
  EXPECT_EQ(order({"--sort", "objects"}), "ntsdx");
  EXPECT_EQ(order({"--sort", "severity"}), "sdtxn");
  EXPECT_EQ(order({"--sort", "severity", "--penetration"}), "dstxn");
  EXPECT_EQ(order({"--sort", "severity", "--touching", "ignore"}), "sdxn");
}

}  // namespace
}  // namespace toccata
