#include "programs.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "measure.hpp"

namespace toccata::bench {

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ProcessRun run_program(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  int state = -1;
  rusage usage{};
  const double seconds = seconds_of([&] {
    if (posix_spawnp(&child, words[0].c_str(), &actions, nullptr, arguments.data(), environ) == 0)
      wait4(child, &state, 0, &usage);
  });
  posix_spawn_file_actions_destroy(&actions);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -1, seconds, seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1000};
}

}  // namespace toccata::bench
