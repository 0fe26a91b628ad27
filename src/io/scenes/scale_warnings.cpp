#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "toccata/bounds/aabb.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata {
namespace {

/// The diagonal of the box around the posed corners of the mesh's own box: at most twice too long, and cheap.
double diagonal_of(const Aabb& box, const Pose& pose) {
  Aabb world;
  for (int corner = 0; corner < 8; ++corner)
    world =
        merge(world, transform(pose, {(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                                      (corner & 4 ? box.upper : box.lower).z}));
  const Vec3 size = world.upper - world.lower;
  return std::hypot(size.x, size.y, size.z);
}

struct Diagonal {
  const std::string* name;
  double length;
};

/// Of all meshes.
std::vector<Diagonal> diagonals_of(const Scene& scene) {
  std::map<const TriangleMesh*, Aabb> boxes;
  std::vector<Diagonal> diagonals;
  for (const SceneObject& object : scene.objects) {
    const auto mesh = object.mesh();
    if (!mesh) continue;
    const auto [found, is_new] = boxes.try_emplace(mesh.get());
    if (is_new) found->second = fit_aabb(mesh->vertices());
    diagonals.push_back({&object.name, diagonal_of(found->second, object.pose)});
  }
  return diagonals;
}

}  // namespace

std::vector<std::string> scale_warnings(const Scene& scene) {
  constexpr double absurd = 500;  // millimetres among metres are a factor of 1000
  const std::vector<Diagonal> diagonals = diagonals_of(scene);
  std::vector<double> sorted;
  for (const Diagonal& diagonal : diagonals) sorted.push_back(diagonal.length);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::string> warnings;
  for (const auto& [name, length] : diagonals) {
    const double typical = sorted[(sorted.size() - 1) / 2];
    const double ratio = length / typical;
    if (!(length > 0) || !(typical > 0) || (ratio < absurd && ratio > 1 / absurd)) continue;
    warnings.push_back(fmt::format(
        "'{}' is {:.3g} times as large as the other objects ({:.3g} against {:.3g} {} across): is a unit missing?",
        *name, ratio, length, typical, scene.unit));
  }
  return warnings;
}

}  // namespace toccata
