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
#include "toccata/reports/report.hpp"
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

/// What is out of order in a mesh that is not closed.
std::string faults_text(const MeshHealth& health) {
  std::vector<std::string> faults;
  const auto add = [&](std::size_t count, const char* one, const char* several) {
    if (count > 0) faults.push_back(counted(count, one, several));
  };
  add(health.boundary_edges, "boundary edge", "boundary edges");
  add(health.non_manifold_edges, "non-manifold edge", "non-manifold edges");
  add(health.flipped_edges, "edge of inconsistent winding", "edges of inconsistent winding");
  add(health.duplicate_triangles, "duplicate face", "duplicate faces");
  return fmt::format("{}", fmt::join(faults, ", "));
}

/// A gap in the world as --close takes it.
std::string close_option(double gap, const std::string& unit) {
  if (unit == "unit" || unit.ends_with(" m")) return upper_bound_text(gap, 2);
  const bool is_small = unit == "m" && gap < 1;
  return upper_bound_text(is_small ? 1000 * gap : gap, 2) + (is_small ? "mm" : unit);
}

enum class ClosingGap { looked_for, left_out };

/// What keeps the mesh from being closed, and which gap closes it, where one that is not large does.
std::string open_mesh_text(const SceneInstance& posed, const std::string& unit, ClosingGap looked_for) {
  const TriangleMesh& mesh = posed.model.mesh();
  const MeshHealth health = inspect(mesh);
  if (const std::string winding = only_winding_text(health); !winding.empty())
    return fmt::format("{}: {}", posed.name, winding);
  const std::optional<double> gap = looked_for == ClosingGap::looked_for ? closing_gap(mesh) : std::nullopt;
  return fmt::format("{} has {}{}", posed.name, faults_text(health),
                     gap ? " and is closed by --close " + close_option(*gap * stretch_of(posed.pose), unit) : "");
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
  std::vector<SceneInstance> told;
  for (const SceneInstance& posed : input.models)
    if (is_open_mesh(posed)) {
      open.push_back(posed.name);
      if (told.size() < most_told_open_meshes) told.push_back(posed);
    }
  if (!open.empty()) warn_of_open_meshes(input.loaded, open, told, taken_for);
}

void warn_of_open_meshes(LoadedScene& loaded, std::span<const std::string> open, std::span<const SceneInstance> told,
                         OpenMeshes taken_for) {
  // For so many it does not take long to find out what closes them, or to count what is wrong with one.
  constexpr std::size_t most_triangles = 200'000, most_inspected = 1'000'000;
  const bool is_one = open.size() == 1;
  const std::string taken =
      taken_for == OpenMeshes::by_winding
          ? "and what lies inside is told by the winding number, undecided"
          : fmt::format("and taken as surface{}, which contain{} nothing", is_one ? "" : "s", is_one ? "s" : "");
  const std::string more =
      told.size() < open.size() ? fmt::format(", and {} more", grouped(open.size() - told.size())) : "";
  loaded.warnings.push_back(fmt::format(
      "{} of {} {} open {}: {}{} (inspect tells more{})", open.size(), counted(loaded.scene.objects.size(), "object"),
      is_one ? "is" : "are", taken, fmt::join(open.first(told.size()), ", "), more,
      taken_for == OpenMeshes::by_winding ? "" : "; --solid=none says that surfaces are meant"));
  std::size_t triangles = 0;
  for (const SceneInstance& posed : told) {
    triangles += posed.model.mesh().triangle_count();
    if (posed.model.mesh().triangle_count() > most_inspected) continue;
    const ClosingGap gap = triangles <= most_triangles ? ClosingGap::looked_for : ClosingGap::left_out;
    loaded.warnings.push_back(open_mesh_text(posed, loaded.scene.unit, gap));
  }
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
