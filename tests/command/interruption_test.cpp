// Ctrl-C at any moment of `demo --write` leaves the whole folder or none of it, and no end leaves a reader behind.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::command_file;
using test::run_command;
using test::TemporaryFolder;
using test::text_of;
namespace fs = std::filesystem;

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

/// While it lives, what runs here finds a script as the reader of IFC files; it tells its process and does not end.
class EndlessReader {
 public:
  EndlessReader() : path_(std::getenv("PATH")) {
    const fs::path program = folder_.write(
        "toccata-read-ifc", "#!/bin/sh\necho $$ > \"$0.new\"; mv \"$0.new\" \"$0.seen\"; exec sleep 100\n");
    fs::permissions(program, fs::perms::owner_all);
    folder_.write("a.ifc", "ISO-10303-21;");
    fs::create_directory(temporary());
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
    setenv("TMPDIR", temporary().c_str(), 1);
  }
  ~EndlessReader() {
    setenv("PATH", path_.c_str(), 1);
    unsetenv("TMPDIR");
  }
  EndlessReader(const EndlessReader&) = delete;
  EndlessReader& operator=(const EndlessReader&) = delete;

  [[nodiscard]] const fs::path& folder() const { return folder_.path(); }
  [[nodiscard]] fs::path temporary() const { return folder_.path() / "temporary"; }

  /// The process that reads, as soon as it does; ten seconds at most are waited.
  [[nodiscard]] pid_t process() const {
    const fs::path seen = folder_.path() / "toccata-read-ifc.seen";
    for (int i = 0; i < 1000 && !fs::exists(seen); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return fs::exists(seen) ? std::stoi(text_of(seen)) : 0;
  }

 private:
  TemporaryFolder folder_;
  std::string path_;
};

/// Not one that has ended and that nobody has asked about.
bool runs(pid_t process) {
  const std::string state = text_of(fs::path("/proc") / std::to_string(process) / "stat");
  return !state.empty() && state.find(") Z") == std::string::npos;
}

bool ends(pid_t process) {
  for (int i = 0; i < 1000 && runs(process); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !runs(process);
}

TEST(Interruption, EndsTheProgramThatReads) {
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const EndlessReader reader;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      setpgid(0, 0);
      execl(command_file().c_str(), "toccata", "check", (reader.folder() / "a.ifc").c_str(), nullptr);
      _exit(127);
    }
    const pid_t reading = reader.process();
    EXPECT_GT(reading, 0);
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_TRUE(reading == 0 || ends(reading)) << "the reader runs on";
    if (signal != SIGKILL) {
      EXPECT_TRUE(fs::is_empty(reader.temporary()));
    }
  }
}

}  // namespace
}  // namespace toccata
