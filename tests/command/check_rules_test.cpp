// check --rules, --ignore and --between as a person or a script meets them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// Balls at the same place, so that every two overlap.
std::string scene_of(const std::vector<std::string>& names) {
  Json scene = {{"format", "toccata-scene"}, {"version", 1}, {"objects", Json::array()}};
  for (const std::string& name : names)
    scene["objects"].push_back({{"name", name}, {"shape", {{"type", "sphere"}, {"radius", 1}}}});
  return scene.dump();
}

class CheckRules : public testing::Test {
 protected:
  void SetUp() override {
    folder.write("scene.json", scene_of({"pipe 1", "hall/pipe-2", "beam 1", "hall/Träger", "bolt #2", "tool, left"}));
  }

  test::CommandResult check(std::vector<std::string> options, const std::string& rules = "") {
    if (!rules.empty()) {
      folder.write("rules.txt", rules);
      options.insert(options.begin(), {"--rules", "rules.txt"});
    }
    options.insert(options.begin(), {"check", "scene.json"});
    return run_command(options, folder.path());
  }

  /// How many pairs are told and left out, which are all.
  std::size_t pairs_told(std::vector<std::string> options, const std::string& rules = "") {
    options.emplace_back("--json");
    const auto run = check(options, rules);
    EXPECT_NE(run.exit_code, 2) << run.err;
    if (run.exit_code == 2) return 99;
    const Json report = Json::parse(run.out);
    EXPECT_EQ(report["pairs"].size() + report["left_out"].get<std::size_t>(), 15U);
    EXPECT_EQ(report["candidate_pairs"], report["pairs"].size());
    EXPECT_EQ(report["warnings"], Json::array()) << rules;
    return report["pairs"].size();
  }

  std::string warning_of(const std::string& rules) {
    const auto run = check({}, rules);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    return run.err;
  }

  std::string error_of(const std::vector<std::string>& options, const std::string& rules = "") {
    const auto run = check(options, rules);
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_TRUE(run.out.empty()) << run.out;
    return run.err;
  }

  TemporaryFolder folder;
};

TEST_F(CheckRules, IgnoreLeavesOutPairsAndObjects) {
  EXPECT_EQ(pairs_told({"--ignore", "pipe 1,beam 1"}), 14U);
  EXPECT_EQ(pairs_told({"--ignore", "*pipe*,beam*"}), 13U);
  EXPECT_EQ(pairs_told({"--ignore", "pipe 1"}), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "hall/*, hall/*"}), 14U);
  EXPECT_EQ(pairs_told({"--ignore", "hall/*", "--ignore", "beam ?"}), 3U);
  EXPECT_EQ(pairs_told({}, "ignore *pipe*, beam*\r\n\n  # a comment\nignore bolt #2\n"), 8U);
}

TEST_F(CheckRules, BetweenChecksNothingElse) {
  const std::string sets = "\xEF\xBB\xBFpipes = pipe*, */pipe-*\nsteel = beam*, hall/Tr?ger\nall = pipes, steel\n";
  EXPECT_EQ(pairs_told({"--between", "pipes,steel"}, sets), 4U);
  EXPECT_EQ(pairs_told({"--between", "steel,pipes"}, sets), 4U);
  EXPECT_EQ(pairs_told({"--between", "pipes,pipes"}, sets), 1U);
  EXPECT_EQ(pairs_told({"--between", "all,all"}, sets), 6U);
  EXPECT_EQ(pairs_told({"--between", "pipes"}, sets), 9U);
  EXPECT_EQ(pairs_told({"--between", "pipes,steel", "--between", "bolt*,steel"}, sets), 6U);
  EXPECT_EQ(pairs_told({"--between", "pipes,steel", "--ignore", "pipe 1, beam 1"}, sets), 3U);
  EXPECT_EQ(pairs_told({}, sets + "between pipes, steel\nignore pipes, beam*"), 2U);
}

