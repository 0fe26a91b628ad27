#include "output.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>

#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

/// The signal that came last; a handler can reach nothing else.
std::atomic<int> waiting_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

}  // namespace

void print_answer(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw Error("the answer could not be written to standard output: is the disk full or the pipe closed?");
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "toccata: warning: {}\n", printable(warning));
}

UninterruptedWriting::UninterruptedWriting() {
  // Blocking the signals would not do: they would reach a thread of the pool, and end the process there.
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    sigaction(signals_[i], nullptr, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN) continue;
    struct sigaction wait {};
    wait.sa_handler = [](int signal) { waiting_signal = signal; };
    wait.sa_flags = SA_RESTART;
    sigaction(signals_[i], &wait, nullptr);
  }
}

UninterruptedWriting::~UninterruptedWriting() {
  for (std::size_t i = 0; i < signals_.size(); ++i) sigaction(signals_[i], &before_[i], nullptr);
  if (const int signal = waiting_signal.exchange(0); signal != 0) raise(signal);
}

bool UninterruptedWriting::is_interrupted() { return waiting_signal != 0; }

void require_distinct(const std::vector<NamedOutput>& outputs, const std::vector<std::string>& inputs) {
  const auto place = [](const std::string& path) {
    std::error_code code;
    const fs::path absolute = fs::absolute(path, code), whole = fs::weakly_canonical(absolute, code);
    return code ? absolute : whole;
  };
  std::map<fs::path, std::string> named;
  for (const std::string& input : inputs) named.emplace(place(input), "a file that is read");
  for (const NamedOutput& output : outputs) {
    if (output.path.empty()) continue;
    const auto [other, is_new] = named.emplace(place(output.path), output.option);
    if (!is_new)
      throw Error(fmt::format("{} would write {}, which is {} too: give them different names", output.option,
                              output.path,
                              other->second.starts_with("-") ? "that of " + other->second : other->second));
  }
}

}  // namespace toccata::command
