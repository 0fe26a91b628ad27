#include <algorithm>
#include <utility>
#include <vector>

#include "generate/mesh_building.hpp"
#include "generate/subdivided_sphere.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// A hill (height 1) or a hollow (height −1) around a direction.
struct Bump {
  Vec3 direction;
  double height;
};

std::vector<Bump> random_bumps(Random& random) {
  std::vector<Bump> bumps;
  for (int i = 0; i < 24; ++i) {
    const Vec3 direction = random_direction(random);
    bumps.push_back({direction, i % 2 == 0 ? 1.0 : -1.0});
  }
  return bumps;
}

/// In [−1, 1]: where bumps meet, their mean.
double bumpiness(const Vec3& direction, const std::vector<Bump>& bumps) {
  constexpr double reach = 0.6;  // the cosine at which a bump ends
  double sum = 0, weights = 0;
  for (const Bump& bump : bumps) {
    const double height = (dot(direction, bump.direction) - reach) / (1 - reach);
    if (height <= 0) continue;
    sum += bump.height * (height * height);
    weights += height * height;
  }
  return std::clamp(sum / std::max(1.0, weights), -1.0, 1.0);
}

/// A round hill of a landscape.
struct Hill {
  double x, y, reach_squared, height;
};

std::vector<Hill> random_hills(const HeightFieldShape& shape, Random& random) {
  constexpr int count = 16;
  const double width = shape.cells_x * shape.cell, depth = shape.cells_y * shape.cell;
  std::vector<Hill> hills;
  for (int i = 0; i < count; ++i) {
    const double x = random.between(-0.5, 0.5) * width, y = random.between(-0.5, 0.5) * depth;
    const double reach = random.between(0.15, 0.4) * std::max(width, depth);
    hills.push_back({x, y, reach * reach, random.between(0.2, 1)});
  }
  return hills;
}

/// In [0, 1].
double hilliness(double x, double y, const std::vector<Hill>& hills) {
  double sum = 0;
  for (const Hill& hill : hills) {
    const double dx = x - hill.x, dy = y - hill.y;
    const double rise = std::max(0.0, 1 - (dx * dx + dy * dy) / hill.reach_squared);
    sum += hill.height * (rise * rise);
  }
  return sum / (1 + sum);
}

}  // namespace

TriangleMesh noise_sphere_mesh(const NoiseSphereShape& shape) {
  require_range("the radius", shape.radius, 1e-300, 1e300);
  require_range("the roughness", shape.roughness, 0, 0.9);
  Random random(shape.seed);
  const std::vector<Bump> bumps = random_bumps(random);
  SubdividedSphere sphere = subdivided_sphere(shape.subdivisions);
  for (Vec3& v : sphere.directions) v = (shape.radius * (1 + shape.roughness * bumpiness(v, bumps))) * v;
  return {std::move(sphere.directions), std::move(sphere.triangles)};
}

TriangleMesh height_field_mesh(const HeightFieldShape& shape) {
  require_range("the number of cells along x", shape.cells_x, 1, 10000);
  require_range("the number of cells along y", shape.cells_y, 1, 10000);
  require_range("the cell", shape.cell, 1e-100, 1e100);
  require_range("the height", shape.height, 0, 1e100);
  Random random(shape.seed);
  const std::vector<Hill> hills = random_hills(shape, random);
  std::vector<Vec3> vertices;
  for (int j = 0; j <= shape.cells_y; ++j)
    for (int i = 0; i <= shape.cells_x; ++i) {
      const double x = (i - 0.5 * shape.cells_x) * shape.cell, y = (j - 0.5 * shape.cells_y) * shape.cell;
      vertices.push_back({x, y, shape.height * hilliness(x, y, hills)});
    }
  std::vector<std::array<Index, 3>> triangles;
  const Index row = static_cast<Index>(shape.cells_x) + 1;
  for (Index j = 0; j < static_cast<Index>(shape.cells_y); ++j)
    for (Index i = 0; i + 1 < row; ++i) {
      // Split along (i, j)–(i + 1, j + 1), as height fields are (docs/truth.md).
      const Index a = j * row + i, b = a + 1, c = b + row, d = a + row;
      triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
    }
  return {std::move(vertices), std::move(triangles)};
}

}  // namespace toccata
