#include "named_files.hpp"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

#include "converted.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

/// What is read but scene files, by extension. These name meshes that often lie beside them, and no folder stands for
/// them.
std::vector<std::string> formats_of(FormatsOf which) {
  std::vector<std::string> formats{"obj", "stl", "ply", "off", "gltf", "glb"};
  for (std::string& converted : converted_formats(which)) formats.push_back(std::move(converted));
  return formats;
}

bool is_one_of(FormatsOf which, const std::string& format) {
  const std::vector<std::string> formats = formats_of(which);
  return std::ranges::find(formats, format) != formats.end();
}

std::string lower_case_format(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension.empty() ? extension : extension.substr(1);
}

bool is_in_folders(const fs::path& path) { return is_one_of(FormatsOf::folders, lower_case_format(path)); }

std::vector<std::string> files_in(const std::string& folder) {
  std::error_code code;
  std::vector<std::string> files;
  std::size_t others = 0;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    std::error_code unknown;
    if (is_in_folders(entry->path()) && entry->is_regular_file(unknown))
      files.push_back(entry->path().string());
    else
      ++others;
  }
  if (code) throw Error(fmt::format("{}: the folder cannot be read: {}", folder, code.message()));
  if (files.empty())
    throw Error(fmt::format("{}: no mesh file is in this folder, of {}; what is read is {}", folder,
                            counted(others, "entry", "entries"), readable_formats()));
  std::sort(files.begin(), files.end());
  return files;
}

bool is_pattern(const std::string& word) { return word.find_first_of("*?[") != std::string::npos; }

/// For shells that leave patterns as they are.
std::vector<std::string> files_matching(const std::string& pattern) {
  glob_t found{};
  const int code = glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> files(found.gl_pathv, found.gl_pathv + (code == 0 ? found.gl_pathc : 0));
  globfree(&found);
  std::erase_if(files, [](const std::string& file) {
    std::error_code unknown;
    return fs::is_directory(file, unknown);
  });
  if (files.empty())
    throw Error(fmt::format("{}: no file has a name like this; check the pattern and the folder", pattern));
  return files;
}

std::vector<std::string> lines_of(std::istream& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  }
  return lines;
}

/// The lines of the file --names, as they stand.
std::vector<std::string> listed_in(const std::string& list) {
  std::vector<std::string> names;
  if (list == standard_input) {
    std::istringstream stream(read_standard_input());
    names = lines_of(stream);
  } else {
    std::ifstream stream(list);
    if (!stream) throw Error(fmt::format("--names {}: the file cannot be opened; check its name", list));
    names = lines_of(stream);
  }
  if (names.empty()) throw Error(fmt::format("--names {}: no file is named in it; write one on each line", list));
  return names;
}

std::vector<std::string> files_of_word(const std::string& word) {
  std::error_code unknown;
  if (word == standard_input || is_generator_specification(word)) return {word};
  if (fs::is_directory(word, unknown)) return files_in(word);
  if (is_pattern(word) && !fs::exists(word, unknown)) return files_matching(word);
  return {word};
}

void require_sense_of_standard_input(const InputArguments& input, const std::vector<std::string>& files) {
  const auto uses = std::count(files.begin(), files.end(), standard_input) + (input.names == standard_input ? 1 : 0);
  const bool holds_a_file = std::find(files.begin(), files.end(), standard_input) != files.end();
  if (uses > 1) throw Error("standard input (-) can be read once; name a file instead of the other -");
  if (holds_a_file && input.format.empty())
    throw Error(fmt::format("- is standard input, which has no name that tells its format: add --format, {}",
                            readable_formats()));
  if (!input.format.empty() && input.format != "json" && !is_one_of(FormatsOf::commands, input.format))
    throw Error(fmt::format("--format: '{}' is none that is read; there are {}", input.format, readable_formats()));
  if (!holds_a_file && !input.format.empty())
    throw Error("--format is of standard input, and no file is -: the others' names tell theirs");
}

}  // namespace

std::string readable_formats() {
  return fmt::format("{} or a scene file (json)", fmt::join(formats_of(FormatsOf::commands), ", "));
}

std::string read_standard_input() {
  std::cin >> std::noskipws;
  return {std::istreambuf_iterator<char>(std::cin), {}};
}

std::vector<std::string> named_files(const InputArguments& input) {
  std::vector<std::string> files;
  if (!input.names.empty()) files = listed_in(input.names);
  for (const std::string& word : input.files) {
    const std::vector<std::string> of_word = files_of_word(word);
    files.insert(files.end(), of_word.begin(), of_word.end());
  }
  require_sense_of_standard_input(input, files);
  return files;
}

}  // namespace toccata::command
