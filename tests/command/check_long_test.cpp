// Long work: JSON lines as pairs are found, a limit of time, and Ctrl-C give what is done and say what is not.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
  return lines;
}

class CheckLong : public testing::Test {
 protected:
  void SetUp() override {
    // Forty knots on a heap: 780 pairs, most of which meet.
    folder.write("heap.json", heap(0).dump());
    folder.write("two.json",
                 R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "a", "generate": "box"},
                     {"name": "b", "generate": "box", "pose": [1,0,0, 0,1,0, 0,0,1, 0.5,0,0]},
                     {"name": "c", "generate": "box", "pose": [1,0,0, 0,1,0, 0,0,1, 2.5,0,0]}]})");
  }

  /// Boxes that meet each other, and after them the knots: the pairs of the former are done at once on any machine.
  static Json heap(int boxes) {
    Json scene = {{"format", "toccata-scene"}, {"version", 1}};
    for (int i = 0; i < boxes + 40; ++i) {
      const char* shape = i < boxes ? "box" : "torus-knot";
      scene["objects"].push_back({{"name", shape + std::to_string(i)},
                                  {"generate", shape},
                                  {"pose", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.01 * i, 0.007 * i, 0.003 * i}}});
    }
    return scene;
  }

  test::CommandResult run(const Words& words) { return run_command(words, folder.path()); }

  TemporaryFolder folder;
};

/// "checking 12/780, 3 s, 4.1 a second, some 3 min left", its numbers in step with each other.
void expect_rate_and_time_left(const std::string& seen) {
  const std::regex form(R"(checking[^\r\n]* (\d+)/(\d+), (\d+) s, ([\d.e+]+) a second, some (\d+) (s|min) left)");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(seen, found, form)) << seen;
  const double done = std::stod(found[1]), total = std::stod(found[2]), seconds = std::stod(found[3]),
               rate = std::stod(found[4]), left = std::stod(found[5]) * (found[6] == "min" ? 60 : 1);
  EXPECT_LE(done, total);
  EXPECT_NEAR(done / seconds, rate, rate * 0.6 / seconds + 0.01 * rate) << seen;                 // seconds are rounded
  EXPECT_NEAR((total - done) / rate, left, (found[6] == "min" ? 31 : 1) + 0.02 * left) << seen;  // so is the rate
}

TEST_F(CheckLong, ATerminalShowsTheRateAndTheTimeLeft) {
  expect_rate_and_time_left(
      test::seen_on_terminal({"check", (folder.path() / "heap.json").string(), "--penetration"}, " left"));
}

TEST_F(CheckLong, ElsewhereALineIsToldNowAndThen) {
  folder.write("boxes-and-heap.json", heap(8).dump());
  const auto told = [&](const char* seconds) {
    setenv("TOCCATA_PROGRESS_SECONDS", seconds, 1);
    auto result = run({"check", "boxes-and-heap.json", "--penetration", "--stop-after", "4"});
    unsetenv("TOCCATA_PROGRESS_SECONDS");
    return result;
  };
  const auto often = told("0.5");
  EXPECT_EQ(often.exit_code, 3);
  EXPECT_GE(std::count(often.err.begin(), often.err.end(), '\n'), 5) << often.err;
  EXPECT_EQ(often.err.find('\r'), std::string::npos) << often.err;
  expect_rate_and_time_left(often.err);
  EXPECT_EQ(told("3600").err.find("toccata: checking"), std::string::npos);
  for (const char* wrong : {"0", "-1", "soon", "nan", "1e9"}) {
    const auto refused = told(wrong);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find(std::string("TOCCATA_PROGRESS_SECONDS is '") + wrong), std::string::npos) << refused.err;
  }
}

TEST_F(CheckLong, AStreamHasAHeadALineForEachPairAndAnEnd) {
  const auto result = run({"check", "two.json", "--stream", "--faces"});
  EXPECT_EQ(result.exit_code, 1);
  const std::vector<Json> lines = lines_of(result.out);
  const Json whole = Json::parse(run({"check", "two.json", "--json", "--faces"}).out);
  ASSERT_EQ(lines.size(), 2 + whole["pairs"].size());
  EXPECT_EQ(lines.front()["schema"], "toccata/check-stream/1");
  EXPECT_EQ(lines.front()["objects"], Json({"a", "b", "c"}));
  std::vector<Json> pairs(lines.begin() + 1, lines.end() - 1);
  std::sort(pairs.begin(), pairs.end(), [](const Json& x, const Json& y) { return x["b_index"] < y["b_index"]; });
  EXPECT_EQ(Json(pairs), whole["pairs"]);
  EXPECT_EQ(lines.back()["complete"], true);
  EXPECT_EQ(lines.back()["pairs"], whole["pairs"].size());
}

