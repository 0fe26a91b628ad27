#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/convex.hpp"
#include "oracle/hull_boundary.hpp"
#include "toccata/methods/minkowski.hpp"

// What a Minkowski sum promises, checked in rational arithmetic.
namespace toccata::test {

/// Everything about the operands that the oracle needs.
struct SumTruth {
  std::vector<oracle::RationalPoint> a, b;  ///< world vertices; those of B negated for a difference
  oracle::Rational radius;

  SumTruth(const PosedPolytope& of_a, const PosedPolytope& of_b, bool negated) {
    for (Index i = 0; i < of_a.vertex_count(); ++i) a.push_back(oracle::exact(of_a.vertex(i)));
    for (Index i = 0; i < of_b.vertex_count(); ++i)
      b.push_back(negated ? -oracle::exact(of_b.vertex(i)) : oracle::exact(of_b.vertex(i)));
    radius = oracle::exact(of_a.radius()) + oracle::exact(of_b.radius());
  }
  [[nodiscard]] oracle::RationalPoint at(const SumVertex& pair) const { return a[pair.on_a] + b[pair.on_b]; }
  /// All sums of two vertices.
  [[nodiscard]] std::vector<oracle::RationalPoint> all() const {
    std::vector<oracle::RationalPoint> sums;
    for (const auto& p : a)
      for (const auto& q : b) sums.push_back(p + q);
    return sums;
  }
  /// The height of the sum along a direction is that of the operands, added.
  [[nodiscard]] oracle::Rational support(const oracle::RationalPoint& direction) const {
    const auto greatest = [&](const std::vector<oracle::RationalPoint>& points) {
      oracle::Rational result = dot(points[0], direction);
      for (const auto& p : points) result = std::max(result, dot(p, direction));
      return result;
    };
    return greatest(a) + greatest(b);
  }
};

inline bool is_nearest_double(double value, const oracle::Rational& exact) {
  const auto off = [&](double candidate) {
    const oracle::Rational difference = oracle::exact(candidate) - exact;
    return difference < 0 ? -difference : difference;
  };
  return off(value) <= off(std::nextafter(value, HUGE_VAL)) && off(value) <= off(std::nextafter(value, -HUGE_VAL));
}

/// Six times the volume within triangles.
inline oracle::Rational six_volumes(const oracle::RationalPoint& p, const oracle::RationalPoint& q,
                                    const oracle::RationalPoint& r) {
  return dot(cross(p, q), r);
}

/// A face: a polygon that turns left at every corner, whose plane has the whole sum behind it. Its normal.
inline std::string face_fault(const std::vector<oracle::RationalPoint>& corners, const SumTruth& truth,
                              oracle::RationalPoint& normal) {
  const std::size_t n = corners.size();
  if (n < 3) return "a face of fewer than three corners";
  normal = cross(corners[1] - corners[0], corners[2] - corners[1]);
  for (std::size_t i = 0; i < n; ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % n], &r = corners[(i + 2) % n];
    if (!(dot(cross(q - p, r - q), normal) > 0)) return "a corner that does not turn left";
    if (!(dot(p, normal) == truth.support(normal))) return "a face that does not support the sum";
  }
  return "";
}

/// The boundary is that of the exact sum: closed, of true facets that meet at true edges. (Faces that support the sum
/// and close up cover its boundary; where no two neighbours are parallel, each is a whole facet.)
inline std::string boundary_fault(const MinkowskiSum& sum, const SumTruth& truth) {
  const HullTopology t = sum.topology();
  std::vector<oracle::RationalPoint> normals(t.face_count());
  for (Index f = 0; f < t.face_count(); ++f) {
    std::vector<oracle::RationalPoint> corners;
    for (Index h = t.face_start[f]; h < t.face_start[f + 1]; ++h) corners.push_back(truth.at(sum.pair(t.origin[h])));
    const std::string wrong = face_fault(corners, truth, normals[f]);
    if (!wrong.empty()) return wrong + ", face " + std::to_string(f);
  }
  for (Index h = 0; h < t.origin.size(); ++h) {
    if (t.twin[t.twin[h]] != h || t.origin[t.twin[h]] != t.origin[t.next(h)] || t.target(h) != t.origin[t.next(h)])
      return "a half-edge without its twin: " + std::to_string(h);
    if (sum.dimension() == 3 && is_zero(cross(normals[t.face[h]], normals[t.face[t.twin[h]]])))
      return "neighbours in one plane: " + std::to_string(h);
  }
  if (sum.dimension() == 3 && sum.vertex_count() + t.face_count() != t.origin.size() / 2 + 2) return "Euler's formula";
  return "";
}

