#pragma once

#include <filesystem>
#include <string>

namespace toccata::command {

/// All that is in a file; nothing where there is none.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace toccata::command
