// A cloth falls onto a ball: a mesh that deforms in each step, its tree refitted, contacts and self-contacts.
#include <toccata/toccata.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace toccata;

namespace {

constexpr Index edge = 33;  // vertices along an edge
constexpr double spacing = 2.0 / (edge - 1), thickness = 0.02;

TriangleMesh flat_cloth() {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index row = 0; row < edge; ++row)
    for (Index column = 0; column < edge; ++column) vertices.push_back({column * spacing - 1, row * spacing - 1, 1});
  for (Index row = 0; row + 1 < edge; ++row)
    for (Index column = 0; column + 1 < edge; ++column) {
      const Index corner = row * edge + column;
      triangles.push_back({corner, corner + 1, corner + edge + 1});
      triangles.push_back({corner, corner + edge + 1, corner + edge});
    }
  return TriangleMesh(vertices, triangles);
}

/// Threads keep their length: both ends give way.
void shorten(Vec3& a, Vec3& b, double length) {
  const Vec3 apart = b - a;
  const double now = std::sqrt(dot(apart, apart));
  const Vec3 step = (0.5 * (now - length) / now) * apart;
  a = a + step;
  b = b - step;
}

}  // namespace

int main() {
  const Model ball = Sphere(0.5);
  const TriangleMesh flat = flat_cloth();
  Model cloth(flat);
  std::vector<Vec3> now(flat.vertices().begin(), flat.vertices().end()), before = now;

  int rebuilt = 0;
  for (int step = 1; step <= 90; ++step) {
    for (std::size_t i = 0; i < now.size(); ++i) {  // Verlet
      const Vec3 last = now[i];
      now[i] = now[i] + 0.98 * (now[i] - before[i]) + Vec3{0, 0, -9.81 / 3600};
      before[i] = last;
    }
    for (int pass = 0; pass < 20; ++pass)
      for (Index i = 0; i < edge * edge; ++i) {
        if (i % edge + 1 < edge) shorten(now[i], now[i + 1], spacing);
        if (i / edge + 1 < edge) shorten(now[i], now[i + edge], spacing);
      }
    // Vertices nearer to the ball than the cloth is thick are put back along the way to the nearest point.
    const std::vector<SignedDistance> field = signed_distance_each(now, ball);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (field[i].upper >= thickness) continue;
      const Vec3 out = now[i];  // the ball is around the origin
      now[i] = (0.5 + thickness) / std::sqrt(dot(out, out)) * out;
    }
    if (cloth.deform(now).should_rebuild()) ++rebuilt;  // otherwise the boxes are put around the moved triangles
    if (step % 30 == 0) {
      const Distance gap = distance(cloth, ball);
      std::printf("step %d: %s the ball, %s\n", step,
                  gap.upper == 0           ? "touches"
                  : gap.upper <= thickness ? "lies on"
                                           : "is above",
                  self_overlap(cloth) ? "intersects itself" : "does not intersect itself");
    }
  }
  std::printf("the tree was %s\n", rebuilt > 0 ? "built anew at times" : "only refitted");
  const auto lowest = std::ranges::min_element(now, {}, &Vec3::z);
  std::printf("its lowest corner is %s the ball's centre\n", lowest->z < 0 ? "below" : "above");
}
