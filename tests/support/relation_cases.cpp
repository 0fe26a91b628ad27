#include "support/relation_cases.hpp"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

std::vector<std::array<Index, 3>> triangles_of(const TriangleMesh& mesh) {
  return {mesh.triangles().begin(), mesh.triangles().end()};
}

double on_grid(Random& random, int steps) { return static_cast<double>(random.below(static_cast<unsigned>(steps))); }

Vec3 grid_point(Random& random, int steps) {
  const double x = on_grid(random, steps), y = on_grid(random, steps), z = on_grid(random, steps);
  return {x, y, z};
}

TriangleMesh grid_box(Random& random) {
  const Vec3 lower = grid_point(random, 3), size = grid_point(random, 2) + Vec3{1, 1, 1};
  return random.below(2) == 0 ? box_between(lower, lower + size) : other_box_mesh(lower, lower + size);
}

TriangleMesh grid_tetrahedron(Random& random) {
  const Vec3 p = grid_point(random, 4), q = grid_point(random, 4), r = grid_point(random, 4), s = grid_point(random, 4);
  return tetrahedron_mesh(p, q, r, s);
}

TriangleMesh free_tetrahedron(Random& random) {
  const auto point = [&] {
    const double x = random.between(0, 2), y = random.between(0, 2), z = random.between(0, 2);
    return Vec3{x, y, z};
  };
  const Vec3 p = point(), q = point(), r = point(), s = point();
  return tetrahedron_mesh(p, q, r, s);
}

/// Closed, without inside.
TriangleMesh doubled_sheet(Random& random) {
  const Vec3 p = grid_point(random, 4), q = grid_point(random, 4), r = grid_point(random, 4);
  return TriangleMesh({p, q, r}, {{0, 1, 2}, {0, 2, 1}});
}

TriangleMesh some_parts(Random& random) {
  std::vector<TriangleMesh> parts;
  for (auto count = 2 + random.below(2); count > 0; --count) {
    const auto kind = random.below(6);
    TriangleMesh part = kind == 0 ? grid_tetrahedron(random) : kind == 1 ? doubled_sheet(random) : grid_box(random);
    parts.push_back(random.below(3) == 0 ? inverted(part) : part);
  }
  return joined(parts);
}

/// A box with a box-shaped hole; sometimes the hole sticks out, or is filled twice.
TriangleMesh hollow(Random& random) {
  const TriangleMesh hole = box_between({1, 1, 1}, Vec3{2, 2, 2} + grid_point(random, 2));
  return joined({box_between({0, 0, 0}, {4, 4, 3}), random.below(4) == 0 ? hole : inverted(hole)});
}

/// A turn by multiples of 90°, perhaps mirrored, by 1/2, 1 or 2, moved by halves.
Pose grid_pose(Random& random) {
  Pose pose;
  const double factor = std::array{1.0, 1.0, 0.5, 2.0}[random.below(4)];
  const auto shift = static_cast<int>(random.below(3));
  for (int i = 0; i < 3; ++i) {
    pose.linear[i] = {0, 0, 0};
    pose.linear[i][(i + shift) % 3] = random.below(4) == 0 ? -factor : factor;
    pose.offset[i] = 0.5 * on_grid(random, 6) - 1;
  }
  return pose;
}

/// Entries that are multiples of 1/2, not singular.
Pose sheared_pose(Random& random) {
  Pose pose;
  do {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.linear[i][j] = 0.5 * on_grid(random, 5) - 1;
      pose.offset[i] = 0.5 * on_grid(random, 5) - 1;
    }
  } while (is_singular(pose.linear));
  return pose;
}

Pose rigid_pose(Random& random) {
  const Mat3 rotation = random_rotation(random);
  const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
  return {rotation, {x, y, z}};
}

// The members of a braced list are made in order, function arguments are not: the same cases with every compiler.
struct TwoMeshes {
  TriangleMesh a;
  TriangleMesh b;
};

/// Within a cube of 8 steps between neighbouring doubles: its cells are a few doubles high, or less than one.
TriangleMesh ulp_tetrahedron(Random& random) {
  const auto point = [&] { return Vec3{1, 1, 1} + 0x1p-52 * grid_point(random, 9); };
  const Vec3 p = point(), q = point(), r = point(), s = point();
  return tetrahedron_mesh(p, q, r, s);
}

