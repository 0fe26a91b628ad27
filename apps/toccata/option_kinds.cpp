#include "option_kinds.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "load.hpp"
#include "named_files.hpp"
#include "number_checks.hpp"
#include "words.hpp"

namespace toccata::command {

void add_input(CLI::App& app, InputArguments& input, const std::string& what) {
  input.wanted = what;
  app.add_option("files", input.files,
                 what + "; a folder stands for the mesh files in it, - for standard input (with --format)");
  app.final_callback([&input] {
    NamedFiles named = named_files(input);
    input.files = std::move(named.files);
    input.warnings = std::move(named.warnings);
  });
  add_file(app, "--names", input.names, "also the files that this one lists, one on each line; -: standard input");
  add_text(app, "--format", input.format, "what standard input is: " + readable_formats(), "a format must be named")
      ->type_name("FORMAT");
  add_length(app, "--tessellation", input.tessellation,
             "how near the triangles of curved faces of STEP and IFC files are to be to them (0.1mm, 1mm)");
  app.add_flag("--split", input.split, "the objects and groups of OBJ files and the solids of STL files, each alone");
  add_text(app, "--unit", input.unit,
           "unit of the numbers in files that state none: mm, cm, m, km, in, ft, or metres per unit; the world, "
           "with it the t of "
           "given poses and all printed points, is then in metres, and a clearance without a unit in this one",
           "a unit must be given")
      ->type_name("TEXT");
  app.add_option("--scale", input.scale, "multiply all coordinates of the files by this")->check(number_above_0());
  add_file(app, "--cache", input.cache,
           "keep the trees of large meshes in this folder, and take from it those that an earlier run built "
           "(docs/reference/tree-file.md)",
           "FOLDER");
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& text, const std::string& help,
                      const std::string& missing) {
  return app.add_option(name, text, help)->check([missing](const std::string& word) {
    return word.empty() ? missing : std::string();
  });
}

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& file, const std::string& help,
                      const std::string& type) {
  return add_text(app, name, file, help, "a file must be named")->type_name(type);
}

CLI::Option* add_length(CLI::App& app, const std::string& name, std::string& length, const std::string& help) {
  return add_text(app, name, length, help, "a length must be given")->type_name("LENGTH");
}

CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                         const std::string& help, int count, const std::string& type) {
  return app.add_option(name, numbers, help)->expected(count)->delimiter(',')->allow_extra_args(false)->type_name(type);
}

CLI::Option* add_point(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                       const std::string& help) {
  return add_numbers(app, name, numbers, help, 3, "X Y Z");
}

std::array<CLI::Option*, 2> add_pose_pair(CLI::App& app, PosedArguments& arguments) {
  const auto pose = [&](const char* name, std::vector<std::string>& numbers, const char* what) {
    return app.add_option(name, numbers, what)->expected(1)->allow_extra_args(false)->type_name("12 NUMBERS");
  };
  return {pose("--pose-a", arguments.pose_a_words,
               "places the first of two files: R row by row, then t; or 16 numbers, a 4 × 4 matrix row by row; 7, a "
               "translation and a quaternion x y z w; 3, a translation; or in words (docs/reference/motion-file.md)"),
          pose("--pose-b", arguments.pose_b_words, "places the second of two files, the same way")};
}

CLI::Option* add_poses(CLI::App& app, PosedArguments& arguments) {
  const auto [pose_a, pose_b] = add_pose_pair(app, arguments);
  return add_file(app, "--poses", arguments.poses,
                  "answers for two objects at many poses: a file with 12 or 24 numbers a line "
                  "(docs/reference/poses-file.md)")
      ->excludes(pose_a)
      ->excludes(pose_b);
}

CLI::Option* add_json(CLI::App& app, Format& format, const std::string& help) {
  return app.add_flag_callback(
      "--json", [&format] { format = Format::json; }, help);
}

void add_formats(CLI::App& app, Format& format, const std::string& report) {
  CLI::Option* json = add_json(app, format, "write JSON (" + report + ")");
  app.add_flag_callback(
         "--csv", [&format] { format = Format::csv; }, "write comma-separated values")
      ->excludes(json);
}

CLI::Option* add_threads(CLI::App& app, int& threads, const std::string& made) {
  return app.add_option("--threads", threads, "threads to use; 0: as many as there are; same " + made + " for any")
      ->check(whole_number(0, 1024));
}

