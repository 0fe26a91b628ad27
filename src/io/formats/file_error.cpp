#include "io/formats/file_error.hpp"

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata::io {

void fail_in_file(std::string_view name, const FileProblem& problem) {
  throw Error(fmt::format("{}: {}; {}", name, problem.what, problem.advice));
}

void fail_at_line(std::string_view name, std::size_t line, const FileProblem& problem) {
  throw Error(fmt::format("{}:{}: {}; {}", name, line, problem.what, problem.advice));
}

void fail_at_byte(std::string_view name, std::size_t byte, const FileProblem& problem) {
  throw Error(fmt::format("{}: at byte {}: {}; {}", name, byte, problem.what, problem.advice));
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "…\"" : "\"");
}

}  // namespace toccata::io