/// The vertices are in order, each rounded to nearest, and there are as many dimensions as the sums of vertices span.
inline std::string vertex_fault(const MinkowskiSum& sum, const SumTruth& truth) {
  const HullTopology t = sum.topology();
  for (Index i = 0; i < sum.vertex_count(); ++i) {
    const oracle::RationalPoint p = truth.at(sum.pair(i));
    const Vec3 rounded = sum.vertex(i);
    if (!is_nearest_double(rounded.x, p.x) || !is_nearest_double(rounded.y, p.y) || !is_nearest_double(rounded.z, p.z))
      return "a vertex that is not rounded to nearest: " + std::to_string(i);
    const auto before = [&](const SumVertex& v, const SumVertex& w) {
      return v.on_a != w.on_a ? v.on_a < w.on_a : v.on_b < w.on_b;
    };
    if (i > 0 && !before(sum.pair(i - 1), sum.pair(i))) return "vertices out of order";
    if (sum.dimension() > 0 && t.origin[t.leaving[i]] != i) return "a half-edge that leaves another vertex";
  }
  std::vector<oracle::RationalPoint> spanned;
  for (const auto& p : truth.a) spanned.push_back(p + truth.b[0]);
  for (const auto& q : truth.b) spanned.push_back(truth.a[0] + q);
  if (static_cast<int>(oracle::spanning(spanned).size()) != sum.dimension() + 1) return "the dimension";
  return "";
}

inline std::string sum_fault(const MinkowskiSum& sum, const SumTruth& truth) {
  std::string wrong = vertex_fault(sum, truth);
  if (!wrong.empty()) return wrong;
  if (sum.dimension() >= 2) return boundary_fault(sum, truth);
  if (static_cast<int>(sum.vertex_count()) != sum.dimension() + 1) return "more than the ends";
  if (sum.dimension() == 0) return "";
  const oracle::RationalPoint along = truth.at(sum.pair(1)) - truth.at(sum.pair(0));
  return dot(truth.at(sum.pair(1)), along) == truth.support(along) &&
                 dot(truth.at(sum.pair(0)), -along) == truth.support(-along)
             ? ""
             : "the ends of a segment";
}

/// The slow and obvious way: the hull of all sums of two vertices has the same volume. For small operands.
inline std::string volume_fault(const MinkowskiSum& sum, const SumTruth& truth) {
  const std::vector<oracle::RationalPoint> all = truth.all();
  const std::vector<oracle::RationalPoint> four = oracle::spanning(all);
  if (four.size() < 4) return sum.dimension() == 3 ? "a solid of flat sums" : "";
  oracle::Rational expected, found;
  for (const oracle::BoundaryTriangle& face : oracle::boundary(all, four))
    expected += six_volumes(face.corner[0], face.corner[1], face.corner[2]);
  const HullTopology t = sum.topology();
  for (Index f = 0; f < t.face_count(); ++f) {
    const auto at = [&](Index h) { return truth.at(sum.pair(t.origin[h])); };
    for (Index h = t.face_start[f] + 1; h + 1 < t.face_start[f + 1]; ++h)
      found += six_volumes(at(t.face_start[f]), at(h), at(h + 1));
  }
  return found == expected && found > 0 ? "" : "the volume";
}

inline std::string side_fault(const MinkowskiSum& sum, const oracle::ConvexSet& set, const Vec3& p) {
  const int found = static_cast<int>(sum.side_of(p)), expected = oracle::side_of(oracle::exact(p), set);
  if (found == expected) return "";
  char text[200];
  std::snprintf(text, sizeof text, "the side of (%.17g, %.17g, %.17g) is %d and not %d", p.x, p.y, p.z, expected,
                found);
  return text;
}

}  // namespace toccata::test