TEST_F(CheckLong, AtItsLimitACheckTellsWhatIsLeftAndNeverLooksComplete) {
  const Words words{"check", "heap.json", "--penetration", "--stop-after", "0.001"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), words.begin(), words.end());
    return run(more);
  };
  const auto table = with({"--junit", "found.xml", "--sarif", "found.sarif", "--save-case", "case.json"});
  EXPECT_EQ(table.exit_code, 3);
  EXPECT_NE(table.out.find("Stopped: 780 pairs not looked at; what is told is right, and not all."), std::string::npos);
  EXPECT_EQ(table.out.find("Nothing collides"), std::string::npos);
  EXPECT_NE(table.err.find("the check was stopped at its time limit: 780 of 780 pairs"), std::string::npos)
      << table.err;
  EXPECT_NE(test::text_of(folder.path() / "found.xml").find("<error type=\"stopped\""), std::string::npos);
  EXPECT_EQ(
      Json::parse(test::text_of(folder.path() / "found.sarif"))["runs"][0]["invocations"][0]["executionSuccessful"],
      false);
  EXPECT_FALSE(Json::parse(test::text_of(folder.path() / "case.json")).contains("answer"));
  const Json json = Json::parse(with({"--json"}).out);
  EXPECT_EQ(json["unfinished"], 780);
  EXPECT_EQ(json["candidate_pairs"], 780);
  const std::string csv = with({"--csv"}).out;
  EXPECT_NE(csv.find("\n780 pairs not looked at,,unfinished,,,"), std::string::npos) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','),
            2 * std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ','));
  folder.write("stopped.json", json.dump());
  const auto compared = run({"check", "heap.json", "--baseline", "stopped.json"});
  EXPECT_EQ(compared.exit_code, 2);
  EXPECT_NE(compared.err.find("the check that wrote this report was stopped"), std::string::npos) << compared.err;
  const std::vector<Json> lines = lines_of(with({"--stream"}).out);
  EXPECT_EQ(lines.back()["complete"], false);
  EXPECT_EQ(lines.back()["unfinished"], 780);
}

