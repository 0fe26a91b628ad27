#include "io/formats/file_bytes.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/formats/file_error.hpp"

namespace toccata::io {
namespace fs = std::filesystem;
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

std::string last_system_error() { return std::generic_category().message(errno); }

void require_regular_file(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found)
    fail_in_file(path.string(), {"there is no such file", "check the name and the folder"});
  if (fs::is_directory(status)) fail_in_file(path.string(), {"this is a directory", "name a file in it"});
  if (!fs::exists(status))
    fail_in_file(path.string(), {"the file cannot be reached: " + code.message(), "check the permissions"});
  if (!fs::is_regular_file(status))
    fail_in_file(path.string(), {"this is not a regular file", "save the data as a file first"});
}

/// A file that nobody else has, beside the one to be written, so that a rename is one step of the file system.
struct TemporaryFile {
  fs::path path;
  File file;

  explicit TemporaryFile(const fs::path& target) {
    constexpr int attempts = 1000;
    for (int attempt = 0; attempt < attempts && !file; ++attempt) {
      path = target;
      path += ".part" + std::to_string(attempt);
      file.reset(std::fopen(path.string().c_str(), "wbx"));
      if (!file && errno != EEXIST) break;
    }
    if (!file)
      fail_in_file(target.string(),
                   {"the file cannot be written: " + last_system_error(), "check the folder and its permissions"});
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    file.reset();
    if (std::error_code code; !path.empty()) fs::remove(path, code);
  }
};

}  // namespace

FileBytes read_file(const fs::path& path) {
  require_regular_file(path);
  const File file(std::fopen(path.string().c_str(), "rb"));
  if (!file)
    fail_in_file(path.string(), {"the file cannot be opened: " + last_system_error(), "check the permissions"});
  std::error_code code;
  const auto size = fs::file_size(path, code);
  if (code) fail_in_file(path.string(), {"the file has no size: " + code.message(), "check the file system"});
  if (size == 0) fail_in_file(path.string(), {"the file is empty", "export it again"});

  FileBytes bytes{std::make_unique_for_overwrite<char[]>(size), static_cast<std::size_t>(size)};
  if (std::fread(bytes.data.get(), 1, bytes.size, file.get()) != bytes.size)
    fail_in_file(path.string(), {"the file cannot be read to its end", "see that nothing else is writing it"});
  return bytes;
}

void write_file(const fs::path& path, std::string_view text) {
  TemporaryFile temporary(path);
  const bool written = std::fwrite(text.data(), 1, text.size(), temporary.file.get()) == text.size();
  if (!written || std::fflush(temporary.file.get()) != 0)
    fail_in_file(path.string(), {"the file cannot be written: " + last_system_error(), "see if the disk is full"});
  temporary.file.reset();
  std::error_code code;
  fs::rename(temporary.path, path, code);
  if (code) fail_in_file(path.string(), {"the file cannot be written: " + code.message(), "choose another name"});
  temporary.path.clear();
}

void require_writable(const fs::path& path) { const TemporaryFile tried(path); }

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

}  // namespace toccata::io
