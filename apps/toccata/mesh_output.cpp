#include "mesh_output.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/pages.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

void require_mesh_format(const std::string& file) {
  constexpr std::array formats{".obj", ".off", ".ply", ".stl"};
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (std::find(formats.begin(), formats.end(), extension) == formats.end())
    throw Error(printable(file) +
                ": the extension names no format that is written (use .obj, .off, .ply, .stl or .glb)");
}

/// What was made, alone.
std::string glb_of(SceneObject object, const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  scene.objects.push_back(std::move(object));
  return scene_glb(scene, scene_models(scene, 1), CheckReport{});
}

}  // namespace

bool is_glb(const std::string& file) { return file.ends_with(".glb"); }

void require_mesh_output(const PosedArguments& arguments, const std::string& file) {
  require_view(arguments);
  require_distinct({{"-o", file},
                    {"--html", arguments.html},
                    {"--png", arguments.png},
                    {"--glb", arguments.glb},
                    {"--save-case", arguments.save_case}},
                   arguments.input.files);
  if (file.empty()) return;
  if (is_glb(file)) return require_output(file, OutputKind::glb);
  require_mesh_format(file);
  // Mesh files have no mark by which one of Toccata's could be told from somebody's work.
  std::error_code none;
  if (std::filesystem::file_size(file, none) > 0 && !none)
    throw Error(printable(file) + ": the file exists: choose another name, or delete it");
}

void write_mesh_output(const MadeMesh& made, const std::string& unit, const std::string& file) {
  const std::string glb = is_glb(file) ? glb_of(made.object(), unit) : "";
  const UninterruptedWriting writing;
  if (is_glb(file))
    write_glb(glb, file);
  else
    write_mesh(made.mesh(), file);
}

}  // namespace toccata::command
