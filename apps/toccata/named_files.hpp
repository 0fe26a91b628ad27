#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"

namespace toccata::command {

/// How standard input is named among files.
inline constexpr std::string_view standard_input = "-";

struct NamedFiles {
  std::vector<std::string> files;
  std::vector<std::string> warnings;  ///< of what lies in a folder, could be read, and is not
};

/// The files that the words name: what --names lists first, then each word. A folder stands for the mesh files in it, a
/// pattern (`*`, `?`, `[…]`) that is no file's name for the files that match, both in the order of their names. Throws
/// Error naming the word that stands for no file, and for what is said of standard input and does not fit.
[[nodiscard]] NamedFiles named_files(const InputArguments& input);

/// Extensions of the files that can be read (lower case, without the point), as a sentence has them.
[[nodiscard]] std::string readable_formats();

/// All that standard input holds.
[[nodiscard]] std::string read_standard_input();

}  // namespace toccata::command
