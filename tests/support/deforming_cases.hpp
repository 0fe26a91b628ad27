#pragma once

#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/motion/deforming_mesh.hpp"

namespace toccata::test {

/// A small mesh, and where its vertices go.
struct DeformingCase {
  TriangleMesh mesh;
  std::vector<Vec3> end;

  [[nodiscard]] DeformingMesh made() const { return {mesh, end}; }
};

/// soup (random triangles, some with common vertices), grid (few points, often in contact, many triangles without
/// area), plane (all stays in one plane), fold (a sheet that folds onto itself), planted (a corner is where a face is,
/// at a quarter, half or all of the time), beside-planted (a coordinate moved to the next double), rest (nothing
/// moves), tiny (about 1e-300), huge (about 1e300), far (1e12 from the origin).
const std::vector<std::string>& deforming_families();

DeformingCase random_deforming_case(const std::string& family, Random& random);

/// A sheet of cells × cells squares, each two triangles, in the plane z = 0 from 0 to 1.
TriangleMesh square_sheet_mesh(int cells);

}  // namespace toccata::test
