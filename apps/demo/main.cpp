#include <cstdio>
#include <exception>

#include "demo_text.hpp"
#include "output.hpp"
#include "toccata/core/parallel.hpp"

// What `toccata demo` prints, without the rest of the command: the first answer, which ./toccata builds in two thirds
// of the time.
int main() {
  try {
    toccata::command::print_answer(toccata::command::demo_text(toccata::all_threads));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "toccata: error: %s\n", error.what());
    return 2;
  }
}
