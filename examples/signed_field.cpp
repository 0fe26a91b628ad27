// The nearest points of a surface, and the signed distance on a grid: negative inside.
#include <toccata/methods.hpp>
#include <toccata/toccata.hpp>

#include <cstdio>
#include <vector>

using namespace toccata;

int main() {
  const Model stone(noise_sphere_mesh({.radius = 1, .roughness = 0.4, .subdivisions = 4, .seed = 3}));

  // One point: where on the surface is the nearest, on which triangle, and which triangles are next?
  const Vec3 probe{1.5, 0.5, 0};
  const SurfacePoint near = *nearest_point(probe, stone);
  std::printf("nearest: %.4f away at (%.3f, %.3f, %.3f)\n", near.upper, near.point.x, near.point.y, near.point.z);
  std::printf("of the five nearest triangles the last is %.4f away\n", nearest_points(probe, 5, stone).back().upper);
  if (!nearest_point(probe, stone, {.max_distance = 0.1})) std::printf("nothing within 0.1\n");

  // Many points at once, on all cores. The sign is that of the winding number, exact.
  constexpr int width = 49, height = 25;
  std::vector<Vec3> grid;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      grid.push_back({(column - width / 2) / 16.0, 0, (height / 2 - row) / 8.0});
  const std::vector<SignedDistance> field = signed_distance_each(grid, stone);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double d = field[static_cast<std::size_t>(row * width + column)].upper;
      std::putchar(d < -0.4 ? '#' : d < 0 ? '+' : d < 0.2 ? '.' : ' ');
    }
    std::putchar('\n');
  }
}
