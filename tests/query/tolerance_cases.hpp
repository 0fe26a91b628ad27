#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oracle/local_depth.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "support/voxel_clashes.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/check_all.hpp"

// Pairs of solids of which it is known how deep they are in each other where they are deepest, and what kind of clash
// they are.
namespace toccata::test {

struct ToleranceCase {
  TriangleMesh a;
  TriangleMesh b;
  PairQuery query;
  oracle::LocalDepth depth;  ///< of two that overlap; what of it is not exact is within the two
  double size = 1;           ///< the greatest coordinate, about
  bool is_clean = true;      ///< neither mesh meets itself or has a shell within another: so their depth is told
  std::optional<Relation> relation{};  ///< where it is counted
  std::optional<VoxelClash> clash{};   ///< of two that overlap and have no faces in one plane, counted
};

/// A turn by quarters, perhaps mirrored, scaled by a power of two, and a place off the origin: what has few digits
/// stays exact.
inline Pose exact_place(Random& random) {
  Pose pose;
  const double scale = random.below(4) == 0 ? std::exp2(static_cast<double>(random.below(21)) - 10) : 1;
  const auto shift = static_cast<int>(random.below(3));
  for (int i = 0; i < 3; ++i) {
    pose.linear[i] = {0, 0, 0};
    pose.linear[i][(i + shift) % 3] = random.below(2) == 0 ? -scale : scale;
    if (random.below(2) == 0) pose.offset[i] = scale * (static_cast<double>(random.below(2048)) - 1024);
  }
  return pose;
}

inline double scale_of(const Pose& place) {
  const Vec3& row = place.linear[0];
  return std::max({std::abs(row.x), std::abs(row.y), std::abs(row.z)});
}

inline double greatest_coordinate(const ToleranceCase& made) {
  double greatest = 0;
  for (const auto& [mesh, pose] : {std::pair(&made.a, &made.query.pose_a), std::pair(&made.b, &made.query.pose_b)})
    for (const Vec3& vertex : mesh->vertices()) {
      const Vec3 p = transform(*pose, vertex);
      greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  return greatest;
}

inline oracle::LocalDepth with_slack(oracle::LocalDepth depth, double slack) {
  return {std::max(0.0, depth.lower - slack), depth.upper + slack};
}

/// Two boxes along one set of axes: a point between two faces of each is at most as deep as these are apart, and as
/// half of what each box is thick. Multiples of 1/64, so that all is exact.
inline ToleranceCase boxes_with_depth(Random& random) {
  const double step = random.below(2) == 0 ? 1.0 / 64 : 0.5;
  const auto coordinate = [&] { return step * static_cast<double>(random.below(static_cast<unsigned>(2 / step))); };
  std::array<Vec3, 4> ends;
  double depth = std::numeric_limits<double>::infinity(), thin_a = depth, thin_b = depth;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t box = 0; box < 2; ++box) {
      const double p = coordinate();
      double q = coordinate();
      while (q == p) q = coordinate();
      ends[2 * box][axis] = std::min(p, q);
      ends[2 * box + 1][axis] = std::max(p, q);
    }
    depth = std::min({depth, ends[1][axis] - ends[2][axis], ends[3][axis] - ends[0][axis]});
    thin_a = std::min(thin_a, ends[1][axis] - ends[0][axis]);
    thin_b = std::min(thin_b, ends[3][axis] - ends[2][axis]);
  }
  const Pose place = exact_place(random);
  depth = scale_of(place) * std::min(depth, 0.5 * (thin_a + thin_b));
  ToleranceCase made{other_box_mesh(ends[0], ends[1]), box_between(ends[2], ends[3]), {place, place}, {depth, depth}};
  made.relation = Relation{.a_solid = true, .b_solid = true};
  if (depth < 0) return made;
  made.relation->kind = depth == 0 ? RelationKind::touching : RelationKind::overlapping;
  if (depth == 0) return made;
  bool a_in_b = true, b_in_a = true;
  for (int axis = 0; axis < 3; ++axis) {
    a_in_b = a_in_b && ends[2][axis] <= ends[0][axis] && ends[1][axis] <= ends[3][axis];
    b_in_a = b_in_a && ends[0][axis] <= ends[2][axis] && ends[3][axis] <= ends[1][axis];
  }
  made.relation->containment = a_in_b && b_in_a ? Containment::equal
                               : a_in_b         ? Containment::a_in_b
                               : b_in_a         ? Containment::b_in_a
                                                : Containment::none;
  return made;
}

