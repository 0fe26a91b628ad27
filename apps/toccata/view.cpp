#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "ask.hpp"
#include "case_asked.hpp"
#include "check_command.hpp"
#include "look.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "saved.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/case_file.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/pages.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct ViewArguments : CheckArguments {
  std::string hierarchy;      ///< the name of a bounding volume; empty: none is drawn
  std::string partition;      ///< the name of a partition of space; empty: none is drawn
  bool voronoi = false;       ///< the Voronoi regions of convex objects
  bool voronoi_walk = false;  ///< and the walk of each pair through them
};

namespace fs = std::filesystem;

/// ".json", however it is spelled.
std::string extension_of(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

bool is_gltf(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".glb" || extension == ".gltf";
}

/// Without its folders; of "gears/scene.json", whose name tells nothing, with one.
std::string short_name(const std::string& file) {
  const fs::path path(file);
  if (file.starts_with("gen:")) return file;
  const bool is_telling = path.stem() != "scene" || !path.has_parent_path();
  return (is_telling ? path.filename() : path.parent_path().filename() / path.filename()).string();
}

/// The one of that name; none for an empty name.
template <class Kinds>
std::optional<typename Kinds::value_type> kind_of_name(const std::string& name, const Kinds& kinds,
                                                       const std::string& option) {
  if (name.empty()) return std::nullopt;
  std::vector<std::string> known;
  for (const auto kind : kinds) {
    if (name == name_of(kind)) return kind;
    known.emplace_back(name_of(kind));
  }
  throw Error(fmt::format("{} '{}'{}", option, name, suggestion(name, known)));
}

ViewTarget page_target_of(const ViewArguments& arguments) {
  if (arguments.html.empty() && arguments.png.empty() && arguments.glb.empty())
    throw Error(
        "no page was named: say where it shall be written with -o FILE.html, or a picture with --png FILE.png, or a "
        "GLB "
        "file with --glb FILE.glb");
  ViewTarget target = target_of(arguments);
  ViewOptions& options = target.options;
  options.hierarchy = kind_of_name(arguments.hierarchy, all_cost_volumes, "--hierarchy: there is no volume");
  options.partition =
      kind_of_name(arguments.partition, all_partition_kinds, "--partition: there is no partition of space");
  options.voronoi = arguments.voronoi;
  options.voronoi_walk = arguments.voronoi_walk;
  return target;
}

/// What is to be drawn, and the answer that was recorded to it, if any.
struct Drawn {
  CheckInput input;
  SceneQuestion question;
  std::string recorded{};
  std::vector<std::string> files;  ///< that it is about
};

/// The options ask about the objects themselves.
bool asks_itself(const ViewArguments& arguments) {
  return arguments.penetration || !arguments.clearance.empty() || !arguments.clearances_of.empty() ||
         changes_objects(arguments);
}

Drawn drawn_report(const ViewArguments& arguments) {
  const std::string& file = arguments.input.files[0];
  if (asks_itself(arguments))
    throw Error(
        fmt::format("{}: a report is drawn as it was asked; leave out the options about shapes, poses, depths "
                    "and clearances",
                    file));
  const SavedReport saved = read_report(file);
  Drawn drawn{read_again(saved, file, arguments.threads), saved.asked.question, saved.answer, {}};
  for (const AskedFile& asked : saved.asked.files) drawn.files.push_back(asked.name);
  return drawn;
}

/// Whether it matters what contains what.
bool is_about_contact(const SceneQuestion& question) {
  return std::holds_alternative<CheckQuestion>(question) || std::holds_alternative<CheckPosesQuestion>(question);
}

/// As the options say: pairs that touch or are as near.
Drawn drawn_as_asked_here(const ViewArguments& arguments) {
  CheckInput input = read_check_input(arguments);
  const CheckQuestion question = check_question(arguments, true, read_clearances(arguments, input.loaded.scene));
  return {std::move(input), question, "", arguments.input.files};
}

/// As it asks, unless the options ask something else.
Drawn drawn_case(const ViewArguments& arguments) {
  const std::string& file = arguments.input.files[0];
  const Case content = read_case(file);
  if (content.question && !asks_itself(arguments))
    return {read_check_input(arguments), *content.question, content.answer, arguments.input.files};
  Drawn drawn = drawn_as_asked_here(arguments);
  if (content.question)
    drawn.input.loaded.warnings.push_back(fmt::format(
        "{} holds a question, {}, which is not asked: options ask another", file, name_of(*content.question)));
  return drawn;
}

/// A report, or a case, as it asks; everything else as pairs that touch or are as near as the options say.
Drawn drawn_of(const ViewArguments& arguments) {
  const std::vector<std::string>& files = arguments.input.files;
  const bool is_one_json = files.size() == 1 && is_json(files[0]);
  if (is_one_json && is_report(files[0])) return drawn_report(arguments);
  return is_one_json ? drawn_case(arguments) : drawn_as_asked_here(arguments);
}

/// Throws Error for what the options add to a page and what this one cannot have: of crowds, and without meshes.
void require_drawable(const ViewOptions& options, const Drawn& drawn) {
  const bool is_mesh_wanted = options.hierarchy || options.partition;
  if (!is_mesh_wanted && !options.voronoi && !options.voronoi_walk) return;
  const std::string named = options.hierarchy   ? "--hierarchy"
                            : options.partition ? "--partition"
                            : options.voronoi   ? "--voronoi"
                                                : "--voronoi-walk";
  if (is_of_crowd(drawn.question))
    throw Error(named + " is about the objects of a scene, and a crowd has none: leave it out");
  const auto has_mesh = [](const SceneInstance& posed) { return posed.model.has_mesh(); };
  if (is_mesh_wanted && std::none_of(drawn.input.models.begin(), drawn.input.models.end(), has_mesh))
    throw Error(named + " is about meshes, and here is none: leave it out");
}

/// Where the answer is another than the recorded one; empty where none is recorded.
std::string difference_of(const Drawn& drawn, const SceneAnswer& answer) {
  if (drawn.recorded.empty()) return {};
  return answer_difference(drawn.recorded, json_as_asked(drawn.input, drawn.question, answer));
}

/// The faces that meet are drawn at each pose, and where they are many at the first poses alone: that keeps the page
/// small.
constexpr std::size_t most_face_pairs = 100'000;

/// What is shown, in words: of one object alone nothing was asked that it could have with others.
std::string told_of(const Drawn& drawn, const SceneAnswer& answer) {
  const std::size_t objects = drawn.input.models.size();
  std::string found = std::visit([](const auto& report) { return summary_of(report).findings; }, answer);
  if (objects == 0) return found;
  const std::string shown = counted(objects, "object");
  return objects == 1 && std::holds_alternative<CheckReport>(answer) ? shown : shown + " and " + found;
}

double megabytes_of(const std::string& file) { return static_cast<double>(fs::file_size(file)) / 1e6; }

int run_view(const ViewArguments& arguments) {
  ViewTarget target = page_target_of(arguments);
  require_view(target, arguments);
  Drawn drawn = drawn_of(arguments);
  if (arguments.up.empty()) target.options.up = up_of(drawn.files);
  if (is_about_contact(drawn.question)) warn_of_open_meshes(drawn.input, arguments.threads);
  require_drawable(target.options, drawn);
  const SceneAnswer answer = ask_for(drawn.input, drawn.question, arguments, {"asking", true});
  const std::string difference = difference_of(drawn, answer);
  if (!difference.empty())
    drawn.input.loaded.warnings.push_back(
        "the answer of now is drawn, and it is another than the recorded one, first at " + difference);
  print_warnings(drawn.input.loaded.warnings);
  write_view(target, drawn.input, answer);
  print_answer(written_lines(target, told_of(drawn, answer)));
  return difference.empty() ? 0 : 1;
}

}  // namespace

