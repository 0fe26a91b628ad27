#pragma once

#include <optional>
#include <vector>

#include "query/decomposition/cut_plane.hpp"
#include "toccata/core/index.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// A corner of what planes have left of a triangle.
struct ExactCorner {
  RationalPoint point;
  std::optional<Index> plane{};  ///< in which it lies and which made it, by its number; none: a vertex of the triangle
};

/// A triangle or what planes have left of it. Convex.
struct ExactPolygon {
  Index triangle = 0;
  std::vector<ExactCorner> corners;
};

/// A polygon beside a plane.
class PolygonBeside {
 public:
  PolygonBeside(const ExactPolygon& polygon, const CutPlane& plane, Index number);

  [[nodiscard]] bool is_in_front() const { return front_; }  ///< something of it
  [[nodiscard]] bool is_behind() const { return back_; }

  /// What of it lies in front of the plane (`sign` 1) or behind it (−1), the border included.
  [[nodiscard]] ExactPolygon clipped(int sign) const;

 private:
  const ExactPolygon& polygon_;
  Index number_ = 0;
  std::vector<Rational> heights_;
  bool front_ = false;
  bool back_ = false;
};

/// The least box of doubles around the point by its corners: the point itself where it is one.
void append_doubles_around(const RationalPoint& point, std::vector<Vec3>& points);

/// Within the hull or on it. Nothing is in a flat hull.
[[nodiscard]] bool contains(const ConvexHull& hull, const RationalPoint& point);

/// Within the triangle or on its border.
[[nodiscard]] bool contains(const std::array<Vec3, 3>& triangle, const RationalPoint& point);

}  // namespace toccata