TEST_F(CheckLong, AStoppedCheckDoesNotTakeWhatItDidNotLookAtForSolved) {
  folder.write("old.json", run({"check", "two.json", "--json"}).out);
  const auto result = run({"check", "two.json", "--baseline", "old.json", "--stop-after", "1e-9", "--json"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(Json::parse(result.out)["baseline"]["gone"].empty());
}

TEST_F(CheckLong, AWholeCheckWithinItsLimitIsAsWithoutOne) {
  const std::string plain = run({"check", "two.json", "--json"}).out;
  EXPECT_EQ(run({"check", "two.json", "--json", "--stop-after", "3600"}).out, plain);
}

/// Starts the command there, with its answer going to the file `out`.
pid_t started(const std::filesystem::path& folder, Words words) {
  const std::string program = test::command_file();
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  const bool is_ready = chdir(folder.c_str()) == 0 && std::freopen("out", "w", stdout) != nullptr &&
                        std::freopen("err", "w", stderr) != nullptr;
  if (is_ready) execv(program.c_str(), arguments.data());
  _exit(127);
}

TEST_F(CheckLong, InterruptedItTellsWhatIsDone) {
  const pid_t child = started(
      folder.path(), {"check", "heap.json", "--penetration", "--precision", "0.0001", "--threads", "1", "--stream"});
  ASSERT_GT(child, 0);
  const auto told = [&] { return test::text_of(folder.path() / "out"); };
  const auto lines = [&] { return std::ranges::count(told(), '\n'); };
  for (int i = 0; i < 6000 && lines() < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(child, SIGINT);
  int state = 0;
  waitpid(child, &state, 0);
  ASSERT_TRUE(WIFEXITED(state));
  EXPECT_EQ(WEXITSTATUS(state), 3);
  const std::vector<Json> found = lines_of(told());
  EXPECT_EQ(found.back()["complete"], false);
  EXPECT_GT(found.back()["unfinished"], 0);
  EXPECT_EQ(found.back()["pairs"], found.size() - 2);
  EXPECT_NE(test::text_of(folder.path() / "err").find("stopped as it was interrupted"), std::string::npos);
}

TEST_F(CheckLong, AStreamCountsWhatItDoesNotKeep) {
  folder.write("touching.json",
               R"({"format": "toccata-scene", "version": 1, "objects": [{"name": "a", "generate": "box"},
                   {"name": "b", "generate": "box", "pose": [1,0,0, 0,1,0, 0,0,1, 1,0,0]},
                   {"name": "c", "generate": "box", "pose": [1,0,0, 0,1,0, 0,0,1, 1.5,0,0]}]})");
  struct Expected {
    Words words;
    int code;
    std::size_t pairs, ignored;
  };
  const std::vector<Expected> all = {{{"--touching", "ignore"}, 1, 1, 1},
                                     {{"--fail-on", "hard"}, 1, 2, 0},
                                     {{"--fail-on", "hard", "--ignore", "b,c"}, 0, 1, 0},
                                     {{"--touching", "ignore", "--ignore", "b,c"}, 0, 0, 1}};
  for (const Expected& expected : all) {
    for (const Words& also : {Words{}, Words{"--junit", "found.xml"}}) {  // which needs the pairs later
      Words words{"check", "touching.json", "--stream"};
      words.insert(words.end(), expected.words.begin(), expected.words.end());
      words.insert(words.end(), also.begin(), also.end());
      const auto result = run(words);
      EXPECT_EQ(result.exit_code, expected.code) << result.out;
      const std::vector<Json> lines = lines_of(result.out);
      ASSERT_EQ(lines.size(), 2 + expected.pairs) << result.out;
      EXPECT_EQ(lines.back()["pairs"], expected.pairs);
      EXPECT_EQ(lines.back()["ignored_touching"], expected.ignored);
      EXPECT_EQ(lines.back()["complete"], true);
    }
  }
}

/// In kilobytes, the most memory that it has had, as the system told it last before the end.
double peak_memory_of(pid_t child) {
  const std::string file = "/proc/" + std::to_string(child) + "/status", label = "VmHWM:";
  double peak = 0;
  while (waitpid(child, nullptr, WNOHANG) == 0) {
    const std::string status = test::text_of(file);
    if (const std::size_t at = status.find(label); at != std::string::npos)
      peak = std::stod(status.substr(at + label.size()));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return peak;
}

// Sanitizers keep what is freed, so it is one of those that they do not repeat.
using CheckLongSlow = CheckLong;

TEST_F(CheckLongSlow, MemoryDoesNotFollowThePairsThatAreStreamed) {
  if (!std::filesystem::exists("/proc/self/status")) GTEST_SKIP() << "this system does not tell what memory is used";
  const auto in_a_row = [&](double step) {
    Json scene = {{"format", "toccata-scene"}, {"version", 1}};
    for (int i = 0; i < 40; ++i)
      scene["objects"].push_back({{"name", "ball " + std::to_string(i)},
                                  {"generate", "uv-sphere"},
                                  {"parameters", {{"around", 24}, {"along", 12}}},
                                  {"pose", {1, 0, 0, 0, 1, 0, 0, 0, 1, step * i, 0.7 * step * i, 0.3 * step * i}}});
    folder.write("balls.json", scene.dump());
    const double peak =
        peak_memory_of(started(folder.path(), {"check", "balls.json", "--threads", "1", "--stream", "--faces"}));
    const std::string told = test::text_of(folder.path() / "out");
    const std::string end = told.substr(told.rfind('\n', told.size() - 2) + 1);
    const auto pairs = Json::parse(end)["pairs"].get<std::size_t>();
    return std::pair(peak, pairs);
  };
  const auto [least, few] = in_a_row(1);
  const auto [most, many] = in_a_row(0.05);
  EXPECT_EQ(few, 39U);
  EXPECT_GT(many, 15 * few);
  ASSERT_GT(least, 0);
  EXPECT_LT(most, 1.5 * least) << many << " pairs with their faces, for " << few;
}

}  // namespace
}  // namespace toccata
