#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What a distance of two convex shapes has to be, by the oracle.
namespace toccata::test {

/// Empty when the interval is that of the exact distance, and as narrow as doubles allow.
inline std::string interval_fault(const Distance& d, const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  const int below = oracle::compare_distance(a, b, oracle::exact(d.lower));
  if (oracle::overlap(a, b)) return d.lower == 0 && d.upper == 0 ? "" : "meeting sets have a distance";
  if (d.upper == 0) return "sets apart have distance 0";
  if (below < 0) return "lower is too large";
  if (d.lower == d.upper) return below == 0 ? "" : "the distance is no double";
  if (std::nextafter(d.lower, std::numeric_limits<double>::infinity()) != d.upper)
    return "doubles that are no neighbours";
  if (below == 0) return "the distance is the double below";
  return oracle::compare_distance(a, b, oracle::exact(d.upper)) < 0 ? "" : "upper is too small";
}

/// Empty when the point is on the set but for the rounding of its coordinates.
inline std::string point_fault(const Vec3& point, const oracle::ConvexSet& set) {
  if (!is_finite(point)) return "a witness is not finite";
  const double size = std::fmax(std::fmax(std::fabs(point.x), std::fabs(point.y)), std::fabs(point.z));
  const oracle::Rational slack = oracle::exact(size) * oracle::exact(0x1p-52) + oracle::exact(0x1p-1072);
  return oracle::compare_distance(oracle::point_set(point), set, slack) <= 0 ? "" : "a witness is not on its shape";
}

/// Empty when both points are on their sets, and as far from each other as the distance says, but for rounding.
inline std::string witness_fault(const Distance& d, const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  for (const std::string& fault : {point_fault(d.on_a, a), point_fault(d.on_b, b)})
    if (!fault.empty()) return fault;
  if (d.upper == 0) return d.on_a == d.on_b ? "" : "two common points";
  double size = d.upper;
  for (const Vec3& p : {d.on_a, d.on_b}) size = std::fmax(size, std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
  const oracle::Rational slack = oracle::exact(size) * oracle::exact(0x1p-50) + oracle::exact(0x1p-1060);
  const oracle::Rational reach = oracle::exact(d.upper) + slack;
  const oracle::RationalPoint between = oracle::exact(d.on_a) - oracle::exact(d.on_b);
  return oracle::dot(between, between) <= reach * reach ? "" : "the witnesses are farther apart than the shapes";
}

inline Distance exchanged(const Distance& d) { return {d.lower, d.upper, d.on_b, d.on_a, d.status}; }

/// Empty when both questions, in both orders, are answered as the oracle does.
inline std::string distance_fault(const ConvexCase& pair) {
  const PosedConvex a = posed(pair.a), b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const bool meet = oracle::overlap(set_a, set_b);
  if (overlap(a, b) != meet || overlap(b, a) != meet) return "overlap is wrong";
  const Distance d = distance(a, b);
  if (distance(b, a) != exchanged(d)) return "the order of the arguments shows";
  for (const std::string& fault : {interval_fault(d, set_a, set_b), witness_fault(d, set_a, set_b)})
    if (!fault.empty()) return fault;
  return "";
}

}  // namespace toccata::test
