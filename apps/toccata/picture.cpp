#include "picture.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "file_text.hpp"
#include "finding_words.hpp"
#include "look.hpp"
#include "output.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

std::string find_browser() {
  const char* folders = std::getenv("PATH");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::string_view rest = folders == nullptr ? "" : folders;
    while (!rest.empty()) {
      const std::string_view folder = rest.substr(0, rest.find(':'));
      rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
      const fs::path program = fs::path(folder) / name;
      if (access(program.c_str(), X_OK) == 0) return program.string();
    }
  }
  throw Error(
      "no Chromium was found to draw a picture with: install it (apt-get install chromium), or write a page with -o");
}

std::vector<std::string> words_of(const std::string& browser, const fs::path& folder, const PictureTarget& target) {
  std::vector<std::string> words = {browser,
                                    "--headless",
                                    "--disable-gpu",
                                    "--use-angle=swiftshader",
                                    "--enable-unsafe-swiftshader",
                                    "--disable-quic",
                                    "--no-first-run",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--disable-sync",
                                    "--hide-scrollbars",
                                    "--virtual-time-budget=5000",
                                    "--user-data-dir=" + (folder / "profile").string(),
                                    fmt::format("--window-size={},{}", target.width, target.height),
                                    "--screenshot=" + (folder / "picture.png").string()};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which refuses to run for the administrator
  words.push_back("file://" + in_address((folder / "page.html").string()) + link_of_picture(target.look));
  return words;
}

int parse_extent(std::string_view text) {
  int extent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), extent);
  return error == std::errc() && end == text.data() + text.size() && extent >= 16 && extent <= 8192 ? extent : 0;
}

}  // namespace

void set_size(PictureTarget& target, const std::string& text) {
  const std::size_t cross = text.find('x');
  target.width = parse_extent(std::string_view(text).substr(0, cross));
  target.height = cross == std::string::npos ? 0 : parse_extent(std::string_view(text).substr(cross + 1));
  if (target.width == 0 || target.height == 0)
    throw Error(fmt::format("--size: '{}' is no size; write width and height from 16 to 8192, 1200x800", text));
}

void require_picture(const PictureTarget& target) {
  require_output(target.path, OutputKind::picture);
  static_cast<void>(find_browser());
}

void write_picture(const std::string& page, const PictureTarget& target) {
  require_picture(target);
  const std::string browser = find_browser();
  const UninterruptedWriting writing;
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "page.html", std::ios::binary) << page;
  constexpr std::chrono::minutes patience(2);
  static_cast<void>(run_program(words_of(browser, folder.path(), target), folder.path(), patience));  // a picture tells
  if (UninterruptedWriting::is_interrupted()) return;
  const std::string picture = text_of_file(folder.path() / "picture.png");
  if (picture.empty())
    throw Error(fmt::format("{} drew no picture; write a page with -o and open it to see why", browser));
  write_output(picture, target.path, OutputKind::picture);
}

}  // namespace toccata::command
