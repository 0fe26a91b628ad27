#include "converted.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "environment.hpp"
#include "file_text.hpp"
#include "installed_program.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

/// A program that writes a scene file of what a file of such extensions holds.
struct Converter {
  std::string_view format;
  std::vector<std::string_view> extensions;
  const char* what;  ///< that it stands on
  bool states_unit = true;
  bool has_curved_faces = true;  ///< whose triangles --tessellation is about
  bool in_folders = true;        ///< whether a folder stands for its files too
};

const std::vector<Converter>& converters() {
  static const std::vector<Converter> all = {
      {"step", {".step", ".stp", ".p21"}, "Open CASCADE"},
      {"ifc", {".ifc"}, "IfcOpenShell"},
      {"assimp", {".fbx", ".dae"}, "Assimp", true, false, false},
      {"assimp", {".3ds", ".ac", ".ase", ".blend", ".dxf", ".lwo", ".x3d"}, "Assimp", false, false, false}};
  return all;
}

std::string lower_extension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

const Converter* converter_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  for (const Converter& one : converters())
    if (std::find(one.extensions.begin(), one.extensions.end(), extension) != one.extensions.end()) return &one;
  return nullptr;
}

std::string program_of(const Converter& converter, const std::string& file) {
  const std::string name = fmt::format("toccata-read-{}", converter.format);
  if (const auto program = installed_program(name)) return *program;
  // Through the wrapper of the repository one line installs and builds it.
  const std::string called = called_as();
  const std::string line = called.find('/') == std::string::npos ? "./toccata formats" : called + " formats";
  throw Error(
      fmt::format("{}: to read it takes {}, which is not there: `{} {}` (in the folder of Toccata's sources) "
                  "installs it, and builds {}",
                  file, converter.what, line, converter.format, name));
}

/// How long a program may take: a damaged file may lead it round for ever.
Seconds patience() {
  using namespace std::chrono_literals;
  return seconds_of_environment("TOCCATA_READER_SECONDS", 1h, 365 * 24h, "a year");
}

/// Its status, or none where it took too long, and was ended.
std::optional<int> awaited(pid_t process, Seconds patience) {
  constexpr std::chrono::milliseconds shortest(1), longest(20);
  const auto end = std::chrono::steady_clock::now() + patience;
  int status = 0;
  for (auto pause = shortest;; pause = std::min(longest, 2 * pause)) {
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) return status;
    if (ended < 0 && errno != EINTR)
      throw Error(fmt::format("how a reader ended is not known: {}", std::generic_category().message(errno)));
    if (std::chrono::steady_clock::now() > end) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(pause);
  }
}

std::optional<int> status_of(const std::vector<std::string>& words, const fs::path& out, const fs::path& err) {
  const Seconds longest = patience();
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t process = 0;
  // Whoever began this may have had it ignored, and nobody is told then how a program ended.
  std::signal(SIGCHLD, SIG_DFL);
  const int code = posix_spawn(&process, words[0].c_str(), &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (code != 0) throw Error(fmt::format("{} cannot be run: {}", words[0], std::generic_category().message(code)));
  return awaited(process, longest);
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

void require_success(const std::string& path, const Converter& converter, std::optional<int> status,
                     const fs::path& err) {
  if (!status)
    throw Error(
        fmt::format("{}: {} has not come to an end with it, and was ended: the file is damaged, or takes longer than "
                    "{:g} s; TOCCATA_READER_SECONDS in the environment gives it more",
                    path, converter.what, patience().count()));
  if (WIFSIGNALED(*status))
    throw Error(
        fmt::format("{}: {} broke down over it (signal {}): the file is damaged, or takes more than it can; "
                    "export it again",
                    path, converter.what, WTERMSIG(*status)));
  if (WEXITSTATUS(*status) == 0) return;
  const std::vector<std::string> said = lines_in(text_of_file(err));
  throw Error(
      fmt::format("{}: {}", path, said.empty() ? fmt::format("{} could not read it", converter.what) : said.back()));
}

ConvertedScene read_by_program(const std::string& path, const Converter& converter, const Conversion& conversion) {
  const std::string program = program_of(converter, path);
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown)) throw Error(path + ": there is no such file; check the name and the folder");
  const TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene.json", out = folder.path() / "out", err = folder.path() / "err";
  std::vector<std::string> words = {program, path, scene.string()};
  if (!conversion.tessellation.empty() && converter.has_curved_faces)
    words.insert(words.end(), {"--tessellation", conversion.tessellation});
  require_success(path, converter, status_of(words, out, err), err);
  ConvertedScene converted{read_scene(scene.string(), {.scale = conversion.scale}), {}};
  if (conversion.metres_per_unit) {
    converted.scene = scaled(std::move(converted.scene), *conversion.metres_per_unit);
    converted.scene.unit = "m";
  }
  for (const std::string& note : lines_in(text_of_file(out)))
    converted.notes.push_back(fmt::format("{}: {}", path, note));
  return converted;
}

}  // namespace

bool is_converted(const std::string& path) { return lower_extension(path) == ".3mf" || converter_of(path) != nullptr; }

std::vector<std::string> converted_formats(FormatsOf which) {
  std::vector<std::string> formats{"3mf"};
  for (const Converter& one : converters())
    if (which == FormatsOf::commands || one.in_folders)
      for (const std::string_view extension : one.extensions) formats.emplace_back(extension.substr(1));
  return formats;
}

bool states_its_unit(const std::string& path) {
  if (const Converter* converter = converter_of(path)) return converter->states_unit;
  return is_converted(path) || lower_extension(path) == ".json";
}

bool may_be_curved(const std::string& path) {
  const Converter* converter = converter_of(path);
  return converter != nullptr && converter->has_curved_faces;
}

ConvertedScene read_converted(const std::string& path, const Conversion& conversion) {
  if (const Converter* converter = converter_of(path)) return read_by_program(path, *converter, conversion);
  ConvertedScene converted = read_three_mf(path);
  converted.scene = scaled(std::move(converted.scene), conversion.scale);
  return converted;
}

}  // namespace toccata::command