bool is_json(const std::string& file) { return extension_of(file) == ".json"; }

UpAxis up_of(const PosedArguments& arguments) {
  if (!arguments.up.empty()) return arguments.up == "y" ? UpAxis::y : UpAxis::z;
  return up_of(arguments.input.files);
}

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

ViewTarget target_of(const PosedArguments& arguments) {
  if (arguments.png.empty() && !(arguments.size.empty() && arguments.look.empty()))
    throw Error("--size and --look are of a picture: say where it shall be written with --png FILE.png");
  const std::vector<std::string>& files = arguments.input.files;
  ViewTarget target{arguments.html, arguments.glb, {title_of(files), up_of(arguments), {}, {}}, {}};
  if (arguments.png.empty()) return target;
  require_known_keys(arguments.look);
  target.picture = PictureTarget{arguments.png, arguments.look};
  if (!arguments.size.empty()) set_size(*target.picture, arguments.size);
  return target;
}

bool draws_something(const ViewTarget& target) {
  return !target.path.empty() || !target.glb.empty() || target.picture.has_value();
}

void require_view(const PosedArguments& arguments) { require_view(target_of(arguments), arguments); }

void require_view(const ViewTarget& target, const PosedArguments& arguments) {
  require_distinct({{"-o or --html", target.path},
                    {arguments.glb_option, target.glb},
                    {"--png", target.picture ? target.picture->path : ""},
                    {"--save-case", arguments.save_case}},
                   arguments.input.files);
  if (!target.path.empty()) require_output(target.path, OutputKind::page);
  if (!target.glb.empty()) require_output(target.glb, OutputKind::glb);
  if (target.picture) require_picture(*target.picture);
}

