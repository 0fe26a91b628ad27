#pragma once

#include "oracle/convex.hpp"

namespace toccata::oracle {

/// The set moved.
ConvexSet moved(ConvexSet set, const RationalPoint& by);

/// The sign of (penetration of two solids) − depth, for depth ≥ 0: the length of the shortest translation after which
/// the interiors do not meet, 0 when they do not meet in place. Oracle of penetration brackets: lower is right iff this
/// is ≥ 0 there, upper iff ≤ 0.
///
/// Without radii that is the least distance of the origin to the planes of the facets of A − B, each of which is
/// parallel to a facet of A, one of B, or an edge of each (S. Cameron, R. Culley, 1986); radii add to it. Cores that
/// are apart overlap by what the radii reach further than their distance.
class Depth {
 public:
  Depth(const ConvexSet& a, const ConvexSet& b);
  int compare(const Rational& depth) const;

 private:
  Rational radii_;
  Rational squared_distance_;    ///< of the cores
  Rational squared_core_depth_;  ///< where that is 0
};

int compare_penetration(const ConvexSet& a, const ConvexSet& b, const Rational& depth);
int compare_penetration(const ConvexSet& a, const HalfSpace& b, const Rational& depth);

}  // namespace toccata::oracle
