#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct zip;

namespace toccata::command {

enum class ZipStored { compressed, as_it_is };

struct ZipEntry {
  std::string name;
  std::string bytes;
  ZipStored stored = ZipStored::compressed;
};

/// The bytes of a zip file of these entries, in their order; the same for the same entries.
[[nodiscard]] std::string zip_of(const std::vector<ZipEntry>& entries);

/// A zip file that somebody else made.
class ZipFile {
 public:
  /// Throws Error naming the file: that is no zip, names a path outside of its own folder, or unpacks to so much more
  /// than it holds that it was made to fill a disk or memory.
  explicit ZipFile(const std::string& path);

  [[nodiscard]] bool has(const std::string& entry) const;
  /// Throws Error naming the file and the entry that is not there, or damaged.
  [[nodiscard]] std::string bytes_of(const std::string& entry) const;

 private:
  struct Discard {
    void operator()(zip* opened) const;
  };

  void require_harmless() const;

  std::string path_;
  std::unique_ptr<zip, Discard> zip_;
};

}  // namespace toccata::command
