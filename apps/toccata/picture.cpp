#include "picture.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "file_text.hpp"
#include "finding_words.hpp"
#include "look.hpp"
#include "output.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace toccata::command {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

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

/// As posix_spawn takes them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// This program's, but that temporary files go to the folder: a browser that is ended leaves some.
std::vector<std::string> environment_with(const fs::path& temporary) {
  std::vector<std::string> variables;
  for (char** one = environ; *one != nullptr; ++one)
    if (!std::string_view(*one).starts_with("TMPDIR=")) variables.emplace_back(*one);
  variables.push_back("TMPDIR=" + temporary.string());
  return variables;
}

/// The process, silent, in a group of its own: a browser is many.
pid_t started(std::vector<std::string> words, const fs::path& temporary) {
  std::vector<std::string> variables = environment_with(temporary);
  const std::vector<char*> arguments = pointers_to(words), environment = pointers_to(variables);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int code = posix_spawn(&process, arguments[0], &files, &attributes, arguments.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (code != 0) throw Error(fmt::format("{} cannot be run: {}", words[0], std::generic_category().message(code)));
  return process;
}

/// Waits for the process; when it takes too long, or somebody wants an end of this, it and its children are ended.
void await(pid_t process) {
  constexpr std::chrono::minutes patience(2);
  const Clock::time_point end = Clock::now() + patience;
  while (waitpid(process, nullptr, WNOHANG) == 0) {
    if (UninterruptedWriting::is_interrupted() || Clock::now() > end) {
      kill(-process, SIGKILL);
      waitpid(process, nullptr, 0);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
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
  await(started(words_of(browser, folder.path(), target), folder.path()));
  if (UninterruptedWriting::is_interrupted()) return;
  const std::string picture = text_of_file(folder.path() / "picture.png");
  if (picture.empty())
    throw Error(fmt::format("{} drew no picture; write a page with -o and open it to see why", browser));
  write_output(picture, target.path, OutputKind::picture);
}

}  // namespace toccata::command
