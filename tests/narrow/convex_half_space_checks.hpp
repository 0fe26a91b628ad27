#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What the answers about a half-space have to be, by the oracle.
namespace toccata::test {

inline std::string relation_fault(const Relation& relation, const oracle::Relation& right) {
  if (static_cast<int>(relation.kind) != static_cast<int>(right.kind)) return "the kind of relation is wrong";
  if (static_cast<int>(relation.containment) != static_cast<int>(right.containment)) return "the containment is wrong";
  return relation.side_unresolved == right.side_unresolved ? "" : "the side is not resolved as it should be";
}

inline std::string half_space_distance_fault(const Distance& d, const oracle::ConvexSet& a,
                                             const oracle::HalfSpace& b) {
  if (oracle::overlap(a, b)) return d.lower == 0 && d.upper == 0 && d.on_a == d.on_b ? "" : "they meet";
  if (d.upper == 0) return "sets apart have distance 0";
  const int below = oracle::compare_distance(a, b, oracle::exact(d.lower));
  if (below < 0) return "lower is too large";
  if (d.lower == d.upper) return below == 0 ? "" : "the distance is no double";
  if (std::nextafter(d.lower, std::numeric_limits<double>::infinity()) != d.upper) return "no neighbours";
  return below > 0 && oracle::compare_distance(a, b, oracle::exact(d.upper)) < 0 ? "" : "not the least interval";
}

/// Both points lie where they should but for the rounding of their coordinates.
inline std::string half_space_witness_fault(const Vec3& on_a, const Vec3& on_b, const oracle::ConvexSet& a,
                                            const PosedHalfSpace& b) {
  const oracle::HalfSpace set = oracle::half_space_set(b.point, b.normal);
  const auto slack = [](const Vec3& p) {
    return oracle::Rational(oracle::exact(std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z)) * oracle::exact(0x1p-52) +
                            oracle::exact(0x1p-1070));
  };
  if (oracle::compare_distance(oracle::point_set(on_a), a, slack(on_a)) > 0) return "on_a is not on A";
  const oracle::Rational height = oracle::height_above(set, oracle::exact(on_b)), reach = slack(on_b);
  if (height * height > reach * reach * oracle::dot(set.normal, set.normal) && height > 0) return "on_b is not on B";
  return "";
}

/// The depth's bracket by the oracle's distance: moved back by it, the shapes touch.
inline std::string half_space_penetration_fault(const Penetration& p, const oracle::ConvexSet& a,
                                                const PosedHalfSpace& b) {
  const oracle::HalfSpace set = oracle::half_space_set(b.point, b.normal);
  const bool deep = oracle::relation(a, set).kind == oracle::RelationKind::overlapping;
  if (!deep) return p.lower == 0 && p.upper == 0 ? "" : "a depth without overlap";
  if (!(p.lower > 0 && p.upper >= p.lower && p.upper - p.lower <= p.upper * 1e-12 + 0x1p-1070)) return "a bad bracket";
  if (std::fabs(dot(p.direction, p.direction) - 1) > 1e-14) return "the direction is not unit";
  const auto moved = [&](const oracle::Rational& depth) {
    oracle::ConvexSet result = a;
    for (oracle::RationalPoint& v : result.vertices) v = v - depth * oracle::exact(p.direction);
    return oracle::relation(result, set).kind;
  };
  if (moved(oracle::exact(p.upper)) == oracle::RelationKind::overlapping) return "the move does not part them";
  if (moved(oracle::exact(p.lower) * (1 - oracle::exact(0x1p-48))) != oracle::RelationKind::overlapping)
    return "a smaller move parts them";
  return half_space_witness_fault(p.on_a, p.on_b, a, b);
}

inline std::string half_space_manifold_fault(const Manifold& m, bool meet) {
  if ((m.count > 0) != meet) return "the manifold is empty though they meet, or the other way round";
  if (m.count == 0) return "";
  if (std::fabs(dot(m.normal, m.normal) - 1) > 1e-14) return "the normal is not unit";
  for (int i = 0; i < m.count; ++i)
    if (!is_finite(m.points[static_cast<std::size_t>(i)].position)) return "a contact is not finite";
  return "";
}

/// Empty when every question is answered as the oracle does.
inline std::string half_space_fault(const HalfSpaceCase& pair) {
  const PosedPolytope a = posed(pair.a);
  const PosedHalfSpace b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a);
  const oracle::HalfSpace set_b = set_of(pair.b);
  const bool meet = oracle::overlap(set_a, set_b);
  if (overlap(a, b) != meet) return "overlap is wrong";
  oracle::Relation right = oracle::relation(set_a, set_b);
  std::string fault;
  if (is_solid(pair.a) == oracle::is_solid(set_a)) fault = relation_fault(relation(a, b), right);
  const Distance d = distance(a, b);
  if (fault.empty()) fault = half_space_distance_fault(d, set_a, set_b);
  if (fault.empty()) fault = half_space_witness_fault(d.on_a, d.on_b, set_a, b);
  if (fault.empty() && is_solid(pair.a) == oracle::is_solid(set_a) && a.solid())
    fault = half_space_penetration_fault(penetration(a, b), set_a, b);
  if (fault.empty()) fault = half_space_manifold_fault(manifold(a, b), meet);
  return fault;
}

}  // namespace toccata::test
