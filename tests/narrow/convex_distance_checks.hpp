#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "narrow/exact/exact_distance.hpp"
#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What a distance of two convex shapes has to be, by the oracle.
namespace toccata::test {

/// Empty when the interval is as narrow as is promised.
inline std::string width_fault(const Distance& d) {
  if (!(d.lower >= 0 && d.lower <= d.upper)) return "no interval";
  if (std::nextafter(d.lower, std::numeric_limits<double>::infinity()) >= d.upper) return "";
  return oracle::exact(d.upper) - oracle::exact(d.lower) <= oracle::exact(1e-12) * oracle::exact(d.upper)
             ? ""
             : "the interval is wide";
}

/// Empty when the interval contains the exact distance, and is narrow enough.
inline std::string interval_fault(const Distance& d, const oracle::Separation& truth) {
  if (truth.overlap()) return d.lower == 0 && d.upper == 0 ? "" : "meeting sets have a distance";
  if (d.upper == 0) return "sets apart have distance 0";
  const double infinity = std::numeric_limits<double>::infinity();
  if (d.lower == 0 && std::nextafter(0.0, infinity) != d.upper) return "sets apart have no distance below";
  if (truth.compare(oracle::exact(d.lower)) < 0) return "lower is too large";
  if (d.upper == infinity) return d.lower == std::numeric_limits<double>::max() ? "" : "infinite without need";
  if (truth.compare(oracle::exact(d.upper)) > 0) return "upper is too small";
  return width_fault(d);
}

inline std::string interval_fault(const Distance& d, const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  return interval_fault(d, oracle::Separation(a, b));
}

/// The greatest magnitude of a coordinate of the sets' vertices, with the radii.
inline oracle::Rational size_of(const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  oracle::Rational size = 0;
  for (const oracle::ConvexSet* set : {&a, &b})
    for (const oracle::RationalPoint& p : set->vertices)
      for (const oracle::Rational& c : {p.x, p.y, p.z}) {
        const oracle::Rational magnitude = (c < 0 ? oracle::Rational(-c) : c) + set->radius;
        if (size < magnitude) size = magnitude;
      }
  return size;
}

/// Empty when the point is on the set but for what a witness may be off by.
inline std::string point_fault(const Vec3& point, const oracle::ConvexSet& set, const oracle::Rational& slack) {
  if (!is_finite(point)) return "a witness is not finite";
  return oracle::compare_distance(oracle::point_set(point), set, slack) <= 0 ? "" : "a witness is not on its shape";
}

/// Empty when both points are on their sets, and as far from each other as the distance says, but for rounding.
inline std::string witness_fault(const Distance& d, const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  const oracle::Rational slack = oracle::exact(1e-12) * size_of(a, b) + oracle::exact(0x1p-1072);
  for (const std::string& fault : {point_fault(d.on_a, a, slack), point_fault(d.on_b, b, slack)})
    if (!fault.empty()) return fault;
  if (d.upper == 0) return d.on_a == d.on_b ? "" : "two common points";
  if (!std::isfinite(d.upper)) return "";
  const oracle::Rational reach = oracle::exact(d.upper) + 2 * slack;
  const oracle::RationalPoint between = oracle::exact(d.on_a) - oracle::exact(d.on_b);
  return oracle::dot(between, between) <= reach * reach ? "" : "the witnesses are farther apart than the shapes";
}

/// Empty when the witnesses are those of exact arithmetic, but for what they may be off by. A common point may be any:
/// `witness_fault` looks whether it is one.
inline std::string exact_witness_fault(const Distance& d, const PosedPolytope& a, const PosedPolytope& b,
                                       const oracle::Rational& size) {
  if (d.upper == 0) return "";
  VertexPairs first;
  first.append(0, 0);
  const ExactNearest nearest = exact_nearest(a, b, first);
  if (nearest.meet) return "";
  const Distance exact = rounded_distance(nearest, a.radius(), b.radius());
  const oracle::Rational slack = oracle::exact(1e-12) * size + oracle::exact(0x1p-1072);
  for (const auto& off :
       {oracle::exact(d.on_a) - oracle::exact(exact.on_a), oracle::exact(d.on_b) - oracle::exact(exact.on_b)})
    if (oracle::dot(off, off) > slack * slack) return "a witness is not the nearest point";
  return "";
}

inline Distance exchanged(const Distance& d) { return {d.lower, d.upper, d.on_b, d.on_a, d.status}; }

/// Empty when both questions, in both orders, are answered as the oracle does.
inline std::string distance_fault(const ConvexCase& pair) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const oracle::Separation truth(set_a, set_b);
  const bool meet = truth.overlap();
  if (overlap(a, b) != meet || overlap(b, a) != meet) return "overlap is wrong";
  const Distance d = distance(a, b);
  if (distance(b, a) != exchanged(d)) return "the order of the arguments shows";
  for (const std::string& fault :
       {interval_fault(d, truth), witness_fault(d, set_a, set_b), exact_witness_fault(d, a, b, size_of(set_a, set_b))})
    if (!fault.empty()) return fault;
  return "";
}

}  // namespace toccata::test
