#include "narrow/triangles/separating_normal.hpp"

#include <array>
#include <tuple>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/triangles/heights_along.hpp"

namespace toccata {
namespace {

/// The least overlap of those that were tried.
class LeastOverlap {
 public:
  LeastOverlap(const Triangle& a, const Triangle& b) : a_(a), b_(b) {}

  void look_along(const Vec3& direction) {
    const Vec3 up = unit_or_zero(direction);
    if (up == Vec3{}) return;
    const HeightsOfTriangle a = heights_along(up, a_), b = heights_along(up, b_);
    keep(b.high - a.low, up);
    keep(a.high - b.low, Vec3{} - up);
  }

  [[nodiscard]] const Vec3& direction() const { return direction_; }

 private:
  void keep(double overlap, const Vec3& direction) {
    if (!(overlap < least_)) return;
    least_ = overlap;
    direction_ = direction;
  }

  const Triangle& a_;
  const Triangle& b_;
  double least_ = infinity;
  Vec3 direction_{};
};

bool comes_first(const Triangle& a, const Triangle& b) {
  const auto coordinates = [](const Triangle& t) {
    return std::tie(t.vertex[0].x, t.vertex[0].y, t.vertex[0].z, t.vertex[1].x, t.vertex[1].y, t.vertex[1].z,
                    t.vertex[2].x, t.vertex[2].y, t.vertex[2].z);
  };
  return coordinates(a) < coordinates(b);
}

}  // namespace

Vec3 separating_normal(const Triangle& a, const Triangle& b) {
  if (comes_first(b, a)) return Vec3{} - separating_normal(b, a);
  const std::array edges_a{a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const std::array edges_b{b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  LeastOverlap least(a, b);
  least.look_along(cross(edges_a[0], edges_a[1]));
  least.look_along(cross(edges_b[0], edges_b[1]));
  for (const Vec3& of_a : edges_a)
    for (const Vec3& of_b : edges_b) least.look_along(cross(of_a, of_b));
  return least.direction();
}

}  // namespace toccata
