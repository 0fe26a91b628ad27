#include "view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "output.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

bool is_gltf(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".glb" || extension == ".gltf";
}

/// Without its folders; of "gears/scene.json", whose name tells nothing, with one.
std::string short_name(const std::string& file) {
  const fs::path path(file);
  if (file.starts_with("gen:")) return file;
  const bool is_telling = path.stem() != "scene" || !path.has_parent_path();
  return (is_telling ? path.filename() : path.parent_path().filename() / path.filename()).string();
}

}  // namespace

UpAxis up_of(const std::vector<std::string>& files) {
  return !files.empty() && std::all_of(files.begin(), files.end(), is_gltf) ? UpAxis::y : UpAxis::z;
}

std::string title_of(const std::vector<std::string>& files) {
  constexpr std::size_t most_files = 4;
  std::string title;
  for (std::size_t i = 0; i < std::min(files.size(), most_files); ++i)
    title += (i == 0 ? "" : ", ") + short_name(files[i]);
  return files.size() > most_files ? fmt::format("{} and {} more", title, files.size() - most_files) : title;
}

void write_view(const ViewTarget& target, const CheckInput& input, const CheckReport& report) {
  const LoadedScene& loaded = input.loaded;
  const std::string page = view_page(loaded.scene, input.models, report, {target.title, target.up}, loaded.warnings);
  const UninterruptedWriting writing;
  write_view_page(page, target.path);
}

int run_view(const ViewArguments& arguments) {
  if (arguments.html.empty()) throw Error("no page was named: say where it shall be written with -o FILE.html");
  require_touching_counts(arguments);
  CheckInput input = read_check_input(arguments);
  warn_of_open_meshes(input);
  const ClearanceQuestion clearances = read_clearances(arguments, input.loaded.scene);
  const CheckAnswer answer = answer_with_progress(input.models, arguments, clearances);
  const CheckReport report = make_check_report(
      input.models, answer, {arguments.touching, true, arguments.penetration, clearances.common, clearances.of_pairs});
  print_warnings(input.loaded.warnings);
  const UpAxis up = arguments.up.empty() ? up_of(arguments.input.files) : arguments.up == "y" ? UpAxis::y : UpAxis::z;
  write_view({arguments.html, up, title_of(arguments.input.files)}, input, report);
  print_answer(fmt::format("{}: {} and {}, {} MB; open it in a browser.\n", printable(arguments.html),
                           counted(input.models.size(), "object"), counted(report.pairs.size(), "pair"),
                           fmt::format("{:.1f}", static_cast<double>(fs::file_size(arguments.html)) / 1e6)));
  return 0;
}

}  // namespace toccata::command