/// The planes of a convex mesh's triangles in the world, each once.
inline std::vector<oracle::FacetPlane> facet_planes(const TriangleMesh& mesh, const Pose& pose) {
  Vec3 middle;
  for (const Vec3& vertex : mesh.vertices()) middle = middle + transform(pose, vertex);
  middle = (1.0 / static_cast<double>(mesh.vertices().size())) * middle;
  std::vector<oracle::FacetPlane> planes;
  for (const auto& corner : mesh.triangles()) {
    const Vec3 p = transform(pose, mesh.vertices()[corner[0]]), q = transform(pose, mesh.vertices()[corner[1]]),
               r = transform(pose, mesh.vertices()[corner[2]]);
    const Vec3 across = cross(q - p, r - p);
    const double outwards = dot(across, p - middle) > 0 ? 1 : -1;
    const Vec3 normal = (outwards / std::sqrt(dot(across, across))) * across;
    const auto is_same = [&](const oracle::FacetPlane& plane) { return dot(plane.normal, normal) > 1 - 1e-12; };
    if (std::ranges::none_of(planes, is_same)) planes.push_back({normal, dot(normal, p)});
  }
  return planes;
}

/// The linear program; the bracket is wide where it is nearly singular.
inline ToleranceCase convex_with_depth(TriangleMesh a, TriangleMesh b, const PairQuery& query) {
  ToleranceCase made{std::move(a), std::move(b), query, {}};
  const auto depth =
      oracle::local_depth_of_convex(facet_planes(made.a, query.pose_a), facet_planes(made.b, query.pose_b));
  made.depth = with_slack(depth, 1e-10);
  return made;
}

inline TriangleMesh fat_tetrahedron(Random& random) {
  for (;;) {
    const Vec3 p = random_vector(random, 1), q = random_vector(random, 1), r = random_vector(random, 1),
               s = random_vector(random, 1);
    if (dot(cross(q - p, r - p), s - p) < -0.05) return tetrahedron_mesh(p, q, r, s);
  }
}

inline ToleranceCase tetrahedra_with_depth(Random& random) {
  const Pose pose_b = random.below(2) == 0 ? Pose{} : Pose{random_rotation(random), random_vector(random, 0.5)};
  return convex_with_depth(fat_tetrahedron(random), fat_tetrahedron(random), {.pose_b = pose_b});
}

/// Boxes turned anyhow.
inline ToleranceCase turned_boxes_with_depth(Random& random) {
  const auto some_box = [&] {
    const double thin = random.below(3) == 0 ? 0.02 : 0.3;
    return box_mesh({random.between(0.2, 1), random.between(0.2, 1), random.between(thin, 1)});
  };
  const PairQuery query{.pose_a = {random_rotation(random), {}},
                        .pose_b = {random_rotation(random), random_vector(random, 1.2)}};
  return convex_with_depth(some_box(), some_box(), query);
}

/// The facet of a mesh around the origin that is nearest to it.
inline oracle::FacetPlane nearest_facet(const TriangleMesh& mesh) {
  const std::vector<oracle::FacetPlane> planes = facet_planes(mesh, {});
  return *std::ranges::min_element(planes, {}, &oracle::FacetPlane::offset);
}

/// A rotation that turns one unit vector into another or into its opposite, whichever is nearer.
inline Mat3 rotation_to_line(const Vec3& from, const Vec3& to) {
  const double sign = dot(from, to) < 0 ? -1 : 1;
  const Vec3 axis = sign * cross(from, to);
  return rotation_of({axis.x, axis.y, axis.z, 1 + sign * dot(from, to)});
}

