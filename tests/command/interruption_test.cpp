// Ctrl-C at any moment of `demo --write` leaves the whole folder or none of it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <chrono>
#include <thread>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;

/// Runs `demo --write scenes` in the folder and interrupts it after the delay.
void write_interrupted(const TemporaryFolder& folder, std::chrono::microseconds delay) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // A group of its own, so that the interruption reaches the command and not the tests.
    setpgid(0, 0);
    // This process waits on, also when it is interrupted; the command gets the default action back when it starts.
    struct sigaction wait_on = {};
    wait_on.sa_handler = [](int) {};
    wait_on.sa_flags = SA_RESTART;
    sigaction(SIGINT, &wait_on, nullptr);
    const bool finished = run_command({"demo", "--write", "scenes"}, folder.path()).exit_code == 0;
    _exit(finished ? 0 : 1);
  }
  std::this_thread::sleep_for(delay);
  kill(-child, SIGINT);
  waitpid(child, nullptr, 0);
}

bool is_complete(const std::filesystem::path& scenes) {
  return run_command({"check", (scenes / "a.obj").string(), (scenes / "b.stl").string()}).exit_code == 1 &&
         run_command({"check", (scenes / "helices/scene.json").string()}).exit_code == 0 &&
         std::filesystem::exists(scenes / "README.md");
}

TEST(Interruption, LeavesNoHalfFolder) {
  for (int step = 0; step < 12; ++step) {
    const TemporaryFolder folder;
    write_interrupted(folder, std::chrono::milliseconds(4 * step));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "scenes.partial"));
    const std::filesystem::path scenes = folder.path() / "scenes";
    if (std::filesystem::exists(scenes)) {
      EXPECT_TRUE(is_complete(scenes)) << step;
    }
  }
}

}  // namespace
}  // namespace toccata
