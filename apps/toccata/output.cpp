#include "output.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {

void print_answer(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw Error("the answer could not be written to standard output: is the disk full or the pipe closed?");
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "toccata: warning: {}\n", printable(warning));
}

UninterruptedWriting::UninterruptedWriting() {
  sigset_t interruptions;
  sigemptyset(&interruptions);
  sigaddset(&interruptions, SIGINT);
  sigaddset(&interruptions, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &interruptions, &before_);
}

UninterruptedWriting::~UninterruptedWriting() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace toccata::command
