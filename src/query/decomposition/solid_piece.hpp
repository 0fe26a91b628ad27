#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

// What a search for good cuts looks at: pieces of a solid in rounded numbers. Nothing that is promised rests on it.
namespace toccata {

inline constexpr double flat_height = 0x1p-40;  ///< local heights below this are none

/// All x with normal · x = offset; the normal has length 1.
struct RoundedPlane {
  Vec3 normal;
  double offset = 0;
  [[nodiscard]] double height(const Vec3& x) const { return dot(normal, x) - offset; }
};

using RoundedTriangle = std::array<Vec3, 3>;

/// Triangles in a plane that cut the solid. Their signed sum is the cut; single ones may reach beyond it.
struct PieceCap {
  Index plane = 0;
  std::vector<RoundedTriangle> triangles;
};

/// A segment in which two cuts meet within the solid.
using RoundedSegment = std::array<Vec3, 2>;

/// What of a solid lies in a cell of planes. The surface and the caps together are closed.
struct SolidPiece {
  std::vector<RoundedTriangle> surface;
  std::vector<PieceCap> caps;
  std::vector<RoundedSegment> edges;
  double volume = 0;

  /// The extreme points of the piece are among these.
  [[nodiscard]] std::vector<Vec3> points() const;
};

struct SplitPiece {
  SolidPiece front;  ///< where heights are positive
  SolidPiece back;
};

/// `number` is the plane's. Heights less than `tolerance` are none.
[[nodiscard]] SplitPiece split(const SolidPiece& piece, const RoundedPlane& plane, Index number, double tolerance);

/// The volume of the piece in front of the plane, without splitting it.
[[nodiscard]] double volume_in_front(const SolidPiece& piece, const RoundedPlane& plane);

/// The corners of the part of a triangle in front of the plane; none where it has nothing there but its border.
[[nodiscard]] std::vector<Vec3> part_in_front(const RoundedTriangle& triangle, const RoundedPlane& plane,
                                              double tolerance);

/// From triangles that make up a closed surface.
[[nodiscard]] double enclosed_volume(const SolidPiece& piece);

/// The volume of the convex hull of points; 0 where it is flat.
[[nodiscard]] double hull_volume(std::span<const Vec3> points);

}  // namespace toccata
