#pragma once

#include <array>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// What a block of a wide tree holds, seen from afar: moments of its surface around a centre, in the tree's units from
/// its origin (G. Barill, N. G. Dickson, R. Schmidt, D. I. W. Levin, A. Jacobson, "Fast winding numbers for soups and
/// clouds", 2018; here of second order, symmetrised). With n the normal, d = y − centre, integrals over the surface:
struct WindingMoments {
  Vec3 centre;
  std::array<double, 3> first{};   ///< ∫ n
  std::array<double, 6> second{};  ///< ∫ n d, the symmetric part: xx, yy, zz, xy, yz, zx
  std::array<double, 10> third{};  ///< ∫ n d d, likewise: xxx, yyy, zzz, xxy, xxz, yyx, yyz, zzx, zzy, xyz

  Vec3 lean;  ///< ∫ d: about 0

  // Not less than:
  double radius = 0;  ///< the greatest |d|
  double area = 0;
  double spread = 0;     ///< ∫ |d|²
  double size = 0;       ///< of all triangles, the product of two edges: what the area was computed from
  double perimeter = 0;  ///< of all triangles
  double triangles = 0;
  double levels = 0;  ///< of the tree below: the k-th moments are off by at most levels · 2⁻⁴⁶ · size · radiusᵏ
};

/// The moments of every block; none for a tree without blocks.
[[nodiscard]] std::vector<WindingMoments> winding_moments(const WideBvh& tree, const TriangleMesh& mesh);

/// A bracket of the part of the sphere around a point that a surface covers.
struct WindingPart {
  double value = 0;
  double bound = 0;  ///< infinite where the point is too near to tell
};

/// The part covered by what a block holds, seen from a point in the same coordinates. Everything, the point too, may
/// lie up to `off` from where it is said to be. The bound is derived in docs/methods/winding-numbers.md.
[[nodiscard]] WindingPart winding_part(const WindingMoments& moments, const Vec3& point, double off);

}  // namespace toccata
