#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "oracle/test_meshes.hpp"
#include "query/winding_checks.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {

/// Closed meshes, as they may be.
inline const std::vector<std::string>& closed_families() {
  static const std::vector<std::string> all{"voxels",      "cells",    "inside out", "nested",
                                            "overlapping", "far away", "tiny",       "huge"};
  return all;
}

inline TriangleMesh closed_mesh(const std::string& family, Random& random) {
  const VoxelSolid solid = random_voxels(random, 5, 3);
  if (family == "cells") return mesh_of(solid, Skin::every, random);
  if (family == "inside out") return mesh_of(solid, Skin::inside_out, random);
  const TriangleMesh large = box_between({-1, -1, -1}, {3, 3, 3});
  if (family == "nested") return oracle::joined(large, oracle::inverted_box_mesh({0, 0, 0}, {1.5, 1.75, 2}));
  if (family == "overlapping") return oracle::joined(large, box_between({0.5, 1, -2}, {4, 2, 5}));
  return mesh_of(solid, Skin::outer, random);
}

inline Pose closed_pose(const std::string& family, Random& random) {
  Pose pose;
  if (random.below(3) == 0) pose.linear = random_rotation(random);
  if (random.below(6) == 0) pose.linear[0] = -pose.linear[0];
  if (family == "far away") pose.offset = {1e7, -3e6, 1e8};
  if (family == "tiny") pose = scaled(pose, 0x1p-200);
  if (family == "huge") pose = scaled(pose, 0x1p200);
  return pose;
}

inline PointCase closed_case(const std::string& family, Random& random) {
  PointCase c{closed_mesh(family, random), {}, {}};
  c.pose = closed_pose(family, random);
  const std::vector<Triangle> world = world_triangles(c.mesh, c.pose);
  const std::string where = point_families()[random.below(point_families().size())];
  c.point = some_point_at(where, world[random.below(world.size())], size_of(c.mesh, c.pose), random);
  return c;
}

/// The squared distance of the point from all triangles.
inline oracle::Rational squared_distance_from(const PointCase& c) {
  const oracle::ConvexSet point = oracle::point_set(c.point);
  oracle::Rational least(-1);
  for (const Triangle& t : world_triangles(c.mesh, c.pose)) {
    const oracle::Rational squared = oracle::squared_distance(point, oracle::triangle_set(t[0], t[1], t[2]));
    if (least < 0 || squared < least) least = squared;
  }
  return least;
}

/// What is wrong with the magnitudes, which are not negative.
inline std::string interval_fault(const PointCase& c, double lower, double upper) {
  const oracle::Rational squared = squared_distance_from(c), least(lower), greatest(upper);
  if (least * least > squared || greatest * greatest < squared) return "the distance is not in its interval";
  if (!(upper - lower <= 1e-12 * upper) && std::nextafter(lower, HUGE_VAL) < upper) return "the interval is wide";
  return "";
}

/// What is wrong with the answer about a closed mesh, or nothing.
inline std::string signed_fault(const PointCase& c, const SignedDistance& found) {
  const oracle::Location truth = oracle::locate(oracle::exact(c.point), oracle::solid_set(c.mesh, c.pose));
  const Side side = truth.on_face ? Side::boundary : truth.winding_number != 0 ? Side::inside : Side::outside;
  if (found.status != Status::exact || found.sign_by != SignBy::winding_number) return "not exact";
  if (found.side != side) return "the side is wrong";
  if (side == Side::boundary) return found.lower == 0 && found.upper == 0 ? "" : "not 0 on the surface";
  if (side == Side::inside) return found.upper < 0 ? interval_fault(c, -found.upper, -found.lower) : "not negative";
  return found.lower > 0 ? interval_fault(c, found.lower, found.upper) : "not positive";
}

}  // namespace toccata::test
