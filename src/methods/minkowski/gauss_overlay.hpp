#pragma once

#include <vector>

#include "methods/minkowski/sum_operand.hpp"
#include "toccata/methods/minkowski.hpp"

namespace toccata {

/// An edge of one operand that lies in the plane of a facet.
struct PlaneVector {
  bool of_b = false;
  Index head = 0;  ///< points of that operand
  Index tail = 0;
};

/// The facets of a sum, in the order of topology(): each a polygon, counter-clockwise seen from outside.
struct SumFacets {
  std::vector<SumVertex> corners;  ///< points of the operands
  std::vector<Index> first{0};     ///< facet i has the corners [first[i], first[i + 1])
  std::vector<SumFaceKind> kinds;
  std::vector<std::array<PlaneVector, 2>> planes;  ///< whose cross product is the outward normal
  /// The twin of the half-edge that starts at a corner, both by their places; empty where they have to be found.
  std::vector<Index> twins;

  void close(SumFaceKind kind, const PlaneVector& u, const PlaneVector& v) {
    first.push_back(static_cast<Index>(corners.size()));
    kinds.push_back(kind);
    planes.push_back({u, v});
  }
  /// Closes a facet in a face of A, or of B.
  void close_face(const SumOperand& own, Index face, bool of_b, SumFaceKind kind) {
    const auto& [p, q, r] = own.faces()[face].corners;
    close(kind, {of_b, q, p}, {of_b, r, p});
  }
  /// That of an edge of each with the normal ±e × f.
  void add_parallelogram(const SumOperand& a, Index e, const SumOperand& b, Index f, Sign sense);
};

/// None for a sum that is a point or a segment; two for a flat one.
[[nodiscard]] SumFacets overlay(const SumOperand& a, const SumOperand& b);

}  // namespace toccata
