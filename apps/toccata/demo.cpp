#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <memory>

#include "arguments.hpp"
#include "check_table.hpp"
#include "demo_cloth.hpp"
#include "demo_mould.hpp"
#include "demo_readme.hpp"
#include "demo_text.hpp"
#include "file_text.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/reports/scene_question.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct DemoArguments {
  std::string scene;         ///< empty: all that do not move
  std::string write_folder;  ///< empty: run the demo
  int steps = 1000;          ///< of what moves
  std::string mesh;          ///< that stands in a wall
  double factor = 1;         ///< by which it is scaled there
  Format format = Format::table;
  int threads = 0;
};

std::string demo_json(const DemoArguments& arguments) {
  std::vector<NamedReport> reports;
  for (const NamedScene& named : demo_scenes()) {
    const Scene scene = demo_scene(named.name);
    const std::vector<SceneInstance> models = scene_models(scene, arguments.threads);
    reports.push_back({named.name, report_json(scene, models, demo_report(models, arguments.threads))});
  }
  return joined_reports_json(reports);
}

int show_scenes(const DemoArguments& arguments) {
  print_answer(arguments.format == Format::json ? demo_json(arguments) : demo_text(arguments.threads));
  return 0;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw Error(fmt::format("{}: could not be written; is the disk full?", file.string()));
}

void write_scene_files(const std::filesystem::path& folder) {
  write_mesh(generate_mesh("torus-knot"), folder / "a.obj");
  write_mesh(generate_mesh("noise-sphere"), folder / "b.stl");
  for (const NamedScene& named : demo_scenes()) write_scene(demo_scene(named.name), folder / named.name);
  write_text(folder / "README.md", demo_readme());
}

/// A folder that a demo of this version wrote before, as far as its README tells.
bool is_demo_folder(const std::filesystem::path& folder) { return text_of_file(folder / "README.md") == demo_readme(); }

void require_free(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const bool occupied = fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder));
  if (occupied)
    throw Error(
        fmt::format("{}: exists and is not an empty folder; name another, or remove it first", folder.string()));
}

/// Everything goes into a folder beside the final one, which is renamed at the end, so that the folder is complete or
/// not there.
void write_folder(const std::filesystem::path& folder, FunctionRef<void(const std::filesystem::path&)> write_files) {
  namespace fs = std::filesystem;
  require_free(folder);
  const UninterruptedWriting writing;
  const fs::path normal = fs::absolute(folder / "").parent_path();
  const fs::path partial = normal.parent_path() / (normal.filename().string() + ".partial");
  if (fs::exists(partial))
    throw Error(fmt::format("{}: exists, perhaps from a demo that was killed; remove it first", partial.string()));
  std::error_code failed;
  try {
    fs::create_directories(partial);
    write_files(partial);
    fs::remove(normal, failed);  // an empty folder
    fs::rename(partial, normal);
  } catch (const fs::filesystem_error& error) {
    fs::remove_all(partial, failed);
    throw Error(fmt::format("{}: could not be written: {}; name a folder where you may write", folder.string(),
                            error.code().message()));
  } catch (...) {
    fs::remove_all(partial, failed);
    throw;
  }
}

int write_scenes(const std::filesystem::path& folder) {
  if (is_demo_folder(folder)) {
    print_answer(fmt::format("{} is there from an earlier demo, and left as it is.\n", folder.string()));
    return 0;
  }
  write_folder(folder, &write_scene_files);
  print_answer(
      fmt::format("Written to {0}: {1}, two meshes, and a README.md with commands to try, for example\n"
                  "  {2} check {0}/a.obj {0}/b.stl\n",
                  folder.string(), counted(demo_scenes().size(), "scene"), called_as()));
  return 0;
}

