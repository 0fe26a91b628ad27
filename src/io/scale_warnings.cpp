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

std::vector<double> diagonals_of(const Scene& scene) {
  std::map<const TriangleMesh*, Aabb> boxes;
  std::vector<double> diagonals;
  for (const SceneObject& object : scene.objects) {
    const auto [found, is_new] = boxes.try_emplace(object.mesh.get());
    if (is_new) found->second = fit_aabb(object.mesh->vertices());
    diagonals.push_back(diagonal_of(found->second, object.pose));
  }
  return diagonals;
}

}  // namespace

std::vector<std::string> scale_warnings(const Scene& scene) {
  constexpr double absurd = 500;  // millimetres among metres are a factor of 1000
  const std::vector<double> diagonals = diagonals_of(scene);
  std::vector<double> sorted = diagonals;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < diagonals.size(); ++i) {
    const double typical = sorted[(sorted.size() - 1) / 2];
    const double ratio = diagonals[i] / typical;
    if (!(diagonals[i] > 0) || !(typical > 0) || (ratio < absurd && ratio > 1 / absurd)) continue;
    warnings.push_back(fmt::format(
        "'{}' is {:.3g} times as large as the other objects ({:.3g} against {:.3g} {} across): is a unit missing?",
        scene.objects[i].name, ratio, diagonals[i], typical, scene.unit));
  }
  return warnings;
}

}  // namespace toccata
