#include "converted.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "environment.hpp"
#include "file_text.hpp"
#include "installed_program.hpp"
#include "output.hpp"
#include "run_program.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

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

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

void require_success(const std::string& path, const Converter& converter, std::optional<int> status,
                     const fs::path& err) {
  if (!status && UninterruptedWriting::is_interrupted()) throw Error(path + ": reading it was interrupted");
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
  const fs::path scene = folder.path() / "scene.json";
  std::vector<std::string> words = {program, path, scene.string()};
  if (!conversion.tessellation.empty() && converter.has_curved_faces)
    words.insert(words.end(), {"--tessellation", conversion.tessellation});
  const Seconds longest = patience();
  require_success(path, converter, run_program(words, folder.path(), longest), folder.path() / "err");
  ConvertedScene converted{read_scene(scene.string(), {.scale = conversion.scale}), {}};
  if (conversion.metres_per_unit) {
    converted.scene = scaled(std::move(converted.scene), *conversion.metres_per_unit);
    converted.scene.unit = "m";
  }
  for (const std::string& note : lines_in(text_of_file(folder.path() / "out")))
    converted.notes.push_back(fmt::format("{}: {}", path, note));
  return converted;
}

}  // namespace

bool is_read_by_program(const std::string& path) { return converter_of(path) != nullptr; }

bool is_converted(const std::string& path) { return lower_extension(path) == ".3mf" || is_read_by_program(path); }

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
