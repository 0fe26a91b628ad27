#include "toccata/robots/generated_arm.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// From a joint to the next one, and how thick the link between is.
struct ArmPiece {
  double length;
  double radius;
};

constexpr std::array<ArmPiece, 8> arm_pieces{
    {{0.15, 0.1}, {0.19, 0.08}, {0.21, 0.075}, {0.19, 0.07}, {0.21, 0.065}, {0.19, 0.06}, {0.08, 0.055}, {0.09, 0.04}}};

/// Along z from a joint to the next.
TriangleMesh long_ball(const ArmPiece& piece, int subdivisions, std::uint64_t seed) {
  const TriangleMesh ball =
      noise_sphere_mesh({.radius = 1, .roughness = 0.1, .subdivisions = subdivisions, .seed = seed});
  std::vector<Vec3> vertices(ball.vertices().begin(), ball.vertices().end());
  const double half = 0.5 * piece.length;
  for (Vec3& v : vertices) v = {piece.radius * v.x, piece.radius * v.y, (half + 0.3 * piece.radius) * v.z + half};
  return {std::move(vertices), std::vector(ball.triangles().begin(), ball.triangles().end())};
}

Shape room_mesh(std::size_t which) {
  const auto of = [](const TriangleMesh& mesh, double factor) -> Shape {
    return std::make_shared<const TriangleMesh>(scaled_mesh(mesh, factor));
  };
  if (which == 0) return of(torus_knot_mesh({}), 0.12);
  if (which == 1) return of(noise_sphere_mesh({.subdivisions = 4}), 0.15);
  return of(gear_mesh({}), 0.15);
}

/// Somewhere around the arm, and not where it stands upright.
Vec3 place_in_room(Random& random) {
  const double turns = random.between(0, 1), distance = random.between(0.35, 1.1);
  const Pose turned = Pose::rotation({0, 0, 1}, 360 * turns);
  return turned * Vec3{distance, 0, random.between(-0.1, 1.1)};
}

Pose pose_in_room(Random& random) {
  const Vec3 place = place_in_room(random);
  const Quaternion turn{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
  return Pose::rigid(turn, place);
}

}  // namespace

RobotDescription generated_arm(const GeneratedArmShape& shape) {
  RobotDescription arm{"generated arm", {}, {}, {}};
  for (std::size_t i = 0; i < arm_pieces.size(); ++i) {
    const std::string link = i == 0 ? "base" : fmt::format("link {}", i);
    auto mesh = std::make_shared<const TriangleMesh>(long_ball(arm_pieces[i], shape.subdivisions, shape.seed + i));
    arm.links.push_back({link, {{.shape = std::move(mesh)}}});
    if (i == 0) continue;
    const bool is_upright = i % 2 == 1;
    const double most = is_upright ? 2.9 : 2.0;
    arm.joints.push_back({.name = fmt::format("joint {}", i),
                          .kind = RobotJointKind::revolute,
                          .parent = arm.links[i - 1].name,
                          .child = link,
                          .origin = Pose::translation(0, 0, arm_pieces[i - 1].length),
                          .axis = is_upright ? Vec3{0, 0, 1} : Vec3{0, 1, 0},
                          .limits = JointLimits{-most, most}});
  }
  return arm;
}

std::vector<SceneInstance> generated_room(const GeneratedRoomShape& shape) {
  Random random(shape.seed);
  std::vector<SceneInstance> room;
  for (std::size_t i = 0; i < shape.boxes; ++i) {
    const Vec3 half{random.between(0.01, 0.06), random.between(0.01, 0.06), random.between(0.01, 0.06)};
    room.push_back({Box{half}, pose_in_room(random), Solid::automatic, fmt::format("box {}", i)});
  }
  for (std::size_t i = 0; i < 3 && shape.meshes; ++i)
    room.push_back({Model(room_mesh(i)), pose_in_room(random), Solid::automatic, fmt::format("mesh {}", i)});
  return room;
}

}  // namespace toccata
