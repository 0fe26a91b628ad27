#pragma once

#include <filesystem>
#include <string>

#include "support/temporary_folder.hpp"

namespace toccata::test {

/// While it lives, what runs here finds a script as Chromium, and its temporary files in a folder with a trying name.
class StandInBrowser {
 public:
  /// The lines of a shell script; its environment names in SEEN a file in which it can say what it saw.
  explicit StandInBrowser(const std::string& script);
  ~StandInBrowser();
  StandInBrowser(const StandInBrowser&) = delete;
  StandInBrowser& operator=(const StandInBrowser&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
  [[nodiscard]] std::filesystem::path temporary() const { return folder_.path() / "50 % #1?"; }
  [[nodiscard]] std::string seen() const;

 private:
  TemporaryFolder folder_;
  std::string path_;
};

/// A script that writes the begin of a PNG, which is all that is looked at, and the address that it was given.
[[nodiscard]] const std::string& drawing_script();

}  // namespace toccata::test
