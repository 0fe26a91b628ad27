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
#include <utility>

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

/// Whether an entry of a folder that is not read could be, if it were named.
bool could_be_named(const fs::directory_entry& entry) {
  std::error_code unknown;
  if (entry.is_directory(unknown)) return true;
  const std::string format = lower_case_format(entry.path());
  return entry.is_regular_file(unknown) && (format == "json" || is_one_of(FormatsOf::commands, format));
}

std::string left_out_text(const std::string& folder, std::vector<std::string> left_out) {
  constexpr std::size_t most_named = 5;
  std::sort(left_out.begin(), left_out.end());
  const std::size_t more = left_out.size() - std::min(left_out.size(), most_named);
  left_out.resize(left_out.size() - more);
  return fmt::format(
      "{}: not read are {}{}: a folder stands for the mesh files directly in it; name what is to be read", folder,
      fmt::join(left_out, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

NamedFiles files_in(const std::string& folder) {
  std::error_code code;
  NamedFiles found;
  std::vector<std::string> left_out;
  std::size_t entries = 0;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code), ++entries) {
    std::error_code unknown;
    if (is_in_folders(entry->path()) && entry->is_regular_file(unknown))
      found.files.push_back(entry->path().string());
    else if (could_be_named(*entry))
      left_out.push_back(entry->path().filename().string() + (entry->is_directory(unknown) ? "/" : ""));
  }
  if (code) throw Error(fmt::format("{}: the folder cannot be read: {}", folder, code.message()));
  if (found.files.empty())
    throw Error(fmt::format("{}: no mesh file is in this folder, of {}; what is read of a folder is {}", folder,
                            counted(entries, "entry", "entries"), fmt::join(formats_of(FormatsOf::folders), ", ")));
  std::sort(found.files.begin(), found.files.end());
  if (!left_out.empty()) found.warnings.push_back(left_out_text(folder, std::move(left_out)));
  return found;
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

NamedFiles files_of_word(const std::string& word) {
  std::error_code unknown;
  if (word == standard_input || is_generator_specification(word)) return {{word}, {}};
  if (fs::is_directory(word, unknown)) return files_in(word);
  if (is_pattern(word) && !fs::exists(word, unknown)) return {files_matching(word), {}};
  return {{word}, {}};
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

NamedFiles named_files(const InputArguments& input) {
  NamedFiles named;
  if (!input.names.empty()) named.files = listed_in(input.names);
  for (const std::string& word : input.files) {
    const NamedFiles of_word = files_of_word(word);
    named.files.insert(named.files.end(), of_word.files.begin(), of_word.files.end());
    named.warnings.insert(named.warnings.end(), of_word.warnings.begin(), of_word.warnings.end());
  }
  require_sense_of_standard_input(input, named.files);
  return named;
}

}  // namespace toccata::command