TEST_F(CheckRules, NamesMayHoldAnySign) {
  EXPECT_EQ(pairs_told({"--ignore", "tool\\, left"}), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "bolt #2, hall/Träger"}), 14U);
  folder.write("scene.json", scene_of({"a*b", "a=b", "a\\b", "axb ", "[a]b", "ignore"}));
  EXPECT_EQ(pairs_told({"--ignore", "a\\*b"}), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "a\\\\b"}), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "axb\\ "}), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "[a]b"}), 10U);
  EXPECT_EQ(pairs_told({}, "ignore ignore"), 10U);
  EXPECT_EQ(pairs_told({"--ignore", "odd, odd"}, "odd = a\\=b, a\\\\b"), 14U);
}

TEST_F(CheckRules, TellWhatTheyLeaveOut) {
  const auto table = check({"--ignore", "*pipe*"});
  EXPECT_NE(table.out.find("6 pairs in contact, decided exactly.\n9 pairs left out by rules, not looked at.\n"),
            std::string::npos)
      << table.out;
  const auto none = check({"--ignore", "pipe*", "--between", "pipe*,beam*", "--between", "beam*,hall/*"});
  EXPECT_NE(none.out.find("13 pairs left out by rules"), std::string::npos) << none.out;
  EXPECT_FALSE(Json::parse(check({"--json"}).out).contains("left_out"));
}

TEST_F(CheckRules, OfNoObjectAreWarnedOfByTheirLine) {
  const std::string nothing = warning_of("ignore pipe 1, beam 1\n\nignore bolt*, screw*\n");
  EXPECT_NE(nothing.find("rules.txt:3: no object is called 'screw*', and no set above"), std::string::npos) << nothing;
  EXPECT_EQ(nothing.find("'bolt*'"), std::string::npos) << nothing;
  const std::string near = warning_of("ignore beam 2");
  EXPECT_NE(near.find("rules.txt:1: no object is called 'beam 2', and no set above; did you mean 'beam 1'?"),
            std::string::npos)
      << near;
  const std::string set = warning_of("cables = cable*\nignore cables");
  EXPECT_NE(set.find("rules.txt:1: no object is called 'cable*'"), std::string::npos) << set;
  EXPECT_NE(set.find("rules.txt:2: the set 'cables' has no object in it"), std::string::npos) << set;
  EXPECT_NE(warning_of("ignore beam 1, beam*").find("rules.txt:1: 'beam 1' is a single object, and no pair"),
            std::string::npos);
  EXPECT_NE(warning_of("beam 1 = pipe*").find("rules.txt:1: an object is called 'beam 1' too"), std::string::npos);
  EXPECT_NE(warning_of("# nothing\n \n").find("rules.txt holds no rule"), std::string::npos);
  const auto option = check({"--ignore", "screw*"});
  EXPECT_NE(option.err.find("--ignore screw*: no object is called 'screw*'"), std::string::npos) << option.err;
  const Json report = Json::parse(check({"--ignore", "screw*", "--json"}).out);
  EXPECT_EQ(report["warnings"].size(), 1U);
}

