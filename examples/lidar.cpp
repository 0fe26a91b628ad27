// A lidar turns in a yard: 64 × 360 rays, the first thing that each hits, and how far away it is.
#include <toccata/methods.hpp>
#include <toccata/toccata.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace toccata;

int main() {
  std::vector<SceneInstance> yard = {
      {.model = HalfSpace({0, 0, 0}, {0, 0, 1}), .name = "ground"},
      {.model = Box({0.2, 10, 1.5}), .pose = Pose::translation(8, 0, 1.5), .name = "wall"},
      {.model = Model(generate_mesh("torus-knot")), .pose = Pose::translation(-4, 3, 1.2), .name = "sculpture"},
      {.model = Cylinder(0.4, 2), .pose = Pose::translation(0, -5, 2), .name = "pillar"},
  };
  const SceneIndex index(yard);

  // A ray is a segment: it ends where the sensor sees no farther. rotation_about has the same bits on every machine.
  constexpr double range = 30;
  const Vec3 sensor{0, 0, 1.5};
  std::vector<Ray> rays;
  for (int row = 0; row < 64; ++row)
    for (int degrees = 0; degrees < 360; ++degrees) {
      const Mat3 tilted = rotation_about({0, 1, 0}, 15 - 0.6 * row), turned = rotation_about({0, 0, 1}, degrees);
      const Vec3 direction = transform({turned, {}}, transform({tilted, {}}, {-1, 0, 0}));
      rays.push_back({sensor, range * direction});
    }

  // On all cores; the answers do not depend on how many there are.
  const std::vector<std::optional<ObjectAnswer<RayHit>>> hits = index.cast_ray_each(rays);

  std::vector<int> count(yard.size());
  std::vector<double> nearest(yard.size(), range);
  int misses = 0;
  for (const std::optional<ObjectAnswer<RayHit>>& hit : hits) {
    if (!hit) {
      ++misses;  // proved: nothing is there
      continue;
    }
    ++count[hit->object];
    nearest[hit->object] = std::min(nearest[hit->object], range * hit->upper);  // times are fractions of the way
  }
  for (std::size_t i = 0; i < yard.size(); ++i)
    std::printf("%-10s %5d rays, the nearest at %.2f\n", yard[i].name.c_str(), count[i], nearest[i]);
  std::printf("%-10s %5d rays\n", "nothing", misses);

  // What lies behind the first thing: one ray through everything.
  for (const ObjectAnswer<RayHit>& hit : index.cast_ray_through({{-10, 0, 1}, {30, 0, -0.5}}))
    std::printf("the test ray enters the %s at x = %.2f\n", yard[hit.object].name.c_str(), hit.point.x);
}
