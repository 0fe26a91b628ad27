#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generate/mesh_building.hpp"
#include "generate/scene_building.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

/// A kind of part: what people call it, and its mesh, about 1 in radius.
struct PartKind {
  const char* name;
  SharedMesh mesh;
};

std::vector<PartKind> kinds_of_parts() {
  return {{"block", shared(box_mesh({0.7, 0.5, 0.6}))},
          {"roller", shared(prism_mesh(0.6, 1.5, 20))},
          {"ball", shared(icosphere_mesh(0.9, 2))},
          {"ring", shared(torus_mesh({0.7, 0.25, 24, 10}))},
          {"gear", shared(gear_mesh({12, 0.75, 1, 0.6, 0.3, 0.4}))},
          {"stone", shared(noise_sphere_mesh({0.8, 0.25, 2, 5}))},
          {"knot", shared(torus_knot_mesh({2, 3, 0.65, 0.25, 0.1, 60, 6}))},
          {"pyramid", shared(tetrahedron_mesh(0.6))}};
}

Mat3 random_rotation(Random& random) {
  for (;;) {
    const Quaternion q{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double squared = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
    if (squared > 0.01 && squared <= 1) return rotation_of(q);
  }
}

double lowest(const TriangleMesh& mesh, const Mat3& linear) {
  double least = INFINITY;
  for (const Vec3& v : mesh.vertices()) least = std::min(least, transform({linear, {}}, v).z);
  return least;
}

// The shelf, in metres. Powers of two where a part stands on a board, so that it touches to the bit.
constexpr int boards = 4, parts_per_board = 10;
constexpr double board_distance = 0.375, board_half_thickness = 0x1p-6, part_distance = 0.1875;

double top_of(int board) { return board * board_distance + board_half_thickness; }
double place_along(int slot) { return (slot - 4.5) * part_distance; }

void add_frame(Scene& scene) {
  const SharedMesh board = shared(box_mesh({1, 0.125, board_half_thickness}));
  const SharedMesh side = shared(box_mesh({board_half_thickness, 0.125, 0.75}));
  for (int i = 0; i < boards; ++i)
    add(scene, fmt::format("board {}", i + 1), board, Pose::translation(0, 0, i * board_distance)).group = "shelf";
  for (const double x : {-1.0, 1.0})
    add(scene, x < 0 ? "left side" : "right side", side, Pose::translation(x, 0, 0.6)).group = "shelf";
}

/// The part that hovers a millimetre over its board.
Pose shelved(const TriangleMesh& mesh, double size, double degrees, const Vec3& place) {
  Pose pose = pose_of(place, rotation_about({0, 0, 1}, degrees), {size, size, size});
  pose.offset.z += 0.001 - lowest(mesh, pose.linear);
  return pose;
}

}  // namespace

Scene shelf_of_parts(std::uint64_t seed) {
  constexpr int crate_slot = 13, standing_slot = 26, clash_slot = 34;
  Random random(seed);
  const std::vector<PartKind> kinds = kinds_of_parts();
  Scene scene;
  add_frame(scene);
  for (int i = 0; i < boards * parts_per_board; ++i) {
    const int board = i / parts_per_board;
    const PartKind& kind = kinds[random.below(kinds.size())];
    const double size = random.between(0.05, 0.075), degrees = random.between(0, 360);
    Vec3 place{place_along(i % parts_per_board), 0, top_of(board)};
    if (i == standing_slot) {
      add(scene, "standing block", shared(box_mesh({0x1p-4, 0x1p-4, 0x1p-4}, {0, 0, 0x1p-4})),
          Pose::translation(place.x, place.y, place.z));
      continue;
    }
    if (i == crate_slot) {
      place.z += 0.001;
      add(scene, "crate", shared(box_mesh({0.08, 0.08, 0.08}, {0, 0, 0.08})), {Mat3{}, place});
      add(scene, "ball in the crate", shared(icosphere_mesh(0.05, 2)), {Mat3{}, place + Vec3{0, 0, 0.08}});
      continue;
    }
    // The slipped part was put in its neighbour's place.
    if (i == clash_slot) place.x = place_along(clash_slot % parts_per_board - 1) + 0.05;
    const std::string name = i == clash_slot ? "slipped part" : fmt::format("{} {}", kind.name, i + 1);
    const SharedMesh& mesh = i == clash_slot ? kinds[0].mesh : kind.mesh;
    add(scene, name, mesh, shelved(*mesh, size, degrees, place));
  }
  return scene;
}

Scene many_parts(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const std::vector<PartKind> kinds = kinds_of_parts();
  // About 16 units of room for each part; found by multiplying, as cube roots differ between platforms.
  double side = 4;
  while (side * side * side < 16 * static_cast<double>(count)) side *= 1.125;
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const PartKind& kind = kinds[random.below(kinds.size())];
    const Mat3 rotation = random_rotation(random);
    const double x = random.between(0, side), y = random.between(0, side), z = random.between(0, side);
    add(scene, fmt::format("{} {}", kind.name, i + 1), kind.mesh, {rotation, {x, y, z}});
  }
  return scene;
}

}  // namespace toccata