/// Its rules would be passed over.
TEST_F(CheckRules, InAFileThatIsGivenAsOneRuleAreRefused) {
  folder.write("more.txt", "ignore pipe*, beam*\n");
  const auto result = check({"--ignore", "more.txt"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find(
                "more.txt is a file, and no object is called so: give a file of rules and sets as --rules more.txt"),
            std::string::npos)
      << result.err;
  EXPECT_NE(check({"--sets", "more.txt"}).err.find("sets are defined in the file of --rules"), std::string::npos);
}

TEST_F(CheckRules, OfNoPairLeaveNothingToBeChecked) {
  EXPECT_NE(error_of({"--between", "pips,beam*"}).find("nothing would be checked: --between pips,beam*: "),
            std::string::npos)
      << error_of({"--between", "pips,beam*"});
  EXPECT_NE(error_of({"--between", "beam 1,beam 1"}).find("nothing would be checked"), std::string::npos);
  EXPECT_EQ(check({"--between", "pips,beam*", "--between", "beam*,bolt*"}).exit_code, 1);
  for (const char* all : {"*", "*,*", "?*,*"})
    EXPECT_NE(error_of({"--ignore", all}).find("nothing would be checked: the rules leave no pair of two objects"),
              std::string::npos);
  EXPECT_NE(error_of({"--between", "bolt*,beam*", "--ignore", "beam*"}).find("the rules leave no pair"),
            std::string::npos);
}

TEST_F(CheckRules, ThatAreNoneAreToldByTheirLine) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"ignore a, b, c", "rules.txt:1: a rule is about one pattern or set, or two"},
      {"\nignore a,", "rules.txt:2: a rule is about one pattern or set, or two"},
      {"ignore", "rules.txt:1: the rule says nothing"},
      {"# x\n\nbolt*", "rules.txt:3: 'bolt*' is no rule; write `ignore PATTERN`"},
      {"= a", "rules.txt:1: '' is no name of a set"},
      {"a* = b", "rules.txt:1: 'a*' is no name of a set"},
      {"ignore = b", "rules.txt:1: no set is called 'ignore'"},
      {"between=b", "rules.txt:1: no set is called 'between'"},
      {"a = ", "rules.txt:1: a pattern of the set 'a' is empty"},
      {"a = beam*\na = pipe*", "rules.txt:2: there is a set 'a' already, from rules.txt:1"}};
  for (const auto& [text, message] : wrong) {
    const std::string error = error_of({}, text);
    EXPECT_NE(error.find(message), std::string::npos) << text << ": " << error;
  }
  EXPECT_NE(error_of({"--ignore", "a,b,c"}).find("--ignore a,b,c: a rule is about"), std::string::npos);
  EXPECT_NE(error_of({"--ignore", ""}).find("--ignore"), std::string::npos);
  EXPECT_NE(error_of({"--rules", "gone.txt"}).find("gone.txt: the rules cannot be read: No such file"),
            std::string::npos);
  EXPECT_NE(error_of({"--rules", "."}).find(".: the rules cannot be read"), std::string::npos);
}

TEST_F(CheckRules, MayBeInSeveralFilesWithSetsInCommon) {
  folder.write("sets.txt", "pipes = *pipe*");
  EXPECT_EQ(pairs_told({"--rules", "sets.txt", "--ignore", "pipes"}), 6U);
  folder.write("more.txt", "ignore pipes, beam*");
  EXPECT_EQ(pairs_told({"--rules", "sets.txt", "--rules", "more.txt"}), 13U);
  EXPECT_NE(check({"--rules", "more.txt", "--rules", "sets.txt"}).err.find("no object is called 'pipes'"),
            std::string::npos);
}

TEST_F(CheckRules, RefuseAClearanceOfWhatTheyLeaveOut) {
  const std::vector<std::string> own{"--clearance-of", "beam 1,pipe 1=2"};
  std::vector<std::string> words = own;
  words.insert(words.end(), {"--ignore", "beam*,*pipe*"});
  const std::string error = error_of(words);
  EXPECT_NE(error.find("\"pipe 1\" and \"beam 1\", which the rules leave out"), std::string::npos) << error;
  words.back() = "bolt*";
  EXPECT_EQ(check(words).exit_code, 1);
}

TEST_F(CheckRules, OfACaseThatLeaveNoPairAreItsError) {
  Json question = Json::parse(scene_of({"pipe", "beam"}));
  question["query"] = {{"question", "check"}, {"ignore", Json::parse(R"([{"a": ["*"], "b": ["*"]}])")}};
  folder.write("nothing.json", question.dump());
  const auto run = run_command({"replay", "nothing.json"}, folder.path());
  const std::string answer = run.out.substr(0, run.out.find('\n'));
  EXPECT_EQ(Json::parse(answer)["error"], "nothing would be checked: the rules leave no pair of two objects");
}

TEST_F(CheckRules, AreAskedAgainAndDrawn) {
  const std::string rules = "pipes = *pipe*\nbetween pipes, *\nignore bolt #2, pipes";
  const auto asked = check({"--json", "--save-case", "case.json"}, rules);
  const Json query = Json::parse(asked.out)["asked"]["query"];
  EXPECT_EQ(query["between"], Json::parse(R"([{"a": ["*pipe*"], "b": ["*"]}])"));
  EXPECT_EQ(query["ignore"], Json::parse(R"([{"a": ["bolt #2"], "b": ["*pipe*"]}])"));
  EXPECT_EQ(run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
  folder.write("report.json", asked.out);
  const auto drawn = run_command({"view", "report.json", "-o", "page.html"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.err.find("another answer"), std::string::npos) << drawn.err;
}

}  // namespace
}  // namespace toccata
