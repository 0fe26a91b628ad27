#pragma once

#include <optional>
#include <vector>

#include "methods/minkowski/gauss_overlay.hpp"
#include "methods/minkowski/sum_frame.hpp"

namespace toccata {

struct MinkowskiSum::Parts {
  Parts(const PosedPolytope& of_a, const PosedPolytope& of_b, bool negated)
      : a(of_a, false), b(of_b, negated), radius_a(of_a.radius()), radius_b(of_b.radius()), frame(a, b) {}

  SumOperand a;
  SumOperand b;
  double radius_a = 0;
  double radius_b = 0;

  int dimension = 0;
  std::vector<SumVertex> vertices;  ///< points of the operands
  std::vector<SumFaceKind> kinds;
  std::vector<std::array<PlaneVector, 2>> planes;  ///< of each face
  std::vector<Index> face_start, origin, twin, face, leaving;

  SumFrame frame;
  std::optional<ConvexHull> rounded_core;  ///< of a sum with a radius: the hull of the rounded vertices

  [[nodiscard]] HullTopology topology() const { return {face_start, origin, twin, face, leaving}; }
  [[nodiscard]] Vec3 rounded_vertex(Index i) const {
    return a.points()[vertices[i].on_a] + b.points()[vertices[i].on_b];
  }
  [[nodiscard]] Difference difference_of(const PlaneVector& v) const {
    const auto points = v.of_b ? b.points() : a.points();
    return {points[v.head], points[v.tail]};
  }
};

using SumParts = MinkowskiSum::Parts;

}  // namespace toccata
