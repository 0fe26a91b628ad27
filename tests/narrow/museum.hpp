#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "narrow/convex_distance_checks.hpp"
#include "oracle/penetration.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What the tests of other libraries' failures have in common.
namespace toccata::museum {

inline Pose at(double x, double y, double z) { return Pose::translation(x, y, z); }

inline PosedPolytope cube(double size, const Pose& pose = {}) {
  return PosedPolytope(Box({size / 2, size / 2, size / 2}), pose);
}

inline oracle::ConvexSet set_of(const PosedPolytope& shape) {
  oracle::ConvexSet set;
  for (Index i = 0; i < shape.vertex_count(); ++i) set.vertices.push_back(oracle::exact(shape.vertex(i)));
  set.radius = oracle::exact(shape.radius());
  return set;
}

inline bool is_unit(const Vec3& v) { return std::abs(dot(v, v) - 1) <= 1e-15; }

/// All questions answer, both ways round, and as rational arithmetic does.
inline void expect_right(const PosedPolytope& a, const PosedPolytope& b) {
  const oracle::ConvexSet set_a = set_of(a), set_b = set_of(b);
  const oracle::Relation truth = oracle::relation(set_a, a.solid(), set_b, b.solid());
  const bool meet = truth.kind != oracle::RelationKind::apart;
  EXPECT_EQ(overlap(a, b), meet);
  EXPECT_EQ(overlap(b, a), meet);
  EXPECT_EQ(static_cast<int>(relation(a, b).kind), static_cast<int>(truth.kind));
  EXPECT_EQ(static_cast<int>(relation(a, b).containment), static_cast<int>(truth.containment));
  const Distance d = distance(a, b);
  EXPECT_EQ(test::interval_fault(d, set_a, set_b), "");
  EXPECT_EQ(test::witness_fault(d, set_a, set_b), "");
  EXPECT_EQ(manifold(a, b).count > 0, meet);
  if (!a.solid() || !b.solid()) return;
  const Penetration p = penetration(a, b);
  EXPECT_EQ(p.lower, penetration(b, a).lower);
  EXPECT_EQ(p.upper, penetration(b, a).upper);
  EXPECT_GE(oracle::compare_penetration(set_a, set_b, oracle::exact(p.lower)), 0);
  EXPECT_LE(oracle::compare_penetration(set_a, set_b, oracle::exact(p.upper)), 0);
  EXPECT_TRUE(p.upper == 0 || is_unit(p.direction));
}

}  // namespace toccata::museum
