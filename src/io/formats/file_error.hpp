#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace toccata::io {

/// What is wrong in a file and what its user can do about it. Both are put into one line.
struct FileProblem {
  std::string what;
  std::string advice;
};

/// Throw Error("name: what; advice"), with the line or the byte where there is one.
[[noreturn]] void fail_in_file(std::string_view name, const FileProblem& problem);
[[noreturn]] void fail_at_line(std::string_view name, std::size_t line, const FileProblem& problem);
[[noreturn]] void fail_at_byte(std::string_view name, std::size_t byte, const FileProblem& problem);

/// The text in quotes, cut when it is long, and with everything unprintable replaced: fit for a message.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace toccata::io