int show_cloth(const DemoArguments& arguments) {
  if (!arguments.write_folder.empty()) require_free(arguments.write_folder);
  ClothAnswer answer = fallen_cloth({.steps = arguments.steps, .threads = arguments.threads});
  if (!arguments.write_folder.empty()) {
    write_folder(arguments.write_folder, [&](const std::filesystem::path& folder) {
      write_mesh(answer.cloth, folder / "cloth.obj");
      write_mesh(answer.obstacles, folder / "obstacles.obj");
    });
    answer.text += fmt::format(
        "Written to {0}: the cloth after the last step, to be looked at with\n"
        "  {1} view {0}/cloth.obj {0}/obstacles.obj\n",
        arguments.write_folder, called_as());
  }
  print_answer(arguments.format == Format::json ? answer.json : answer.text);
  return answer.is_clean ? 0 : 1;
}

int show_mould(const DemoArguments& arguments) {
  if (!arguments.write_folder.empty()) require_free(arguments.write_folder);
  const Scene scene = mould_scene(arguments.mesh, arguments.factor);
  const std::vector<SceneInstance> models = scene_models(scene, arguments.threads);
  const CheckReport report = demo_report(models, arguments.threads);
  std::string text = check_table(scene, report);
  if (!arguments.write_folder.empty()) {
    write_folder(arguments.write_folder, [&](const std::filesystem::path& folder) { write_scene(scene, folder); });
    text += fmt::format("Written to {0}, to be looked at with\n  {1} view {0}/scene.json\n", arguments.write_folder,
                        called_as());
  }
  print_answer(arguments.format == Format::json ? report_json(scene, models, report) : text);
  return 0;
}

/// An option of one scene is no option of another.
void require_scene(const CLI::Option& option, const DemoArguments& arguments, const std::string& scene) {
  if (option.count() > 0 && arguments.scene != scene)
    throw Error(fmt::format("{} is an option of demo {}", option.get_name(), scene));
}

int run_demo(const DemoArguments& arguments) {
  if (arguments.scene == "cloth") return show_cloth(arguments);
  if (arguments.scene == "mould") return show_mould(arguments);
  return arguments.write_folder.empty() ? show_scenes(arguments) : write_scenes(arguments.write_folder);
}

}  // namespace

Subcommand add_demo(CLI::App& app) {
  const auto arguments = std::make_shared<DemoArguments>();
  CLI::App* demo = app.add_subcommand("demo", "the main job on generated scenes, no file needed");
  demo->add_option("scene", arguments->scene,
                   "cloth: a cloth that falls, step by step; mould: a mesh in the hole that it leaves in a wall; "
                   "else all scenes at rest")
      ->check(CLI::IsMember({"cloth", "mould"}));
  const CLI::Option* steps = demo->add_option("--steps", arguments->steps, "of the cloth")
                                 ->check(whole_number(1, 1'000'000))
                                 ->capture_default_str();
  arguments->mesh = "gen:noise-sphere";
  const CLI::Option* mesh =
      demo->add_option("--mesh", arguments->mesh, "of the mould: a file, or a generated mesh")->capture_default_str();
  const CLI::Option* factor = demo->add_option("--factor", arguments->factor,
                                               "scales the mesh in its mould about the middle of its box: try 0.999")
                                  ->check(number_between(1e-3, 1e3))
                                  ->capture_default_str();
  add_text(*demo, "--write", arguments->write_folder,
           "write the scenes as files to play with, the cloth as it lies at last, or the mould, into this folder",
           "a folder must be named");
  add_threads(*demo, arguments->threads, "answer");
  add_json(*demo, arguments->format, "write the answers as JSON");
  demo->footer(
      with_name("Example:\n  {0} demo\n  {0} demo --write scenes\n  {0} demo cloth\n"
                "  {0} demo mould --mesh part.stl --factor 0.999"));
  return {demo, [arguments, steps, mesh, factor] {
            require_scene(*steps, *arguments, "cloth");
            require_scene(*mesh, *arguments, "mould");
            require_scene(*factor, *arguments, "mould");
            return run_demo(*arguments);
          }};
}

}  // namespace toccata::command
