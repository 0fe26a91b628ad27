#include "generate/scene_building.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"

// Scenes in which an answer that is nearly right is wrong.
namespace toccata {
namespace {

/// Where a shape at `position` goes.
Pose placed(const Placement& placement, const Vec3& position = {}) {
  Pose pose = scaled(Pose{}, placement.scale);
  for (int axis = 0; axis < 3; ++axis) pose.offset[axis] = placement.offset + placement.scale * position[axis];
  return pose;
}

/// The box [lower, lower + size]. Boxes that share a face get the same coordinates there whatever the placement, since
/// all have the same pose.
SharedMesh box_from(const Vec3& lower, const Vec3& size) { return shared(box_mesh(0.5 * size, lower + 0.5 * size)); }

/// The cube [−1, 1]³ mirrored and turned right side out again: the same set, cut into other triangles.
SharedMesh cube_cut_otherwise() {
  const TriangleMesh cube = box_mesh({1, 1, 1});
  std::vector<Vec3> vertices;
  for (const Vec3& v : cube.vertices()) vertices.push_back({-v.x, v.y, v.z});
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [a, b, c] : cube.triangles()) triangles.push_back({a, c, b});
  return shared({std::move(vertices), std::move(triangles)});
}

}  // namespace

Scene interleaved_helices(double gap, const Placement& placement) {
  constexpr double thickness = 2;
  HelixShape shape;
  shape.tube_radius = thickness / 2;
  shape.pitch = 2 * (thickness + gap);
  const SharedMesh helix = shared(helix_mesh(shape));
  Scene scene;
  add(scene, "lower helix", helix, placed(placement));
  add(scene, "upper helix", helix, placed(placement, {0, 0, thickness + gap}));
  return scene;
}

Scene inside_negative_image(std::uint64_t seed, const Placement& placement) {
  const TriangleMesh ball = noise_sphere_mesh({1, 0.3, 3, seed});
  Scene scene;
  add(scene, "bumpy ball", shared(ball), placed(placement));
  add(scene, "its mould", shared(negative_image(ball, 0.5)), placed(placement));
  return scene;
}

Scene nested_shells(double factor, std::uint64_t seed, const Placement& placement) {
  const SharedMesh ball = shared(noise_sphere_mesh({1, 0.3, 3, seed}));
  Scene scene;
  add(scene, "bumpy ball", ball, placed(placement));
  add(scene, factor < 1 ? "smaller copy" : "larger copy", ball, placed({placement.scale * factor, placement.offset}));
  return scene;
}

Scene boxes_face_to_face(const Placement& placement) {
  Scene scene;
  add(scene, "left box", box_from({0, 0, 0}, {1, 1, 1}), placed(placement));
  add(scene, "right box", box_from({1, 0, 0}, {1, 1, 1}), placed(placement));
  return scene;
}

Scene boxes_sharing_half(const Placement& placement) {
  Scene scene;
  add(scene, "left box", box_from({0, 0, 0}, {1, 1, 1}), placed(placement));
  add(scene, "right box", box_from({0.5, 0, 0}, {1, 1, 1}), placed(placement));
  return scene;
}

Scene equal_boxes(const Placement& placement) {
  Scene scene;
  add(scene, "box", shared(box_mesh({1, 1, 1})), placed(placement));
  add(scene, "same box, other triangles", cube_cut_otherwise(), placed(placement));
  return scene;
}

}  // namespace toccata
