#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

#include "io/formats/text_cursor.hpp"

namespace toccata::io {

/// Calls `read` at the start of every line of a text file that has words in it; commas and what else is among the
/// `blanks` count as blanks, # starts a comment. Throws Error as `read` does.
void for_each_line_of_numbers(const std::filesystem::path& path, const std::function<void(TextCursor&)>& read,
                              std::string_view blanks = ",");

/// The numbers left on the cursor's line: the first `most` of them, and how many there were.
template <std::size_t Most>
struct NumbersOfLine {
  std::array<double, Most> number{};
  std::size_t count = 0;
};

template <std::size_t Most>
NumbersOfLine<Most> numbers_of_line(TextCursor& cursor) {
  NumbersOfLine<Most> line;
  for (; !cursor.at_line_end(); ++line.count) {
    const double number = cursor.number("the number");
    if (line.count < Most) line.number[line.count] = number;
  }
  return line;
}

}  // namespace toccata::io
