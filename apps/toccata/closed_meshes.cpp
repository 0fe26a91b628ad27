#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <variant>

#include "clearance.hpp"
#include "load.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/close_mesh.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// What was done, in the order of counting.
std::string repair_text(const MeshRepair& repair) {
  return fmt::format("{} of its boundary moved, {} collapsed, {} filled by {}",
                     counted(repair.moved_vertices, "vertex", "vertices"),
                     counted(repair.collapsed_triangles, "triangle"), counted(repair.filled_holes, "hole"),
                     counted(repair.added_triangles, "triangle"));
}

std::string told(const std::string& name, const RepairedMesh& made) {
  if (made.closed)
    return fmt::format("{} was closed by --close: {}; its file stays as it is", name, repair_text(made.repair));
  if (const std::string winding = only_winding_text(inspect(made.mesh)); !winding.empty())
    return fmt::format("{} is still open after --close, which turns no triangle: {}", name, winding);
  return fmt::format("{} is still open after --close, with {}: {}", name,
                     counted(made.repair.open_holes, "hole or rim", "holes or rims"), repair_text(made.repair));
}

}  // namespace

double stretch_of(const Pose& pose) {
  const std::array<double, 12> n = pose.numbers();
  double longest = 0;
  for (std::size_t column = 0; column < 3; ++column)
    longest = std::max(longest, std::hypot(n[column], n[column + 3], n[column + 6]));
  return longest;
}

void close_meshes(LoadedScene& loaded, const InputArguments& input) {
  if (input.close.empty()) return;
  const double gap = read_length("--close", input.close, length_units(loaded.scene, input), Longest::finite);
  if (!(gap > 0)) throw Error(fmt::format("--close {}: a gap is a length above 0", input.close));
  std::map<std::pair<SharedMesh, double>, RepairedMesh> known;
  std::map<std::pair<SharedMesh, double>, SharedMesh> closed;
  std::vector<std::string> repairs;
  for (SceneObject& object : loaded.scene.objects) {
    auto* mesh = std::get_if<SharedMesh>(&object.shape);
    const double stretch = stretch_of(object.pose);
    if (mesh == nullptr || object.solid == Solid::none || !(stretch > 0) || is_closed(**mesh)) continue;
    const auto [found, is_new] = known.try_emplace({*mesh, stretch}, RepairedMesh{**mesh, {}, false});
    if (is_new) {
      found->second = close_mesh(**mesh, gap / stretch);
      closed[found->first] = std::make_shared<const TriangleMesh>(found->second.mesh);
    }
    repairs.push_back(told(object.name, found->second));
    *mesh = closed.at(found->first);
  }
  loaded.warnings.push_back(fmt::format(
      "--close: gaps of at most {} are closed, {}", length_text(gap, loaded.scene.unit),
      repairs.empty() ? "and no mesh is open" : "in " + counted(repairs.size(), "open mesh", "open meshes")));
  loaded.warnings.insert(loaded.warnings.end(), repairs.begin(), repairs.end());
}

}  // namespace toccata::command
