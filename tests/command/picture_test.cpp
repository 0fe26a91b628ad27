// `view --png` without a browser: a script stands in for Chromium and tells how it was called.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "support/command.hpp"
#include "support/stand_in_browser.hpp"

namespace toccata {
namespace {

using test::drawing_script;
using test::run_command;
using test::StandInBrowser;
using test::text_of;
namespace fs = std::filesystem;

TEST(Picture, IsMarkedAndReplacesOnlyItsOwn) {
  const StandInBrowser browser(drawing_script());
  const auto draw = [&](const std::string& file) {
    return run_command({"view", "gen:box", "--png", file}, browser.folder());
  };
  EXPECT_EQ(draw("a.png").exit_code, 0);
  EXPECT_EQ(draw("a.png").exit_code, 0);
  const std::string picture = text_of(browser.folder() / "a.png");
  EXPECT_EQ(picture.substr(33, 33), std::string("\0\0\0\x10tEXtSoftware\0Toccata\x54\xc4\xd0\x6e"
                                                "and t",
                                                33))
      << testing::PrintToString(picture.substr(33, 33));
  std::ofstream(browser.folder() / "theirs.png") << "\x89PNG\r\n\x1a\nof another program";
  const auto refused = draw("theirs.png");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("is not a picture of Toccata"), std::string::npos) << refused.err;
  EXPECT_TRUE(fs::is_empty(browser.temporary()));
}

TEST(Picture, FoldersOfAnyNameHaveAnAddress) {
  const StandInBrowser browser(drawing_script());
  EXPECT_EQ(run_command({"view", "gen:box", "--png", "a.png"}, browser.folder()).exit_code, 0);
  const std::string seen = browser.seen();
  EXPECT_NE(seen.find("/50%20%25%20%231%3F/toccata-"), std::string::npos) << seen;
  EXPECT_NE(seen.find("/page.html#"), std::string::npos) << seen;
  EXPECT_NE(seen.find("&panels=0"), std::string::npos) << seen;
}

TEST(Picture, OfABrowserThatDrawsNothingIsTold) {
  const StandInBrowser browser("exit 1\n");
  const auto result = run_command({"view", "gen:box", "--png", "a.png"}, browser.folder());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("drew no picture"), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(browser.folder() / "a.png"));
  EXPECT_TRUE(fs::is_empty(browser.temporary()));
}

/// Waits until `is_so`, ten seconds at most.
template <class Condition>
bool comes_true(const Condition& is_so) {
  for (int i = 0; i < 1000 && !is_so(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return is_so();
}

TEST(Picture, InterruptedLeavesNothingBehind) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const StandInBrowser browser("echo $$ > \"$SEEN.new\"; mv \"$SEEN.new\" \"$SEEN\"; sleep 100 & wait\n");
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      setpgid(0, 0);
      struct sigaction wait_on = {};  // the command gets the default action back when it starts
      wait_on.sa_handler = [](int) {};
      wait_on.sa_flags = SA_RESTART;
      for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaction(each, &wait_on, nullptr);
      const int code = run_command({"view", "gen:box", "--png", "a.png"}, browser.folder()).exit_code;
      _exit(code == 128 + signal ? 0 : 1);
    }
    ASSERT_TRUE(comes_true([&] { return !browser.seen().empty(); }));
    const pid_t drawing = std::stoi(browser.seen());
    kill(-child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << signal;
    EXPECT_TRUE(comes_true([&] { return kill(-drawing, 0) != 0; })) << "Chromium's processes run on";
    EXPECT_TRUE(fs::is_empty(browser.temporary()));
    EXPECT_FALSE(fs::exists(browser.folder() / "a.png"));
  }
}

}  // namespace
}  // namespace toccata
