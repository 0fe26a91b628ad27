#include "narrow/exact/exact_support.hpp"

#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// A product with a rounded direction, and what it may be off by: 2^-53 from the direction, as much from each product,
/// twice from sums. A coordinate of the direction may have underflowed, which the vertex makes larger; the underflow of
/// products is within the floor.
struct Height {
  double value = 0;
  double error = 0;
};

Height height_of(const Vec3& direction, const Vec3& vertex) {
  const double magnitude =
      (std::fabs(direction.x * vertex.x) + std::fabs(direction.y * vertex.y)) + std::fabs(direction.z * vertex.z);
  const double size = (std::fabs(vertex.x) + std::fabs(vertex.y)) + std::fabs(vertex.z);
  return {dot(direction, vertex), 0x1p-50 * magnitude + (0x1p-1070 * size + 0x1p-1020)};
}

/// The vertices that may be the least. Nothing overflows, because the direction's coordinates are at most 1/4.
std::vector<Index> candidates(const PosedPolytope& shape, const Vec3& direction) {
  double bound = infinity;
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Height height = height_of(direction, shape.vertex(i));
    bound = std::fmin(bound, height.value + height.error);
  }
  std::vector<Index> found;
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Height height = height_of(direction, shape.vertex(i));
    if (height.value - height.error <= bound) found.push_back(i);
  }
  return found;
}

}  // namespace

std::vector<Index> least_vertices(const PosedPolytope& shape, const IntegerVector& direction) {
  std::vector<Index> close = candidates(shape, rounded_direction(direction));
  if (close.size() == 1) return close;
  std::vector<Vec3> vertices;
  for (const Index i : close) vertices.push_back(shape.vertex(i));
  const int exponent = common_exponent(vertices);
  std::vector<Index> least;
  WideInteger height;
  for (std::size_t i = 0; i < close.size(); ++i) {
    const WideInteger own = dot(direction, scaled_wide(vertices[i], exponent));
    if (!least.empty() && own > height) continue;
    if (!least.empty() && own < height) least.clear();
    height = own;
    least.push_back(close[i]);
  }
  return least;
}

}  // namespace toccata