/// On the plane z = 0, within such steps of the line y = 1: mostly at its ends, x = 0 and 8, or in its middle.
Vec3 point_by_line(bool at_ends, Random& random) {
  const bool anywhere = random.below(4) == 0;
  const double end = 8 * on_grid(random, 2), x = anywhere ? on_grid(random, 9) : at_ends ? end : 4;
  return {x, 1 + 0x1p-52 * on_grid(random, 5), 0};
}

/// A point of whole coordinates, above the plane or below it, now and then on it.
Vec3 point_off_line(double up, Random& random) {
  const Vec3 p = grid_point(random, 9);
  return {p.x, p.y - 3, up * p.z};
}

/// With a face by the line, long and almost without height.
TriangleMesh tetrahedron_with_flat_face(Random& random) {
  const Vec3 p = point_by_line(true, random), q = point_by_line(true, random), r = point_by_line(true, random);
  const Vec3 s = point_off_line(1, random);
  return tetrahedron_mesh(p, q, r, s);
}

TriangleMesh tetrahedron_with_tip_on_line(Random& random) {
  const Vec3 tip = point_by_line(false, random);
  const Vec3 p = point_off_line(-1, random), q = point_off_line(-1, random), r = point_off_line(-1, random);
  return tetrahedron_mesh(tip, p, q, r);
}

/// Two tetrahedra a few doubles thick, or a flat one and the tip of another.
TwoMeshes ulp_meshes(Random& random) {
  if (random.below(4) == 0) return {ulp_tetrahedron(random), ulp_tetrahedron(random)};
  return {tetrahedron_with_tip_on_line(random), tetrahedron_with_flat_face(random)};
}

/// Without poses, which would round the last bits away.
RelationCase ulp_case(TwoMeshes meshes, Random& random) {
  RelationCase made{std::move(meshes.a), std::move(meshes.b), {}};
  if (random.below(3) == 0) made.query.solid_b = Solid::none;
  return made;
}

RelationCase grid_case(TwoMeshes meshes, Random& random) {
  const Pose pose_a = grid_pose(random), pose_b = random.below(3) == 0 ? pose_a : grid_pose(random);
  return {std::move(meshes.a), std::move(meshes.b), {pose_a, pose_b}};
}

/// A surface of a few triangles, some without area, sometimes a closed one taken as a surface.
TriangleMesh some_surface(Random& random) {
  std::vector<Vec3> vertices;
  for (int i = 0; i < 5; ++i) vertices.push_back(0.5 * grid_point(random, 8));
  std::vector<std::array<Index, 3>> triangles;
  const auto corner = [&] { return static_cast<Index>(random.below(5)); };
  for (auto count = 1 + random.below(4); count > 0; --count) {
    const Index i = corner(), j = corner(), k = corner();
    triangles.push_back({i, j, k});
  }
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

RelationCase surface_case(TwoMeshes meshes, Solid solid_a, Random& random) {
  RelationCase made = grid_case(std::move(meshes), random);
  made.query.solid_a = solid_a;
  made.query.solid_b = Solid::none;
  return made;
}

RelationCase equal_case(Random& random) {
  const TriangleMesh mesh = some_parts(random);
  const Pose pose = sheared_pose(random);
  return {mesh, random.below(2) == 0 ? mesh : inverted(mesh), {pose, pose}};
}

}  // namespace

TriangleMesh other_box_mesh(const Vec3& lower, const Vec3& upper) {
  std::vector<Vec3> corners;
  for (const double z : {lower.z, upper.z})
    for (const double y : {lower.y, upper.y})
      for (const double x : {lower.x, upper.x}) corners.push_back({x, y, z});
  const std::array<std::array<Index, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [i, j, k, l] : sides) {
    triangles.push_back({j, k, l});
    triangles.push_back({j, l, i});
  }
  return TriangleMesh(std::move(corners), std::move(triangles));
}

