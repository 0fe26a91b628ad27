#include "fine_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace toccata::bench {

oracle::FineSet fine_set_of(const PosedPolytope& shape) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
  return oracle::hull_set_of(vertices, shape.radius());
}

oracle::FineSet fine_set_of(const PosedQuadric& shape) {
  constexpr oracle::FineKind kinds[] = {oracle::FineKind::cylinder, oracle::FineKind::cone,
                                        oracle::FineKind::ellipsoid};
  return oracle::quadric_set(kinds[static_cast<std::size_t>(shape.kind())], shape.half(), shape.pose());
}

oracle::FineSet fine_set_of(const ConvexBody& body, const Pose& pose) {
  return std::visit([&]<class Shape>(const Shape& shape) { return fine_set_of(PosedAs<Shape>(shape, pose)); }, body);
}

oracle::Fine FineHeights::along(const Vec3& d) const {
  const oracle::FinePoint ahead{d.x, d.y, d.z}, back{-d.x, -d.y, -d.z};
  const oracle::FinePoint p = farthest(a_, ahead), q = farthest(b_, back);
  const oracle::Fine length = sqrt(ahead.x * ahead.x + ahead.y * ahead.y + ahead.z * ahead.z);
  return ((p.x - q.x) * ahead.x + (p.y - q.y) * ahead.y + (p.z - q.z) * ahead.z) / length;
}

oracle::Fine FineHeights::least() const {
  constexpr int count = 200;
  std::vector<std::pair<oracle::Fine, Vec3>> found;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, across = std::sqrt(1 - z * z), turn = 2.399963229728653 * i;
    const Vec3 d{across * std::cos(turn), across * std::sin(turn), z};
    found.emplace_back(along(d), d);
  }
  constexpr std::size_t tried = 4;
  std::ranges::partial_sort(found, found.begin() + tried, {}, [](const auto& one) { return one.first; });
  oracle::Fine lowest = found.front().first;
  for (std::size_t i = 0; i < tried; ++i) lowest = std::min(lowest, least_from(found[i].first, found[i].second));
  return lowest;
}

oracle::Fine FineHeights::least_from(oracle::Fine lowest, Vec3 d) const {
  for (double step = 0.1; step > 1e-9;) {
    const Vec3 before = d;
    for (int axis = 0; axis < 3; ++axis)
      for (const double way : {-step, step}) {
        Vec3 next = d;
        next[axis] += way;
        const oracle::Fine here = along(next);
        if (here < lowest) lowest = here, d = next;
      }
    if (d == before) step /= 2;
  }
  return lowest;
}

}  // namespace toccata::bench
