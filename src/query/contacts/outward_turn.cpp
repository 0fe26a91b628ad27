#include "query/contacts/outward_turn.hpp"

#include <algorithm>

#include "math/vec3_measures.hpp"
#include "query/contacts/region_depth.hpp"
#include "query/inside/inside_winding.hpp"

namespace toccata {
namespace {

double sign_of_volume(const PosedMesh& mesh) {
  const Aabb& box = mesh.box();
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper, size = box.upper - middle;
  const double unit = std::max({size.x, size.y, size.z});
  const auto seen = [&](const Vec3& v) -> Vec3 {
    return {(v.x - middle.x) / unit, (v.y - middle.y) / unit, (v.z - middle.z) / unit};
  };
  double volume = 0;
  for (Index t = 0; t < mesh.model().element_count(); ++t) {
    const Triangle triangle = mesh.triangle(t);
    volume += dot(seen(triangle[0]), cross(seen(triangle[1]), seen(triangle[2])));
  }
  return volume < 0 ? -1 : 1;
}

}  // namespace

double outward_turn(const PosedMesh& mesh, Index triangle) {
  constexpr double share = 0x1p-20;
  const Triangle t = mesh.triangle(triangle);
  const Vec3 middle = (1.0 / 3) * t[0] + (1.0 / 3) * t[1] + (1.0 / 3) * t[2];
  const Vec3 step = share * largest_magnitude(t[1] - t[0]) * normal_of_any_size(t);
  for (const Vec3& point : {middle - step, middle + step})
    if (const int winding = wind_along(mesh, ExactPoint(point), 0).ahead; winding != 0) return winding < 0 ? -1 : 1;
  return sign_of_volume(mesh);
}

}  // namespace toccata