TriangleMesh l_mesh() {
  const std::array<Vec3, 6> outline{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};
  std::vector<Vec3> vertices;
  for (const double z : {0.0, 1.0})
    for (const Vec3& p : outline) vertices.push_back({p.x, p.y, z});
  std::vector<std::array<Index, 3>> triangles;
  const std::array<std::array<Index, 3>, 4> floor{{{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}};
  for (const auto& [i, j, k] : floor) {
    triangles.push_back({i, k, j});
    triangles.push_back({i + 6, j + 6, k + 6});
  }
  for (Index i = 0; i < 6; ++i) {
    const Index j = (i + 1) % 6;
    triangles.push_back({i, j, j + 6});
    triangles.push_back({i, j + 6, i + 6});
  }
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

TriangleMesh tetrahedron_mesh(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  return TriangleMesh({p, q, r, s}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

TriangleMesh sphere_mesh(double radius, int levels) {
  std::vector<Vec3> vertices{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<Index, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                              {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (; levels > 0; --levels) {
    std::map<std::pair<Index, Index>, Index> middle_of;
    const auto middle = [&](Index i, Index j) {
      const auto [place, made] =
          middle_of.try_emplace({std::min(i, j), std::max(i, j)}, static_cast<Index>(vertices.size()));
      if (made) {
        const Vec3 sum = vertices[i] + vertices[j];
        vertices.push_back(1 / std::sqrt(dot(sum, sum)) * sum);
      }
      return place->second;
    };
    std::vector<std::array<Index, 3>> finer;
    for (const auto& [i, j, k] : triangles) {
      const Index ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
      finer.insert(finer.end(), {{i, ij, ki}, {ij, j, jk}, {ki, jk, k}, {ij, jk, ki}});
    }
    triangles = std::move(finer);
  }
  for (Vec3& v : vertices) v = radius * v;
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

TriangleMesh inverted(const TriangleMesh& mesh) {
  std::vector<std::array<Index, 3>> triangles = triangles_of(mesh);
  for (auto& corner : triangles) std::swap(corner[1], corner[2]);
  return TriangleMesh({mesh.vertices().begin(), mesh.vertices().end()}, std::move(triangles));
}

TriangleMesh joined(const std::vector<TriangleMesh>& meshes) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (const TriangleMesh& mesh : meshes) {
    const auto shift = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
    for (const auto& [i, j, k] : mesh.triangles()) triangles.push_back({i + shift, j + shift, k + shift});
  }
  return TriangleMesh(std::move(vertices), std::move(triangles));
}

TriangleMesh placed(const TriangleMesh& mesh, double factor, const Vec3& offset) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v = factor * v + offset;
  return TriangleMesh(std::move(vertices), triangles_of(mesh));
}

const std::vector<std::string>& relation_families() {
  static const std::vector<std::string> families{
      "grid boxes", "grid tetrahedra", "free tetrahedra", "l shapes", "parts", "hollow boxes",
      "sheared",    "solid-surface",   "surface-surface", "equal",    "rigid", "ulp cells"};
  return families;
}

RelationCase random_relation_case(const std::string& family, Random& random) {
  if (family == "grid boxes") return grid_case({grid_box(random), grid_box(random)}, random);
  if (family == "grid tetrahedra") return grid_case({grid_tetrahedron(random), grid_tetrahedron(random)}, random);
  if (family == "free tetrahedra")
    return {free_tetrahedron(random), free_tetrahedron(random), {rigid_pose(random), sheared_pose(random)}};
  if (family == "l shapes") return grid_case({l_mesh(), random.below(2) == 0 ? l_mesh() : grid_box(random)}, random);
  if (family == "parts") return grid_case({some_parts(random), some_parts(random)}, random);
  if (family == "hollow boxes")
    return grid_case({hollow(random), random.below(2) == 0 ? hollow(random) : grid_box(random)}, random);
  if (family == "sheared")
    return {grid_box(random), grid_tetrahedron(random), {sheared_pose(random), sheared_pose(random)}};
  if (family == "rigid") return {l_mesh(), grid_box(random), {rigid_pose(random), rigid_pose(random)}};
  if (family == "ulp cells") return ulp_case(ulp_meshes(random), random);
  if (family == "equal") return equal_case(random);
  if (family == "solid-surface")
    return surface_case({some_parts(random), some_surface(random)}, Solid::automatic, random);
  if (family == "surface-surface")
    return surface_case({some_surface(random), some_surface(random)}, Solid::none, random);
  throw std::invalid_argument("no such family: " + family);
}

}  // namespace toccata::test