void add_save_case(CLI::App& app, std::string& file, const char* what) {
  constexpr const char* usual =
      "write the shapes, the question and the answer into one file, for a bug report or a test; `replay` asks it again "
      "(docs/reference/case-file.md)";
  add_file(app, "--save-case", file, what == nullptr ? usual : what, "FILE.json");
}

void add_pages(CLI::App& app, PosedArguments& arguments) {
  add_file(app, "--html", arguments.html, "also write a page that shows the objects and what was found", "FILE.html");
  add_picture(app, arguments);
}

void add_writing(CLI::App& app, PosedArguments& arguments, const std::string& report) {
  add_formats(app, arguments.format, report);
  add_threads(app, arguments.threads, "answer");
  add_pages(app, arguments);
  add_glb(app, arguments);
  add_save_case(app, arguments.save_case);
}

CLI::Option* add_solid(CLI::App& app, PosedArguments& arguments) {
  return app
      .add_option("--solid", arguments.solid_word,
                  "auto: watertight meshes are solids; all: an open mesh is an error; none: all are surfaces "
                  "(default: as the scene says, else auto)")
      ->check(CLI::IsMember({"auto", "all", "none"}));
}

CLI::Option* add_close(CLI::App& app, InputArguments& input) {
  return add_length(
      app, "--close", input.close,
      "close gaps of open meshes that are no wider (0.01mm): vertices of their boundaries become one, and "
      "narrow holes are filled; told of each mesh, the files stay as they are");
}

std::array<CLI::Option*, 2> add_clearances(CLI::App& app, CheckArguments& arguments) {
  CLI::Option* clearance =
      add_length(app, "--clearance", arguments.clearance,
                 "also tell pairs that are at most so far apart, and how far: a length in the unit of the files, or of "
                 "--unit, or with its own (0.5, 2mm, 0.1in); all: every pair");
  CLI::Option* clearance_of =
      app.add_option("--clearance-of", arguments.clearances_of, "another clearance for two objects; may be repeated")
          ->type_name("NAME,NAME=LENGTH")
          ->expected(1)
          ->allow_extra_args(false)
          ->take_all();
  return {clearance, clearance_of};
}

CLI::Option* add_up(CLI::App& app, PosedArguments& arguments) {
  return app.add_option("--up", arguments.up, "which axis points up (default: y for glTF, else z)")
      ->check(CLI::IsMember({"y", "z"}));
}

CLI::Option* add_glb(CLI::App& app, PosedArguments& arguments, const char* names) {
  return add_file(app, names, arguments.glb,
                  "write the objects and what was found as a GLB file, for Blender (docs/reference/glb-file.md)",
                  "FILE.glb");
}

void add_picture(CLI::App& app, PosedArguments& arguments) {
  add_file(app, "--png", arguments.png, "draw a picture of the page, where Chromium is installed", "FILE.png");
  add_text(app, "--size", arguments.size, "of the picture (default: 1200x800)", "a size must be given")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--look", arguments.look,
                 "what the picture shows: the end of a link to the page, 'finding=0&theme=dark'")
      ->type_name("TEXT");
}

void take_words(PosedArguments& arguments) {
  static const std::map<std::string, Solid> solids{
      {"auto", Solid::automatic}, {"all", Solid::all}, {"none", Solid::none}};
  if (!arguments.pose_a_words.empty()) arguments.pose_a = parse_pose(arguments.pose_a_words, "--pose-a");
  if (!arguments.pose_b_words.empty()) arguments.pose_b = parse_pose(arguments.pose_b_words, "--pose-b");
  if (!arguments.solid_word.empty()) arguments.solid = solids.at(arguments.solid_word);
}

std::vector<std::string> asking_options(const CLI::App& app) {
  constexpr std::array writing{"--json",  "--csv", "--threads",     "--html",           "--png",   "--size",
                               "--look",  "--glb", "--output",      "--save-case",      "--cache", "--junit",
                               "--sarif", "--bcf", "--bcf-version", "--overlap-bodies", "--names"};
  const auto is_about_writing = [&](const CLI::Option& option) {
    return std::any_of(writing.begin(), writing.end(), [&](const char* name) { return option.check_name(name); });
  };
  std::vector<std::string> given;
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && !option->get_lnames().empty() && !is_about_writing(*option))
      given.push_back(option->get_name());
  return given;
}

std::string with_name(const char* text) { return fmt::format(fmt::runtime(text), called_as()); }

}  // namespace toccata::command
