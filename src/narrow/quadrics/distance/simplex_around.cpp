#include "narrow/quadrics/distance/simplex_around.hpp"

#include <algorithm>
#include <array>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/quadric_proof.hpp"

namespace toccata {
namespace {

using FoundCorner = QuadricSearch::Corner;

Vec3 point(const FoundCorner& corner) { return corner.a.point - corner.b.point; }

/// Two apexes and a ring between them, counterclockwise seen from the first apex.
class DoublePyramid {
 public:
  DoublePyramid(const QuadricBody& a, const QuadricBody& b) : a_(a), b_(b) {}

  void put_on_triangle(std::span<const FoundCorner> corner) {
    const Vec3 p = point(corner[0]);
    const Vec3 normal = unit_or_zero(cross(point(corner[1]) - p, point(corner[2]) - p));
    apex_ = {farthest(normal), farthest(-normal)};
    std::ranges::copy(corner, ring_.begin());
    size_ = 3;
  }

  void put_around_edge(std::span<const FoundCorner> corner) {
    apex_ = {corner[1], corner[0]};
    const Vec3 axis = unit_or_zero(point(corner[1]) - point(corner[0])), m = magnitudes(axis);
    const Vec3 other = m.x <= m.y && m.x <= m.z ? Vec3{1, 0, 0} : m.y <= m.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    // Along what is found first and across it, so that slim differences have a ring as well.
    const Vec3 y = unit_or_zero(cross(axis, point(farthest(unit_or_zero(cross(other, axis)))))), x = cross(y, axis);
    // Farthest points are in the order of their directions.
    for (const Vec3& d : {x, y, -x, -y}) ring_[size_++] = farthest(d);
    size_ = static_cast<std::size_t>(
        std::unique(ring_.begin(), ring_.end(),
                    [](const FoundCorner& p, const FoundCorner& q) { return point(p) == point(q); }) -
        ring_.begin());
    if (size_ > 1 && point(ring_[size_ - 1]) == point(ring_[0])) --size_;
  }

  // All triangles turn the same way for the origin: the closed surface goes round it.
  template <class Number>
  [[nodiscard]] bool is_around_origin() const {
    const VectorOf<Number> top = exactly_at<Number>(apex_[0]), bottom = exactly_at<Number>(apex_[1]);
    for (std::size_t i = 0; i < size_; ++i) {
      const VectorOf<Number> p = exactly_at<Number>(ring_[i]), q = exactly_at<Number>(ring_[(i + 1) % size_]);
      if (!volume_from_origin(top, p, q).is_positive() || !volume_from_origin(bottom, q, p).is_positive()) return false;
    }
    return size_ >= 3;
  }

 private:
  [[nodiscard]] FoundCorner farthest(const Vec3& d) const { return {a_.support(d), b_.support(-d), 0}; }

  template <class Number>
  [[nodiscard]] VectorOf<Number> exactly_at(const FoundCorner& corner) const {
    return difference(point_of<Number>(a_, body_point(corner.a)), point_of<Number>(b_, body_point(corner.b)));
  }

  const QuadricBody& a_;
  const QuadricBody& b_;
  std::array<FoundCorner, 2> apex_;
  std::array<FoundCorner, 4> ring_;
  std::size_t size_ = 0;
};

}  // namespace

bool is_surrounded(const QuadricBody& a, const QuadricBody& b, std::span<const FoundCorner> corners) {
  DoublePyramid pyramid(a, b);
  if (corners.size() == 3)
    pyramid.put_on_triangle(corners);
  else if (corners.size() == 2)
    pyramid.put_around_edge(corners);
  else
    return false;
  return pyramid.is_around_origin<BoundedDouble>() || pyramid.is_around_origin<BoundedNumber>();
}

}  // namespace toccata
