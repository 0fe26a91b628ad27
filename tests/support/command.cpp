#include "support/command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace toccata::test {
namespace {

void redirect(const std::filesystem::path& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
  close(opened);
}

[[noreturn]] void become_command(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::vector<char*> arguments;
  std::string program = command_file();
  arguments.push_back(program.data());
  std::vector<std::string> copies = words;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  if (chdir(folder.c_str()) == 0) execv(program.c_str(), arguments.data());
  _exit(127);
}

}  // namespace

std::string command_file() {
  const char* of_environment = std::getenv("TOCCATA_TEST_COMMAND");
  return of_environment != nullptr && *of_environment != '\0' ? of_environment : TOCCATA_COMMAND;
}

CommandResult run_command(const std::vector<std::string>& words, const std::filesystem::path& folder,
                          const std::filesystem::path& input) {
  const TemporaryFolder results;
  const std::filesystem::path out = results.path() / "out";
  const std::filesystem::path err = results.path() / "err";
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    if (!input.empty()) dup2(open(input.c_str(), O_RDONLY), STDIN_FILENO);
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    become_command(words, folder);
  }
  int state = 0;
  waitpid(child, &state, 0);
  const int code = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  return {code, text_of(out), text_of(err)};
}

std::string seen_on_terminal(const std::vector<std::string>& words, const std::string& awaited) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) throw std::runtime_error("no terminal");
  const std::string name = ptsname(terminal);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    redirect("/dev/null", STDOUT_FILENO);
    redirect(name, STDERR_FILENO);
    become_command(words, ".");
  }
  std::string seen;
  char bytes[4096];
  while (seen.find(awaited) == std::string::npos) {
    const ssize_t count = read(terminal, bytes, sizeof bytes);
    if (count > 0) seen.append(bytes, static_cast<std::size_t>(count));
    // Before the other side is opened, and after it is closed, there is nothing to read.
    if (count <= 0 && waitpid(child, nullptr, WNOHANG) != 0) return close(terminal), seen;
    if (count <= 0) usleep(1000);
  }
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  close(terminal);
  return seen;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace toccata::test
