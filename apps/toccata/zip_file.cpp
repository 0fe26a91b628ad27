#include "zip_file.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <filesystem>
#include <string_view>
#include <system_error>

#include "memory.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};

[[noreturn]] void fail_to_pack(const std::string& what) { throw Error("a zip file cannot be made: " + what); }

void add_entry(zip_t* archive, const ZipEntry& entry) {
  zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
  if (source == nullptr) fail_to_pack(zip_strerror(archive));
  const zip_int64_t number = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (number < 0) {
    zip_source_free(source);
    fail_to_pack(zip_strerror(archive));
  }
  const auto place = static_cast<zip_uint64_t>(number);
  zip_set_file_compression(archive, place, entry.stored == ZipStored::as_it_is ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 0);
  zip_file_set_dostime(archive, place, 0, 0x21, 0);  // 1980-01-01: no two runs differ
}

std::string bytes_in(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) fail_to_pack("its bytes cannot be read");
  std::string bytes(stat.size, '\0');
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (count != static_cast<zip_int64_t>(bytes.size())) fail_to_pack("its bytes cannot be read");
  return bytes;
}

bool leads_outside(std::string_view name) {
  if (name.starts_with('/') || name.find('\\') != std::string_view::npos || name.find(':') != std::string_view::npos)
    return true;
  const std::filesystem::path path(name);
  return std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

std::string zip_of(const std::vector<ZipEntry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, FreeSource> source(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!source) fail_to_pack(zip_error_strerror(&error));
  zip_t* archive = zip_open_from_source(source.get(), ZIP_TRUNCATE, &error);
  if (archive == nullptr) fail_to_pack(zip_error_strerror(&error));
  zip_source_keep(source.get());  // the archive gives its own up when it is closed
  try {
    for (const ZipEntry& entry : entries) add_entry(archive, entry);
  } catch (...) {
    zip_discard(archive);
    throw;
  }
  if (zip_close(archive) != 0) {
    const std::string what = zip_strerror(archive);
    zip_discard(archive);
    fail_to_pack(what);
  }
  return bytes_in(source.get());
}

void ZipFile::Discard::operator()(zip* opened) const { zip_discard(opened); }

ZipFile::ZipFile(const std::string& path) : path_(path) {
  std::error_code code;
  if (!std::filesystem::exists(path, code))
    throw Error(path + ": there is no such file; check the name and the folder");
  int trouble = 0;
  zip_.reset(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &trouble));
  if (!zip_) {
    zip_error_t error;
    zip_error_init_with_code(&error, trouble);
    const std::string what = zip_error_strerror(&error);
    zip_error_fini(&error);
    throw Error(
        fmt::format("{}: the file cannot be unpacked: {}; it is cut short or no zip: export it again", path, what));
  }
  require_harmless();
}

void ZipFile::require_harmless() const {
  constexpr double most_ratio = 400, always_fine = 64e6;
  double packed = 0, unpacked = 0;
  const zip_int64_t count = zip_get_num_entries(zip_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    if (zip_stat_index(zip_.get(), static_cast<zip_uint64_t>(i), 0, &stat) != 0) continue;
    if (leads_outside(stat.name))
      throw Error(fmt::format("{}: the entry '{}' leads out of the file; do not trust where it comes from", path_,
                              printable(stat.name)));
    packed += static_cast<double>(stat.comp_size);
    unpacked += static_cast<double>(stat.size);
  }
  if (unpacked > always_fine && (unpacked > most_ratio * packed || unpacked > memory_of_machine().most))
    throw Error(
        fmt::format("{}: {:.3g} MB of it unpack to {:.3g} MB, as of a file that was made to fill the memory; "
                    "do not trust where it comes from",
                    path_, 1e-6 * packed, 1e-6 * unpacked));
}

bool ZipFile::has(const std::string& entry) const { return zip_name_locate(zip_.get(), entry.c_str(), 0) >= 0; }

std::string ZipFile::bytes_of(const std::string& entry) const {
  zip_stat_t stat;
  if (zip_stat(zip_.get(), entry.c_str(), 0, &stat) != 0)
    throw Error(fmt::format("{}: there is no '{}' in it; export it again", path_, printable(entry)));
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen(zip_.get(), entry.c_str(), 0), zip_fclose);
  std::string bytes(stat.size, '\0');
  char beyond = 0;
  const bool is_whole = file &&
                        zip_fread(file.get(), bytes.data(), bytes.size()) == static_cast<zip_int64_t>(stat.size) &&
                        zip_fread(file.get(), &beyond, 1) == 0;
  if (!is_whole) throw Error(fmt::format("{}: the entry '{}' is damaged; export it again", path_, printable(entry)));
  return bytes;
}

}  // namespace toccata::command
