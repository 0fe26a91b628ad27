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

/// Where a link leads, and the links that it leads to; a rename would replace the link.
fs::path end_of_links(fs::path path) {
  constexpr int most_links = 40;  // as many as Linux follows
  for (int i = 0; i < most_links; ++i) {
    std::error_code code;
    const fs::path next = fs::read_symlink(path, code);
    if (code) break;  // no link
    path = path.parent_path() / next;
  }
  return path;
}

}  // namespace

FileBytes read_file(const fs::path& path) {
  require_regular_file(path);
  const OpenFile file(std::fopen(path.string().c_str(), "rb"));
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

FileInMaking::FileInMaking(const fs::path& target) : target_(end_of_links(target)) {
  constexpr int attempts = 1000;
  for (int attempt = 0; attempt < attempts && !file_; ++attempt) {
    path_ = target_;
    path_ += ".part" + std::to_string(attempt);
    file_.reset(std::fopen(path_.string().c_str(), "wb+x"));
    if (!file_ && errno != EEXIST) break;
  }
  if (!file_)
    fail_in_file(target.string(),
                 {"the file cannot be written: " + last_system_error(), "check the folder and its permissions"});
}

FileInMaking::FileInMaking(FileInMaking&& other) noexcept
    : target_(std::move(other.target_)), path_(std::exchange(other.path_, {})), file_(std::move(other.file_)) {}

FileInMaking::~FileInMaking() {
  file_.reset();
  if (std::error_code code; !path_.empty()) fs::remove(path_, code);
}

void FileInMaking::fail() const {
  fail_in_file(target_.string(), {"the file cannot be written: " + last_system_error(), "see if the disk is full"});
}

void FileInMaking::append(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
}

void FileInMaking::append(const FileInMaking& other) {
  std::FILE* const from = other.file_.get();
  if (std::fflush(from) != 0 || std::fseek(from, 0, SEEK_SET) != 0) fail();
  constexpr std::size_t at_once = std::size_t{1} << 20;
  std::string bytes(at_once, '\0');
  while (const std::size_t count = std::fread(bytes.data(), 1, at_once, from))
    append(std::string_view(bytes).substr(0, count));
  if (std::ferror(from) != 0 || std::fseek(from, 0, SEEK_END) != 0) fail();
}

void FileInMaking::forget_name() {
  std::error_code code;
  fs::remove(path_, code);
  if (!code) path_.clear();
}

void FileInMaking::complete() {
  if (std::fflush(file_.get()) != 0) fail();
  file_.reset();
  std::error_code code;
  fs::rename(path_, target_, code);
  if (code) fail_in_file(target_.string(), {"the file cannot be written: " + code.message(), "choose another name"});
  path_.clear();
}

void write_file(const fs::path& path, std::string_view text) {
  FileInMaking file(path);
  file.append(text);
  file.complete();
}

void require_writable(const fs::path& path) { const FileInMaking tried(path); }

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

}  // namespace toccata::io
