#include "environment.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {

Seconds seconds_of_environment(const char* name, Seconds otherwise, Seconds longest, const char* longest_words) {
  const char* const word = std::getenv(name);
  if (word == nullptr || *word == '\0') return otherwise;
  double seconds = 0;
  const char* const end = word + std::string_view(word).size();
  const auto [rest, error] = std::from_chars(word, end, seconds);
  if (error != std::errc{} || rest != end || !(seconds > 0) || Seconds(seconds) > longest)
    throw Error(fmt::format("{} is '{}': give seconds above 0, at most {}, or leave it out", name, printable(word),
                            longest_words));
  return Seconds(seconds);
}

}  // namespace toccata::command
