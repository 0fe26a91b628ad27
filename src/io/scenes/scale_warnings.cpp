#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "io/scenes/scene_parts.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata {
namespace {

/// The box around the posed corners of the mesh's own box: cheap, and its diagonal at most twice too long.
Aabb box_around_posed(const Aabb& box, const Pose& pose) {
  Aabb world;
  for (int corner = 0; corner < 8; ++corner)
    world =
        merge(world, transform(pose, {(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                                      (corner & 4 ? box.upper : box.lower).z}));
  return world;
}

double length_across(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return std::hypot(size.x, size.y, size.z);
}

struct NamedMeshBox {
  const std::string* name;
  Aabb box;
};

/// The boxes of all meshes, in the world.
std::vector<NamedMeshBox> mesh_boxes_of(const Scene& scene) {
  std::map<const TriangleMesh*, Aabb> boxes;
  std::vector<NamedMeshBox> named;
  for (const SceneObject& object : scene.objects) {
    const auto mesh = object.mesh();
    if (!mesh) continue;
    const auto [found, is_new] = boxes.try_emplace(mesh.get());
    if (is_new) found->second = fit_aabb(mesh->vertices());
    named.push_back({&object.name, box_around_posed(found->second, object.pose)});
  }
  return named;
}

/// Whether the whole is larger or smaller than what is mostly asked about; empty where it is not. A factor of 1000 more
/// or less makes a car of a machine part, and a town of a car.
std::string size_warning(const std::vector<NamedMeshBox>& boxes, const std::string& unit) {
  const std::optional<double> metres = io::unit_in_metres(unit);
  if (!metres || boxes.empty()) return {};
  Aabb whole;
  for (const NamedMeshBox& one : boxes) whole = merge(whole, one.box);
  const double size = length_across(whole) * *metres;
  if (!(size > 1000) && !(size < 0.0001 && size > 0)) return {};
  const std::string told = size > 1 ? fmt::format("{:.3g} km", size / 1000) : fmt::format("{:.3g} mm", size * 1000);
  return fmt::format(
      "the meshes are {} across, all together: are their numbers in another unit? Say which with --unit, or in a scene "
      "file",
      told);
}

}  // namespace

std::optional<double> io::unit_in_metres(std::string_view unit) {
  if (unit == "unit") return std::nullopt;
  if (unit.ends_with(" m")) unit.remove_suffix(2);  // metres per unit, as a number
  try {
    return metres_per_unit(unit);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<std::string> scale_warnings(const Scene& scene) {
  constexpr double absurd = 500;  // millimetres among metres are a factor of 1000
  const std::vector<NamedMeshBox> boxes = mesh_boxes_of(scene);
  std::vector<double> sorted;
  for (const NamedMeshBox& one : boxes) sorted.push_back(length_across(one.box));
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::string> warnings;
  if (std::string warning = size_warning(boxes, scene.unit); !warning.empty()) warnings.push_back(std::move(warning));
  for (const auto& [name, box] : boxes) {
    const double typical = sorted[(sorted.size() - 1) / 2], length = length_across(box);
    const double ratio = length / typical;
    if (!(length > 0) || !(typical > 0) || (ratio < absurd && ratio > 1 / absurd)) continue;
    warnings.push_back(fmt::format(
        "'{}' is {:.3g} times as large as the other objects ({:.3g} against {:.3g} {} across): is a unit missing?",
        *name, ratio, length, typical, scene.unit));
  }
  return warnings;
}

}  // namespace toccata
