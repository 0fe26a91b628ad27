#include "run_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <thread>

#include "output.hpp"
#include "toccata/core/error.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace toccata::command {
namespace {

/// As execve takes them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// This program's, but that temporary files go to the folder: a program that is ended leaves some.
std::vector<std::string> environment_with(const std::filesystem::path& temporary) {
  std::vector<std::string> variables;
  for (char** one = environ; *one != nullptr; ++one)
    if (!std::string_view(*one).starts_with("TMPDIR=")) variables.emplace_back(*one);
  variables.push_back("TMPDIR=" + temporary.string());
  return variables;
}

/// All that execve takes, made before the process is: after fork other threads may hold the locks of the heap.
struct Program {
  std::vector<char*> words;
  std::vector<char*> environment;
  std::string out;
  std::string err;
};

/// What the new process does first. Gives why it could not become the program.
int become(const Program& program, pid_t begun_by) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != begun_by) return ECHILD;  // which was gone before it could be watched
  const std::array<const char*, 3> files = {"/dev/null", program.out.c_str(), program.err.c_str()};
  for (int i = 0; i < 3; ++i) {
    const int file = open(files[static_cast<std::size_t>(i)], i == 0 ? O_RDONLY : O_WRONLY | O_CREAT, 0600);
    if (file < 0 || dup2(file, i) < 0) return errno;
  }
  execve(program.words[0], program.words.data(), program.environment.data());
  return errno;
}

std::string message_of(int code) { return std::generic_category().message(code); }

/// The process of the program, in a group of its own.
pid_t begun(const Program& program) {
  std::array<int, 2> trouble{};  // by which the process says why it could not become the program; closed where it does
  if (pipe2(trouble.data(), O_CLOEXEC) != 0)
    throw Error(fmt::format("{} cannot be run: {}", program.words[0], message_of(errno)));
  // Whoever began this may have had it ignored, and nobody is told then how a program ended.
  std::signal(SIGCHLD, SIG_DFL);
  const pid_t parent = getpid(), process = fork();
  int code = errno;
  if (process == 0) {
    code = become(program, parent);
    _exit(write(trouble[1], &code, sizeof code) == sizeof code ? 1 : 2);
  }
  close(trouble[1]);
  const bool is_running = process > 0 && read(trouble[0], &code, sizeof code) == 0;
  close(trouble[0]);
  if (is_running) return process;
  if (process > 0) waitpid(process, nullptr, 0);
  throw Error(fmt::format("{} cannot be run: {}", program.words[0], message_of(code)));
}

std::optional<int> status_within(pid_t process, Seconds patience) {
  constexpr std::chrono::milliseconds shortest(1), longest(20);
  const auto end = std::chrono::steady_clock::now() + patience;
  int status = 0;
  for (auto pause = shortest;; pause = std::min(longest, 2 * pause)) {
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) return status;
    if (ended < 0 && errno != EINTR) throw Error("how a program ended is not known: " + message_of(errno));
    if (UninterruptedWriting::is_interrupted() || std::chrono::steady_clock::now() > end) {
      kill(-process, SIGKILL);
      waitpid(process, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(pause);
  }
}

}  // namespace

std::optional<int> run_program(std::vector<std::string> words, const std::filesystem::path& folder, Seconds patience) {
  std::vector<std::string> variables = environment_with(folder);
  return status_within(
      begun({pointers_to(words), pointers_to(variables), (folder / "out").string(), (folder / "err").string()}),
      patience);
}

}  // namespace toccata::command