void write_files(const ViewTarget& target, const std::string& page, const std::string& glb) {
  if (target.picture) write_picture(page, *target.picture);
  const UninterruptedWriting writing;
  if (!target.path.empty()) write_view_page(page, target.path);
  if (!target.glb.empty()) write_glb(glb, target.glb);
}

std::string written_lines(const ViewTarget& target, const std::string& holds) {
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

void write_view(const ViewTarget& target, const CheckInput& input, const SceneAnswer& found) {
  const LoadedScene& loaded = input.loaded;
  const auto* poses = std::get_if<PosesReport>(&found);
  const SceneAnswer with_faces =
      poses == nullptr ? SceneAnswer() : with_face_pairs(*poses, input.models, most_face_pairs);
  const SceneAnswer& answer = poses == nullptr ? found : with_faces;
  const std::string page = target.path.empty() && !target.picture
                               ? ""
                               : view_page(loaded.scene, input.models, answer, target.options, loaded.warnings);
  const std::string glb = target.glb.empty() ? "" : scene_glb(loaded.scene, input.models, answer, target.options);
  write_files(target, page, glb);
}

Subcommand add_view(CLI::App& app) {
  const auto arguments = std::make_shared<ViewArguments>();
  CLI::App* view = app.add_subcommand("view", "write a page that shows the objects, what was found, and why");
  add_input(*view, arguments->input, any_files);
  add_file(*view, "-o,--output", arguments->html, "the page to write", "FILE.html");
  add_glb(*view, *arguments);
  add_pose_pair(*view, *arguments);
  add_solid(*view, *arguments);
  view->add_flag("--penetration", arguments->penetration,
                 "also how deep solids overlap, and their points and regions of contact");
  add_clearances(*view, *arguments);
  add_text(*view, "--hierarchy", arguments->hierarchy,
           "also the levels of a hierarchy over each mesh, of these volumes: aabb, ball, cube, obb, 6-dop, …, "
           "rss, ellipsoid, hull; wide: the tree that queries use",
           "a volume must be named")
      ->type_name("VOLUME");
  add_text(*view, "--partition", arguments->partition,
           "also the cells of a partition over each mesh, depth by depth: grid, grid-2d, octree, kd-tree, r-tree, "
           "inserted-r-tree",
           "a partition must be named")
      ->type_name("PARTITION");
  view->add_flag("--voronoi", arguments->voronoi,
                 "also the Voronoi regions of objects that are convex polytopes: of faces, edges and vertices");
  view->add_flag("--voronoi-walk", arguments->voronoi_walk,
                 "also how each pair of convex polytopes is found to be nearest by walking from region to region, "
                 "feature by feature");
  add_picture(*view, *arguments);
  add_up(*view, *arguments);
  add_threads(*view, arguments->threads, "page");
  add_save_case(*view, arguments->save_case, "also write what is shown as a case (docs/reference/case-file.md)");
  view->footer(with_name(
      "The page is one file that any browser with WebGL 2 opens from disk: no network, no server.\n\n"
      "Exit code: 0 written, 1 written and the answer is another than a report or case says, 2 trouble.\n\nExample:\n"
      "  {0} view a.stl b.obj -o touch.html\n"
      "  {0} view scene.json --penetration --clearance 2mm -o scene.html\n"
      "  {0} view bunny.ply --hierarchy obb -o tree.html\n"
      "  {0} view bunny.ply --partition octree -o octree.html\n"
      "  {0} view scene.json --glb scene.glb\n"
      "  {0} ray part.stl --from 0 0 5 --to 0 0 -5 --json > report.json\n"
      "  {0} view report.json -o report.html\n"
      "  {0} view a.stl b.obj --png touch.png --look 'finding=0'"));
  return {view, [arguments] {
            take_words(*arguments);
            return run_view(*arguments);
          }};
}

}  // namespace toccata::command
