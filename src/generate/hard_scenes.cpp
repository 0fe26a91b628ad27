#include "generate/mesh_building.hpp"
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

/// per_side² unit boxes beside each other, whose near faces have the x coordinate `near` and the far ones `far`.
TriangleMesh wall_of_boxes(double near, double far, int per_side) {
  constexpr double spacing = 1.5;
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;
  const TriangleMesh unit = box_mesh({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5});
  for (int row = 0; row < per_side; ++row)
    for (int column = 0; column < per_side; ++column) {
      const Index first = static_cast<Index>(vertices.size());
      for (const Vec3& v : unit.vertices())
        vertices.push_back({v.x == 0 ? near : far, spacing * column + v.y, spacing * row + v.z});
      const Index first_face = faces.empty() ? 0 : faces.back() + 1;
      for (Index t = 0; t < unit.triangle_count(); ++t) {
        const auto& [a, b, c] = unit.triangles()[t];
        triangles.push_back({first + a, first + b, first + c});
        faces.push_back(first_face + unit.face_of(t));
      }
    }
  return {std::move(vertices), std::move(triangles), std::move(faces)};
}

/// Where a copy goes that is scaled about a point of its own. The point stays to the bit where the factor is 1.
Pose placed_copy(const MouldShape& shape, const Placement& placement) {
  const Vec3 offset = placed(placement, (1 - shape.factor) * shape.about).offset;
  return {scaled(Pose{}, placement.scale * shape.factor).linear, offset};
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
  return inside_negative_image(noise_sphere_mesh({1, 0.3, 3, seed}), {}, placement);
}

Scene inside_negative_image(const TriangleMesh& mesh, const MouldShape& shape, const Placement& placement) {
  require_range("the factor", shape.factor, 1e-3, 1e3);
  Scene scene;
  add(scene, "mesh", shared(mesh), placed_copy(shape, placement));
  add(scene, "its mould", shared(negative_image(mesh, shape.margin)), placed(placement));
  return scene;
}

Scene nested_shells(double factor, std::uint64_t seed, const Placement& placement) {
  const SharedMesh ball = shared(noise_sphere_mesh({1, 0.3, 3, seed}));
  Scene scene;
  add(scene, "bumpy ball", ball, placed(placement));
  add(scene, factor < 1 ? "smaller copy" : "larger copy", ball, placed_copy({factor}, placement));
  return scene;
}

Scene boxes_face_to_face(double gap, const Placement& placement) { return fields_of_boxes(gap, 1, placement); }

Scene fields_of_boxes(double gap, int per_side, const Placement& placement) {
  require_range("the gap", gap, -1, 1e9);
  require_range("the number of boxes on a side", per_side, 1, 1000);
  Scene scene;
  add(scene, "left boxes", shared(wall_of_boxes(0, 1, per_side)), placed(placement));
  add(scene, "right boxes", shared(wall_of_boxes(1 + gap, 2 + gap, per_side)), placed(placement));
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
