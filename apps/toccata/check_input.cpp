#include "check_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/shapes/close_mesh.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// --pose-a and --pose-b place everything in the first and the second of two files.
void apply_poses(LoadedScene& loaded, const PosedArguments& arguments) {
  if (!arguments.pose_a && !arguments.pose_b) return;
  if (arguments.input.files.size() != 2)
    throw Error(
        fmt::format("--pose-a and --pose-b place the first and the second of two files; here are {}. For more, "
                    "write a scene file (docs/reference/scene-file.md)",
                    arguments.input.files.size()));
  const std::optional<Pose> poses[] = {arguments.pose_a, arguments.pose_b};
  for (std::size_t file = 0; file < 2; ++file) {
    if (!poses[file]) continue;
    for (std::size_t i = loaded.first_object[file]; i < loaded.first_object[file + 1]; ++i)
      loaded.scene.objects[i].pose = *poses[file] * loaded.scene.objects[i].pose;
  }
}

void apply_solid(Scene& scene, std::optional<Solid> solid) {
  if (!solid) return;
  for (SceneObject& object : scene.objects) object.solid = *solid;
}

/// With the trees of the folder --cache, where it is given; those that it lacks are written there.
std::vector<SceneInstance> models_of(LoadedScene& loaded, const PosedArguments& arguments) {
  ProgressBar bar("building trees");
  if (arguments.input.cache.empty()) return scene_models(loaded.scene, arguments.threads);
  TreeCache cache(arguments.input.cache);
  std::vector<SceneInstance> models = cache.models(loaded.scene, arguments.threads);
  {
    const UninterruptedWriting writing;
    cache.save();
  }
  loaded.warnings.insert(loaded.warnings.end(), cache.warnings().begin(), cache.warnings().end());
  return models;
}

/// Not a height field, which everybody knows to be open.
bool is_mesh_taken_as_it_is(const SceneInstance& posed) {
  return posed.solid == Solid::automatic && kind_of(posed.model.shape()) == ShapeKind::mesh;
}

/// By which gap the mesh would be closed, where one that is not large does; empty where none does, or it would take
/// long to find out.
std::string how_to_close(const SceneInstance& posed) {
  constexpr Index most_triangles = 200'000;
  const TriangleMesh& mesh = posed.model.mesh();
  if (mesh.triangle_count() > most_triangles) return {};
  if (const std::string winding = only_winding_text(inspect(mesh)); !winding.empty())
    return fmt::format("of {} {}; ", posed.name, winding);
  const std::optional<double> gap = closing_gap(mesh);
  if (!gap) return {};
  return fmt::format("{} has {} and is closed by --close {:.2g}; ", posed.name,
                     counted(inspect(mesh).boundary_edges, "boundary edge"), *gap);
}

}  // namespace

CheckInput read_check_input(const PosedArguments& arguments) {
  InputArguments files = arguments.input;
  files.threads = arguments.threads;
  CheckInput input{load(files), {}};
  apply_poses(input.loaded, arguments);
  apply_solid(input.loaded.scene, arguments.solid);
  close_meshes(input.loaded, arguments.input);
  input.models = models_of(input.loaded, arguments);
  return input;
}

std::vector<PairQuery> read_queries(const CheckInput& input, const PosedArguments& arguments) {
  const std::vector<SceneInstance>& models = input.models;
  if (models.size() != 2)
    throw Error(fmt::format("--poses asks about two objects, the first placed as A and the second as B; here {} {}",
                            models.size() == 1 ? "is" : "are", models.size()));
  std::vector<PairQuery> queries = read_poses(arguments.poses);
  for (PairQuery& query : queries)
    query = {query.pose_a * models[0].pose, query.pose_b * models[1].pose, models[0].solid, models[1].solid};
  return queries;
}

bool is_open_mesh(const SceneInstance& posed) { return is_mesh_taken_as_it_is(posed) && !posed.model.closed(); }

void warn_of_open_meshes(CheckInput& input, int threads, OpenMeshes taken_for) {
  // What takes time is found out for all at once.
  parallel_for(input.models.size(), threads, [&](std::size_t i) {
    if (is_mesh_taken_as_it_is(input.models[i])) static_cast<void>(input.models[i].model.closed());
  });
  std::vector<std::string> open;
  const SceneInstance* first_open = nullptr;
  for (const SceneInstance& posed : input.models)
    if (is_open_mesh(posed)) {
      open.push_back(posed.name);
      if (first_open == nullptr) first_open = &posed;
    }
  if (first_open != nullptr) warn_of_open_meshes(input.loaded, open, *first_open, taken_for);
}

void warn_of_open_meshes(LoadedScene& loaded, std::span<const std::string> open, const SceneInstance& first,
                         OpenMeshes taken_for) {
  constexpr std::size_t most_names = 5;
  const std::size_t shown = std::min(open.size(), most_names);
  const bool is_one = open.size() == 1;
  const std::string taken =
      taken_for == OpenMeshes::by_winding
          ? "and what lies inside is told by the winding number, undecided"
          : fmt::format("and taken as surface{}, which contain{} nothing", is_one ? "" : "s", is_one ? "s" : "");
  loaded.warnings.push_back(fmt::format(
      "{} of {} {} open {}: {}{} ({}inspect tells why{})", open.size(), counted(loaded.scene.objects.size(), "object"),
      is_one ? "is" : "are", taken, fmt::join(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
      shown < open.size() ? ", …" : "", how_to_close(first),
      taken_for == OpenMeshes::by_winding ? "" : "; --solid=none says that surfaces are meant"));
}

void warn_at_once(LoadedScene& loaded, const std::vector<std::string>& warnings) {
  print_warnings(warnings);
  loaded.warnings.insert(loaded.warnings.begin(), warnings.begin(), warnings.end());
  loaded.told_warnings += warnings.size();
}

std::vector<std::string> untold_warnings(const LoadedScene& loaded) {
  return {loaded.warnings.begin() + static_cast<std::ptrdiff_t>(loaded.told_warnings), loaded.warnings.end()};
}

}  // namespace toccata::command
