#include "query/decomposition/cell_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "math/vec3_measures.hpp"
#include "query/decomposition/exact_polygon.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

/// The inward half-spaces of a cell.
struct InwardPlane {
  const CutPlane* plane = nullptr;
  int sign = 1;

  [[nodiscard]] RationalPoint normal() const { return Rational(sign) * plane->normal(); }
  [[nodiscard]] Rational height(const RationalPoint& p) const { return sign * plane->height(p); }
};

using ThreePlanes = std::array<InwardPlane, 3>;

/// Where n_i · x = offset_i.
std::optional<RationalPoint> solution(const std::array<RationalPoint, 3>& n, const std::array<Rational, 3>& offsets) {
  const RationalPoint a = cross(n[1], n[2]), b = cross(n[2], n[0]), c = cross(n[0], n[1]);
  const Rational determinant = dot(n[0], a);
  if (determinant == 0) return {};
  return Rational(1 / determinant) * (offsets[0] * a + offsets[1] * b + offsets[2] * c);
}

std::array<RationalPoint, 3> normals_of(const ThreePlanes& three) {
  return {three[0].normal(), three[1].normal(), three[2].normal()};
}

std::optional<RationalPoint> common_point(const ThreePlanes& three) {
  const auto offset = [&](std::size_t i) { return Rational(three[i].sign * three[i].plane->offset()); };
  return solution(normals_of(three), {offset(0), offset(1), offset(2)});
}

/// How far from the corner the surface is that does not go through it. None where that is not certain.
std::optional<double> clearance(const Model& solid, const RationalPoint& corner, const Vec3& rounded) {
  constexpr std::size_t few = 256;
  const Vec3 lower = solid.bounds().lower, upper = solid.bounds().upper;
  const double near = 0x1p-30 * std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
  for (const SurfacePoint& at : nearest_points(rounded, few, solid)) {
    if (at.lower > near) return at.lower;
    const auto& t = solid.mesh().triangles()[at.element];
    const auto v = solid.mesh().vertices();
    if (!contains(std::array{v[t[0]], v[t[1]], v[t[2]]}, corner)) return {};
  }
  return {};
}

/// Near the corner, where the surface is a cone, the cell is as one point of it is: solid or not.
bool is_solid_near(const Model& solid, const RationalPoint& corner, const ThreePlanes& three,
                   std::span<const InwardPlane> cell) {
  const Vec3 rounded = nearest_doubles(corner);
  const std::optional<double> far = clearance(solid, corner, rounded);
  const auto inward = solution(normals_of(three), {Rational(1), Rational(1), Rational(1)});
  if (!far || !inward) return true;
  const Vec3 way = nearest_doubles(*inward);
  const Vec3 sample = rounded + (0.25 * *far / std::sqrt(dot(way, way))) * way;
  if (!is_finite(sample)) return true;
  const bool is_within = std::ranges::all_of(
      cell, [&](const InwardPlane& side) { return side.sign * static_cast<int>(side.plane->side(sample)) > 0; });
  return !is_within || locate(sample, solid).side != Side::outside;
}

bool is_in(const Aabb& box, const RationalPoint& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] < to_rational(box.lower[axis]) || p[axis] > to_rational(box.upper[axis])) return false;
  return true;
}

}  // namespace

std::vector<RationalPoint> solid_corners(const Model& solid, std::span<const CutPlane> planes,
                                         std::span<const CellSide> cell) {
  std::vector<InwardPlane> sides;
  for (const CellSide& side : cell) sides.push_back({&planes[side.plane], side.sign});
  std::vector<RationalPoint> corners;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j)
      for (std::size_t k = j + 1; k < sides.size(); ++k) {
        const ThreePlanes three{sides[i], sides[j], sides[k]};
        const auto corner = common_point(three);
        if (!corner || !is_in(solid.bounds(), *corner)) continue;
        if (!std::ranges::all_of(sides, [&](const InwardPlane& side) { return side.height(*corner) >= 0; })) continue;
        if (is_solid_near(solid, *corner, three, sides)) corners.push_back(*corner);
      }
  return corners;
}

}  // namespace toccata
