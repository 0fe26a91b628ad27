#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace toccata::io {

/// The whole content of a file.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  [[nodiscard]] std::span<const char> span() const { return {data.get(), size}; }
};

/// Throws Error naming the file: missing, a directory or another thing that is no regular file, not readable, empty.
[[nodiscard]] FileBytes read_file(const std::filesystem::path& path);

/// Writes the file under a name of its own beside it and renames it when it is complete. Throws Error naming the file.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws Error naming the file when write_file could not: its folder is missing, or cannot be written to.
void require_writable(const std::filesystem::path& path);

/// ".obj" for "A.OBJ"; empty when there is none.
[[nodiscard]] std::string lower_case_extension(const std::filesystem::path& path);

}  // namespace toccata::io