/// Meshes of spheres. Each lies between two balls, so they are as deep as the radii are longer than the way between the
/// middles. Where the facets nearest to the middles face each other it is known: those are as far apart. (Each facet
/// has an opposite one as far from the middle.)
inline ToleranceCase spheres_with_depth(Random& random) {
  const auto some_sphere = [&](double radius) {
    return icosphere_mesh(radius, static_cast<int>(random.below(random.below(4) == 0 ? 4 : 3)));
  };
  const double radius_a = random.between(0.5, 1), radius_b = random.between(0.5, 1);
  TriangleMesh a = some_sphere(radius_a), b = some_sphere(radius_b);
  const oracle::FacetPlane facet_a = nearest_facet(a), facet_b = nearest_facet(b);
  const double reach = facet_a.offset + facet_b.offset,
               depth = random.below(2) == 0 ? random.between(0, 0.2) : random.between(0, reach);
  const Pose turned{random_rotation(random), {}};
  if (random.below(3) == 0) {
    const Vec3 way = (reach - depth) * transform(turned, Vec3{1, 0, 0});
    return {std::move(a),
            std::move(b),
            {.pose_b = Pose{random_rotation(random), way}},
            with_slack({depth, radius_a + radius_b - reach + depth}, 1e-12)};
  }
  const Pose facing{rotation_to_line(facet_b.normal, facet_a.normal), (reach - depth) * facet_a.normal};
  return {std::move(a), std::move(b), {turned, turned * facing}, with_slack({depth, depth}, 1e-12)};
}

/// The voxels and the squares of the surface as boxes at a place, their grid moved by a vector first.
inline oracle::CellSolid cells_of(const VoxelSolid& solid, const Vec3& moved) {
  oracle::CellSolid cells;
  for (const Voxel& voxel : solid) {
    const Vec3 lower = moved + Vec3{1.0 * voxel[0], 1.0 * voxel[1], 1.0 * voxel[2]};
    const oracle::AxisBox cell{lower, lower + Vec3{1, 1, 1}};
    cells.cells.push_back(cell);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        Voxel across = voxel;
        across[axis] += by;
        if (solid.contains(across)) continue;
        oracle::AxisBox face = cell;
        const int i = static_cast<int>(axis);
        (by < 0 ? face.upper : face.lower)[i] = by < 0 ? cell.lower[i] : cell.upper[i];
        cells.surface.push_back(face);
      }
  }
  return cells;
}

/// A mesh of two solids, whose voxels lie on grids that are moved against each other by a part of a step.
struct MeshOfVoxels {
  VoxelSolid solid;
  TriangleMesh mesh;
};

/// How far one grid is moved along each axis: 0, a half, or any number of few digits between 0 and 1.
inline Vec3 some_part_of_step(Random& random) {
  Vec3 part;
  const std::uint64_t kind = random.below(4);
  for (int i = 0; i < 3; ++i)
    part[i] =
        kind == 0 ? 0.5 * static_cast<double>(random.below(2)) : static_cast<double>(1 + random.below(1023)) / 1024;
  return part;
}

inline ToleranceCase voxels_with_depth(const MeshOfVoxels& a, const MeshOfVoxels& b, Random& random) {
  Vec3 moved = some_part_of_step(random);
  Voxel steps{};
  bool is_general = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const int whole = static_cast<int>(random.below(3)) - 1;
    const int axis = static_cast<int>(i);
    steps[i] = 2 * whole + (moved[axis] > 0 ? 1 : 0);
    is_general = is_general && moved[axis] > 0;
    moved[axis] += whole;
  }
  const Pose place = exact_place(random);
  const double scale = scale_of(place);
  ToleranceCase made{a.mesh, b.mesh, {place, place * Pose::translation(moved)}, {}};
  const VoxelSolid fine_a = on_half_grid(a.solid, {}), fine_b = on_half_grid(b.solid, steps);
  made.relation = true_relation(fine_a, fine_b);
  if (made.relation->kind != RelationKind::overlapping) return made;
  made.depth = oracle::local_depth_of_cells(cells_of(a.solid, {}), cells_of(b.solid, moved), 2e-3);
  made.depth = with_slack({scale * made.depth.lower, scale * made.depth.upper}, scale * 1e-12);
  if (is_general) made.clash = true_clash(fine_a, fine_b);
  return made;
}

