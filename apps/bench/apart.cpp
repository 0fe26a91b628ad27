#include "apart.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>

#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

[[noreturn]] void answer(const std::function<std::string()>& work, int to) {
  int state = 1;
  try {
    const std::string text = work();
    std::size_t written = 0;
    while (written < text.size()) {
      const ssize_t more = write(to, text.data() + written, text.size() - written);
      if (more <= 0) break;
      written += static_cast<std::size_t>(more);
    }
    state = written == text.size() ? 0 : 1;
  } catch (const std::exception&) {
    state = 1;
  }
  _exit(state);
}

/// Until the other side closes.
std::string read_all(int from) {
  std::string text;
  std::array<char, 4096> piece{};
  for (;;) {
    const ssize_t got = read(from, piece.data(), piece.size());
    if (got <= 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

std::optional<std::string> result_apart(const std::function<std::string()>& work, double seconds) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw Error("no pipe to another process could be made");
  std::fflush(nullptr);  // or it would write what waits to be written once more
  const pid_t child = fork();
  if (child < 0) throw Error("no other process could be made");
  if (child == 0) {
    // The processor's time: where other programs run meanwhile, the answer does not depend on them.
    const auto limit = static_cast<rlim_t>(std::ceil(seconds));
    const rlimit both{limit, limit};
    setrlimit(RLIMIT_CPU, &both);
    answer(work, ends[1]);
  }
  close(ends[1]);
  std::string text = read_all(ends[0]);
  close(ends[0]);
  int state = 0;
  waitpid(child, &state, 0);
  if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) return std::nullopt;
  return text;
}

}  // namespace toccata::bench
