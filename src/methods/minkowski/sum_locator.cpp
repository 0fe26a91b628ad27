#include "toccata/methods/minkowski.hpp"

#include <cmath>
#include <optional>

#include "methods/minkowski/direction_cells.hpp"
#include "methods/minkowski/sum_side.hpp"
#include "toccata/core/error.hpp"

// Lengths are those of the sum's frame, and R is its reach. The centre lies behind every plane by R / 1024 at least,
// and corners of faces are known up to 2^-50 R: as seen from the centre, up to an angle of 2^-40. The plane through the
// centre and an edge is used where the edge is seen under an angle of 2^-15 or more, so it is off by 2^-24 at most. A
// point that is farther than 2^-25 R from the centre is seen in a direction that is off by less than 2^-23. The cells
// allow for 2^-18. So the face through which the exact direction leaves is among those that are compared; and being
// behind its plane is being inside.
namespace toccata {

struct SumLocator::Parts {
  MinkowskiSum sum;
  Vec3 centre;  ///< in the frame
  std::vector<SumPlane> planes;
  std::optional<DirectionCells> cells;  ///< none: all faces have to be looked at
};

namespace {

Vec3 vertex_in_frame(const MinkowskiSum::Parts& sum, Index i) {
  return sum.frame.local(sum.a.points()[sum.vertices[i].on_a], sum.b.points()[sum.vertices[i].on_b]);
}

Vec3 middle_of(const MinkowskiSum::Parts& sum) {
  Vec3 total;
  for (Index i = 0; i < sum.vertices.size(); ++i) total = total + vertex_in_frame(sum, i);
  return (1.0 / static_cast<double>(sum.vertices.size())) * total;
}

bool is_deep(const SumPlane& plane, const Vec3& centre, double reach) {
  const double depth = plane.height - dot(plane.normal, centre);
  return depth > 0x1p-10 * reach * std::sqrt(dot(plane.normal, plane.normal)) + 4 * plane.error * reach;
}

DirectionCone cone_of(const MinkowskiSum::Parts& sum, Index face, const Vec3& centre) {
  DirectionCone cone;
  for (Index h = sum.face_start[face]; h < sum.face_start[face + 1]; ++h)
    cone.corners.push_back(vertex_in_frame(sum, sum.origin[h]) - centre);
  for (std::size_t i = 0; i < cone.corners.size(); ++i) {
    const Vec3 &p = cone.corners[i], &q = cone.corners[(i + 1) % cone.corners.size()];
    const Vec3 n = cross(p, q);
    const double length = std::sqrt(dot(n, n));
    if (length > 0x1p-15 * std::sqrt(dot(p, p) * dot(q, q))) cone.walls.push_back((1 / length) * n);
  }
  return cone;
}

std::optional<DirectionCells> cells_of(const MinkowskiSum::Parts& sum, std::span<const SumPlane> planes,
                                       const Vec3& centre) {
  if (sum.dimension < 3) return {};
  std::vector<DirectionCone> cones;
  for (Index f = 0; f < planes.size(); ++f) {
    if (!is_deep(planes[f], centre, sum.frame.reach)) return {};
    cones.push_back(cone_of(sum, f, centre));
  }
  return DirectionCells(cones);
}

}  // namespace

SumLocator::SumLocator(const MinkowskiSum& sum) {
  const auto parts = std::make_shared<Parts>(Parts{sum, middle_of(sum.parts()), {}, {}});
  if (sum.dimension() == 3)
    for (Index f = 0; f < sum.topology().face_count(); ++f) parts->planes.push_back(plane_in_frame(sum.parts(), f));
  parts->cells = cells_of(sum.parts(), parts->planes, parts->centre);
  parts_ = parts;
}

Sign SumLocator::side_of(const Vec3& point) const {
  const MinkowskiSum::Parts& sum = parts_->sum.parts();
  const Vec3 q = sum.frame.local(point), direction = q - parts_->centre;
  const double away = sum_of_magnitudes(direction);  // what is not finite is refused there
  if (!parts_->cells || !(away < 0x1p500)) return parts_->sum.side_of(point);
  if (away < 0x1p-25 * sum.frame.reach) return Sign::negative;
  const double size = largest_magnitude(q) + sum.frame.reach;
  Sign side = Sign::negative;
  for (const Index f : parts_->cells->cones_around(direction)) {
    const SumPlane& plane = parts_->planes[f];
    const double height = dot(plane.normal, q) - plane.height, error = plane.error * size;
    if (height < -error) continue;
    const Sign exact = height > error ? Sign::positive : exact_height(sum, f, point);
    if (exact == Sign::positive) return with_radius(sum, exact, point);
    if (exact == Sign::zero) side = Sign::zero;
  }
  return with_radius(sum, side, point);
}

std::size_t SumLocator::memory() const {
  return sizeof(Parts) + parts_->planes.capacity() * sizeof(SumPlane) + (parts_->cells ? parts_->cells->memory() : 0);
}

}  // namespace toccata
