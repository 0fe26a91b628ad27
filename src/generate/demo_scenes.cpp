#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "generate/mesh_building.hpp"
#include "generate/scene_building.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

Pose turned(const Vec3& position, const Vec3& axis, double degrees) {
  return pose_of(position, rotation_about(axis, degrees), {1, 1, 1});
}

/// Adds a node below `parent`, and an object at its place.
Index add_link(Scene& scene, std::optional<Index> parent, const Pose& joint, const std::string& name, SharedMesh mesh) {
  const Index node = static_cast<Index>(scene.nodes.size());
  scene.nodes.push_back({name, parent, joint});
  Pose world = joint;
  for (std::optional<Index> up = parent; up; up = scene.nodes[*up].parent) world = scene.nodes[*up].pose * world;
  SceneObject& object = add(scene, name, std::move(mesh), world);
  object.node = node;
  object.group = "arm";
  return node;
}

/// A beam along z from 0 to its length.
SharedMesh beam(double half_width, double length) {
  return shared(box_mesh({half_width, half_width, 0.5 * length}, {0, 0, 0.5 * length}));
}

/// A rotation that takes the z axis to a direction.
Mat3 along(const Vec3& direction) {
  const Vec3 z = plain_unit_or_zero(direction);
  const Vec3 x = plain_unit_or_zero(std::abs(z.x) < 0.5 ? cross({1, 0, 0}, z) : cross({0, 1, 0}, z));
  const Vec3 y = cross(z, x);
  return {{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}}};
}

/// A ring around the knot at `turns`, moved off its middle line by `shift`.
Pose ring_pose(const TorusKnotShape& knot, double turns, double shift) {
  const Vec3 ahead = torus_knot_point(knot, turns + 0x1p-10), behind = torus_knot_point(knot, turns - 0x1p-10);
  const Mat3 rotation = along(ahead - behind);
  return {rotation, torus_knot_point(knot, turns) + shift * rotation.column(0)};
}

struct DemoScene {
  NamedScene named;
  std::function<Scene()> make;
};

const std::vector<DemoScene>& demos() {
  static const std::vector<DemoScene> all = {
      {{"gears", "three gears: two mesh freely, the third was assembled half a tooth off"},
       [] { return gear_train(); }},
      {{"robot", "a robot arm reaches for its workpiece, and its gripper runs into the table"},
       [] { return robot_arm(); }},
      {{"shelf", "a shelf of 40 parts: one clash, one part inside another, one standing on its board"},
       [] { return shelf_of_parts(); }},
      {{"knot", "a torus knot passes through a ring, and is cut by another"}, [] { return knot_through_ring(); }},
      {{"helices", "two helices wound around each other, a millionth of the tube's radius apart"},
       [] { return interleaved_helices(1e-6); }},
  };
  return all;
}

}  // namespace

Scene gear_train() {
  const GearShape shape;
  const double distance = shape.root_radius + shape.tip_radius + 0.02, half_pitch = 180.0 / shape.teeth;
  const SharedMesh gear = shared(gear_mesh(shape));
  Scene scene;
  add(scene, "driving gear", gear);
  add(scene, "driven gear", gear, turned({distance, 0, 0}, {0, 0, 1}, half_pitch));
  add(scene, "misassembled gear", gear, Pose::translation(0, distance, 0));
  return scene;
}

Scene robot_arm() {
  Scene scene;
  // Halves, quarters and eighths, so that what stands on the table touches it to the bit.
  add(scene, "table", shared(box_mesh({1, 0.75, 0.0625}, {0, 0, -0.0625})));
  add(scene, "workpiece", shared(box_mesh({0.0625, 0.0625, 0.0625}, {0, 0, 0.0625})), Pose::translation(0.75, 0.25, 0));
  const Vec3 y{0, 1, 0};
  const Index base = add_link(scene, std::nullopt, {}, "base", shared(prism_mesh(0.15, 0.2, 24)));
  const Index upper = add_link(scene, base, turned({0, 0, 0.2}, y, 40), "upper arm", beam(0.06, 0.5));
  const Index fore = add_link(scene, upper, turned({0, 0, 0.5}, y, 95), "forearm", beam(0.05, 0.45));
  const Index hand = add_link(scene, fore, turned({0, 0, 0.45}, y, 45), "hand", beam(0.04, 0.15));
  add_link(scene, hand, turned({0, 0, 0.15}, {0, 0, 1}, 45), "gripper", beam(0.02, 0.13));
  return scene;
}

Scene knot_through_ring() {
  const TorusKnotShape knot;
  const SharedMesh ring = shared(torus_mesh({0.22, 0.05, 48, 12}));
  Scene scene;
  add(scene, "torus knot", shared(torus_knot_mesh(knot)));
  add(scene, "free ring", ring, ring_pose(knot, 0.125, 0));
  add(scene, "cutting ring", ring, ring_pose(knot, 0.625, 0.1));
  return scene;
}

const std::vector<NamedScene>& demo_scenes() {
  static const std::vector<NamedScene> named = [] {
    std::vector<NamedScene> list;
    for (const DemoScene& demo : demos()) list.push_back(demo.named);
    return list;
  }();
  return named;
}

Scene demo_scene(std::string_view name) {
  std::vector<std::string> known;
  for (const DemoScene& demo : demos()) {
    if (demo.named.name == name) return demo.make();
    known.push_back(demo.named.name);
  }
  throw Error(fmt::format("there is no demo scene '{}'{}", name, suggestion(name, known)));
}

}  // namespace toccata