inline ToleranceCase voxel_solids_with_depth(Random& random) {
  const auto some_solid = [&] {
    VoxelSolid solid = random_manifold_voxels(random, 4);
    TriangleMesh mesh = mesh_of(solid, random.below(4) == 0 ? Skin::inside_out : Skin::outer, random);
    return MeshOfVoxels{std::move(solid), std::move(mesh)};
  };
  const MeshOfVoxels a = some_solid(), b = some_solid();
  return voxels_with_depth(a, b, random);
}

/// Boxes as one mesh, some of them inside out, which overlap, hold each other, or have faces in common: inside is where
/// the winding number is not 0.
inline MeshOfVoxels shells(Random& random) {
  constexpr int size = 3;
  for (;;) {
    std::vector<TriangleMesh> boxes;
    std::map<Voxel, int> winding;
    for (std::uint64_t count = 2 + random.below(2); count > 0; --count) {
      Voxel from{}, to{};
      for (std::size_t i = 0; i < 3; ++i) {
        from[i] = static_cast<int>(random.below(size));
        to[i] = from[i] + 1 + static_cast<int>(random.below(static_cast<unsigned>(size - from[i])));
      }
      const auto point = [](const Voxel& v) { return Vec3{1.0 * v[0], 1.0 * v[1], 1.0 * v[2]}; };
      const TriangleMesh box = other_box_mesh(point(from), point(to));
      const bool is_turned = random.below(4) == 0;
      boxes.push_back(is_turned ? inverted(box) : box);
      for (int x = from[0]; x < to[0]; ++x)
        for (int y = from[1]; y < to[1]; ++y)
          for (int z = from[2]; z < to[2]; ++z) winding[{x, y, z}] += is_turned ? -1 : 1;
    }
    VoxelSolid solid;
    for (const auto& [voxel, number] : winding)
      if (number != 0) solid.insert(voxel);
    if (!solid.empty()) return {std::move(solid), joined(boxes)};
  }
}

inline ToleranceCase shells_with_depth(Random& random) {
  const auto some_solid = [&] {
    if (random.below(2) == 0) return shells(random);
    VoxelSolid solid = random_manifold_voxels(random, 3);
    TriangleMesh mesh = mesh_of(solid, random.below(2) == 0 ? Skin::every : Skin::outer, random);
    return MeshOfVoxels{std::move(solid), std::move(mesh)};
  };
  const MeshOfVoxels a = some_solid(), b = some_solid();
  ToleranceCase made = voxels_with_depth(a, b, random);
  made.is_clean = false;
  made.relation.reset();  // faces that are there twice lie within or without a solid, where they may touch
  made.clash.reset();
  return made;
}

inline const std::vector<std::string>& tolerance_families() {
  static const std::vector<std::string> all{"boxes", "turned boxes", "tetrahedra", "spheres", "voxels", "shells"};
  return all;
}

inline ToleranceCase random_tolerance_case(const std::string& family, Random& random) {
  ToleranceCase made = family == "boxes"          ? boxes_with_depth(random)
                       : family == "turned boxes" ? turned_boxes_with_depth(random)
                       : family == "tetrahedra"   ? tetrahedra_with_depth(random)
                       : family == "spheres"      ? spheres_with_depth(random)
                       : family == "voxels"       ? voxel_solids_with_depth(random)
                                                  : shells_with_depth(random);
  made.size = greatest_coordinate(made);
  return made;
}

}  // namespace toccata::test
