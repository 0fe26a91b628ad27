#include "support/stand_in_browser.hpp"

#include <cstdlib>

#include "support/command.hpp"

namespace toccata::test {

StandInBrowser::StandInBrowser(const std::string& script) : path_(std::getenv("PATH")) {
  namespace fs = std::filesystem;
  const fs::path program = folder_.write("chromium", "#!/bin/sh\n" + script);
  fs::permissions(program, fs::perms::owner_all);
  fs::create_directory(temporary());
  setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  setenv("TMPDIR", temporary().c_str(), 1);
  setenv("SEEN", (folder_.path() / "seen").c_str(), 1);
}

StandInBrowser::~StandInBrowser() {
  setenv("PATH", path_.c_str(), 1);
  unsetenv("TMPDIR");
  unsetenv("SEEN");
}

std::string StandInBrowser::seen() const { return text_of(folder_.path() / "seen"); }

const std::string& drawing_script() {
  static const std::string script = R"(for word in "$@"; do case $word in
  --screenshot=*) printf '\211PNG\r\n\032\n\000\000\000\rIHDR-----------------and the rest' > "${word#--screenshot=}" ;;
  file://*) printf '%s' "$word" > "$SEEN" ;;
esac; done
)";
  return script;
}

}  // namespace toccata::test
