#include "view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "ask.hpp"
#include "look.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/suggestion.hpp"
#include "toccata/io/case_file.hpp"
#include "toccata/io/glb_file.hpp"
#include "toccata/io/output_file.hpp"
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

/// Of its name; none for an empty one.
std::optional<CostVolume> volume_of(const std::string& name) {
  if (name.empty()) return std::nullopt;
  std::vector<std::string> known;
  for (const CostVolume volume : all_cost_volumes) {
    if (name == name_of(volume)) return volume;
    known.emplace_back(name_of(volume));
  }
  throw Error(fmt::format("--hierarchy: there is no volume '{}'{}", name, suggestion(name, known)));
}

ViewTarget target_of(const ViewArguments& arguments) {
  if (arguments.html.empty() && arguments.png.empty() && arguments.glb.empty())
    throw Error(
        "no page was named: say where it shall be written with -o FILE.html, or a picture with --png FILE.png, or a "
        "GLB "
        "file with --glb FILE.glb");
  if (arguments.png.empty() && !(arguments.size.empty() && arguments.look.empty()))
    throw Error("--size and --look are of a picture: say where it shall be written with --png FILE.png");
  const std::vector<std::string>& files = arguments.input.files;
  const UpAxis up = arguments.up.empty() ? up_of(files) : arguments.up == "y" ? UpAxis::y : UpAxis::z;
  ViewTarget target{arguments.html, arguments.glb, {title_of(files), up, volume_of(arguments.hierarchy)}, {}};
  if (arguments.png.empty()) return target;
  require_known_keys(arguments.look);
  target.picture = PictureTarget{arguments.png, arguments.look};
  if (!arguments.size.empty()) set_size(*target.picture, arguments.size);
  return target;
}

/// What a case asks about pairs is shown as it asks it, where the options say nothing else.
void take_question(CheckQuestion& shown, const SceneQuestion& asked, std::size_t objects) {
  if (const auto* distance = std::get_if<DistanceQuestion>(&asked)) {
    const bool all_pairs = distance->first_objects == 0 || objects == 2;
    if (all_pairs && !shown.clearance) shown.clearance = std::numeric_limits<double>::infinity();
  }
  const auto* check = std::get_if<CheckQuestion>(&asked);
  if (check == nullptr) return;
  shown.penetration = shown.penetration || check->penetration;
  if (shown.clearance) return;
  shown.touching = check->touching;
  shown.clearance = check->clearance;
  shown.pair_clearances = check->pair_clearances;
}

CheckQuestion shown_question(const ViewArguments& arguments, const CheckInput& input) {
  CheckQuestion shown = check_question(arguments, true, read_clearances(arguments, input.loaded.scene));
  const std::vector<std::string>& files = arguments.input.files;
  if (files.size() != 1 || fs::path(files[0]).extension() != ".json") return shown;
  if (const auto asked = read_case(files[0]).question) take_question(shown, *asked, input.models.size());
  return shown;
}

double megabytes_of(const std::string& file) { return static_cast<double>(fs::file_size(file)) / 1e6; }

/// What was written, a line each.
std::string told_of(const ViewTarget& target, const std::string& holds) {
  std::string told;
  if (!target.path.empty())
    told += fmt::format("{}: {}, {:.1f} MB; open it in a browser.\n", printable(target.path), holds,
                        megabytes_of(target.path));
  if (!target.glb.empty())
    told += fmt::format("{}: {}, {:.1f} MB; open it in Blender or another program for glTF.\n", printable(target.glb),
                        holds, megabytes_of(target.glb));
  if (target.picture) told += fmt::format("{}: a picture of {}.\n", printable(target.picture->path), holds);
  return told;
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

void require_view(const ViewTarget& target, const PosedArguments& arguments) {
  require_distinct({{"-o or --html", target.path},
                    {"--glb", target.glb},
                    {"--png", target.picture ? target.picture->path : ""},
                    {"--save-case", arguments.save_case}},
                   arguments.input.files);
  if (!target.path.empty()) require_output(target.path, OutputKind::page);
  if (!target.glb.empty()) require_output(target.glb, OutputKind::glb);
  if (target.picture) require_picture(*target.picture);
}

void write_view(const ViewTarget& target, const CheckInput& input, const CheckReport& report) {
  const LoadedScene& loaded = input.loaded;
  const std::string page = target.path.empty() && !target.picture
                               ? ""
                               : view_page(loaded.scene, input.models, report, target.options, loaded.warnings);
  const std::string glb = target.glb.empty() ? "" : scene_glb(loaded.scene, input.models, report, target.options);
  if (target.picture) write_picture(page, *target.picture);
  const UninterruptedWriting writing;
  if (!target.path.empty()) write_view_page(page, target.path);
  if (!target.glb.empty()) write_glb(glb, target.glb);
}

int run_view(const ViewArguments& arguments) {
  const ViewTarget target = target_of(arguments);
  require_view(target, arguments);
  require_touching_counts(arguments);
  CheckInput input = read_check_input(arguments);
  warn_of_open_meshes(input);
  const CheckQuestion question = shown_question(arguments, input);
  const CheckReport report = std::get<CheckReport>(ask_for(input, question, arguments, "checking"));
  print_warnings(input.loaded.warnings);
  write_view(target, input, report);
  print_answer(
      told_of(target, counted(input.models.size(), "object") + " and " + counted(report.pairs.size(), "pair")));
  return 0;
}

}  // namespace toccata::command
