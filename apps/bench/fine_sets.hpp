#pragma once

#include "convex_library.hpp"
#include "oracle/quadrics.hpp"

// Posed shapes with 60 digits, and how deep they overlap.
namespace toccata::bench {

oracle::FineSet fine_set_of(const PosedPolytope& shape);
oracle::FineSet fine_set_of(const PosedQuadric& shape);
oracle::FineSet fine_set_of(const ConvexBody& body, const Pose& pose);

/// Heights of A − B with 60 digits, of which the least is the depth.
class FineHeights {
 public:
  FineHeights(const oracle::FineSet& a, const oracle::FineSet& b) : a_(a), b_(b) {}

  [[nodiscard]] oracle::Fine along(const Vec3& d) const;

  /// The least that is found from directions all over the sphere, by ever smaller steps from the lowest of them.
  [[nodiscard]] oracle::Fine least() const;

 private:
  [[nodiscard]] oracle::Fine least_from(oracle::Fine lowest, Vec3 d) const;

  const oracle::FineSet& a_;
  const oracle::FineSet& b_;
};

}  // namespace toccata::bench
