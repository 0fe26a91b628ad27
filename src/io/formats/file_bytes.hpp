#pragma once

#include <cstddef>
#include <cstdio>
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

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// A file that nobody else has, under a name of its own beside the one that it is made for, until it gets that name:
/// what is not completed goes away. Where the name is a symbolic link, it is made for what that leads to. Throws Error
/// naming the file that it is made for.
class FileInMaking {
 public:
  explicit FileInMaking(const std::filesystem::path& target);
  ~FileInMaking();
  FileInMaking(FileInMaking&& other) noexcept;
  FileInMaking& operator=(FileInMaking&&) = delete;
  FileInMaking(const FileInMaking&) = delete;
  FileInMaking& operator=(const FileInMaking&) = delete;

  void append(std::string_view bytes);
  /// Appends all that the other holds.
  void append(const FileInMaking& other);
  /// The file has no name from here on, and goes away with this object, or with the process, however that ends.
  void forget_name();
  /// Gives it the name that it is made for, by one step of the file system.
  void complete();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path target_, path_;
  OpenFile file_;
};

/// Writes the file under a name of its own beside it and renames it when it is complete. Throws Error naming the file.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws Error naming the file when write_file could not: its folder is missing, or cannot be written to.
void require_writable(const std::filesystem::path& path);

/// ".obj" for "A.OBJ"; empty when there is none.
[[nodiscard]] std::string lower_case_extension(const std::filesystem::path& path);

}  // namespace toccata::io
