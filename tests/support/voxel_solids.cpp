#include "support/voxel_solids.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace toccata::test {
namespace {

Voxel shifted(Voxel voxel, int axis, int by) {
  voxel[static_cast<std::size_t>(axis)] += by;
  return voxel;
}

int coordinate(Random& random, int size) { return static_cast<int>(random.below(static_cast<std::uint64_t>(size))); }

Voxel random_voxel(Random& random, int size) {
  const int x = coordinate(random, size), y = coordinate(random, size), z = coordinate(random, size);
  return {x, y, z};
}

class GridMesh {
 public:
  explicit GridMesh(Random& random) : random_(random) {}

  /// Two triangles; their normal points along the axis or, turned, against it.
  void add(const GridFace& face, bool turned) {
    const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    std::array<Index, 4> corner = {add(face.lower), add(shifted(face.lower, u, 1)),
                                   add(shifted(shifted(face.lower, u, 1), v, 1)), add(shifted(face.lower, v, 1))};
    if (turned) std::swap(corner[1], corner[3]);
    const std::size_t first = random_.below(4);
    const auto at = [&](std::size_t i) { return corner[(first + i) % 4]; };
    triangles_.push_back({at(0), at(1), at(2)});
    triangles_.push_back({at(0), at(2), at(3)});
  }

  [[nodiscard]] TriangleMesh mesh() const { return {vertices_, triangles_}; }

 private:
  Index add(const Voxel& p) {
    vertices_.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return static_cast<Index>(vertices_.size() - 1);
  }

  Random& random_;
  std::vector<Vec3> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
};

bool share_a_point(const Voxel& a, const Voxel& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(a[i] - b[i]) > 1) return false;
  return true;
}

/// The closed square and the closed cube have a point in common.
bool share_a_point(const GridFace& face, const Voxel& voxel) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int extent = static_cast<int>(i) == face.axis ? 0 : 1;
    if (face.lower[i] > voxel[i] + 1 || face.lower[i] + extent < voxel[i]) return false;
  }
  return true;
}

/// The open square lies between two voxels of the solid.
bool is_within(const GridFace& face, const VoxelSolid& solid) {
  return solid.contains(face.lower) && solid.contains(shifted(face.lower, face.axis, -1));
}

/// All voxels that share a point with the closed square belong to the solid: no point of it is on the outer skin.
bool is_deep_within(const GridFace& face, const VoxelSolid& solid) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Voxel near = {face.lower[0] + x, face.lower[1] + y, face.lower[2] + z};
        if (share_a_point(face, near) && !solid.contains(near)) return false;
      }
  return true;
}

template <class A, class B>
bool some_share_a_point(const A& a, const B& b) {
  return std::ranges::any_of(a, [&](const auto& of_a) {
    return std::ranges::any_of(b, [&](const auto& of_b) { return share_a_point(of_a, of_b); });
  });
}

Containment containment_of(const VoxelSolid& a, const VoxelSolid& b) {
  if (a == b) return Containment::equal;
  if (std::ranges::includes(b, a)) return Containment::a_in_b;
  return std::ranges::includes(a, b) ? Containment::b_in_a : Containment::none;
}

}  // namespace

VoxelSolid random_voxels(Random& random, int count, int size) {
  VoxelSolid result;
  const int wanted = 1 + coordinate(random, count);
  for (int i = 0; i < wanted; ++i) result.insert(random_voxel(random, size));
  return result;
}

GridSheet random_sheet(Random& random, int count, int size) {
  GridSheet result;
  const int wanted = 1 + coordinate(random, count);
  for (int i = 0; i < wanted; ++i) {
    const Voxel lower = random_voxel(random, size);
    result.insert({lower, coordinate(random, 3)});
  }
  return result;
}

TriangleMesh mesh_of(const VoxelSolid& solid, Skin skin, Random& random) {
  GridMesh result(random);
  for (const Voxel& voxel : solid)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side <= 1; ++side) {
        const bool covered = solid.contains(shifted(voxel, axis, side == 0 ? -1 : 1));
        if (covered && skin != Skin::every) continue;
        result.add({shifted(voxel, axis, side), axis}, (side == 0) != (skin == Skin::inside_out));
      }
  return result.mesh();
}

TriangleMesh mesh_of(const GridSheet& sheet, Random& random) {
  GridMesh result(random);
  for (const GridFace& face : sheet) result.add(face, random.below(2) == 0);
  return result.mesh();
}

Relation true_relation(const VoxelSolid& a, const VoxelSolid& b) {
  Relation result{.a_solid = true, .b_solid = true};
  const bool deep = std::ranges::any_of(a, [&](const Voxel& voxel) { return b.contains(voxel); });
  if (deep) {
    result.kind = RelationKind::overlapping;
    result.containment = containment_of(a, b);
  } else if (some_share_a_point(a, b)) {
    result.kind = RelationKind::touching;
  }
  return result;
}

Relation true_relation(const GridSheet& a, const VoxelSolid& b) {
  Relation result{.b_solid = true};
  if (std::ranges::any_of(a, [&](const GridFace& face) { return is_within(face, b); })) {
    result.kind = RelationKind::crossing;
    const bool all_in = std::ranges::all_of(a, [&](const GridFace& face) { return is_deep_within(face, b); });
    result.containment = all_in ? Containment::a_in_b : Containment::none;
  } else if (some_share_a_point(a, b)) {
    result.kind = RelationKind::touching;
  }
  return result;
}

Pose random_integer_pose(Random& random) {
  const auto entry = [&] { return static_cast<double>(random.below(7)) - 3; };
  Pose pose;
  do {
    for (Vec3& row : pose.linear.row) row = {entry(), entry(), entry()};
  } while (is_singular(pose.linear));
  pose.offset = {entry(), entry(), entry()};
  return pose;
}

}  // namespace toccata::test
