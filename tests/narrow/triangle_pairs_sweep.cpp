#include <algorithm>
#include <cmath>
#include <numeric>

#include "narrow/triangle_pairs.hpp"
#include "narrow/triangles/feature_intersection.hpp"
#include "oracle/triangles.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

// Every answer about two triangles, compared with rational arithmetic, with the other methods and with itself under
// exchange and renumbering.
namespace toccata::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;

struct Truth {
  oracle::RationalTriangle a;
  oracle::RationalTriangle b;
  oracle::CommonSet common;
};

struct FeaturesOfPoint {
  Feature on_a;
  Feature on_b;
};

Feature to_feature(const oracle::TriangleFeature& f) {
  return {static_cast<FeatureKind>(f.dimension), static_cast<std::uint8_t>(f.index)};
}

bool is_nearest(double rounded, const Rational& value) {
  const auto error = [&](double candidate) { return Rational(abs(oracle::exact(candidate) - value)); };
  const Rational own_error = error(rounded);
  const auto no_better = [&](double candidate) { return !std::isfinite(candidate) || own_error <= error(candidate); };
  return no_better(std::nextafter(rounded, INFINITY)) && no_better(std::nextafter(rounded, -INFINITY));
}

bool is_nearest(const Vec3& rounded, const RationalPoint& p) {
  return is_nearest(rounded.x, p.x) && is_nearest(rounded.y, p.y) && is_nearest(rounded.z, p.z);
}

/// The true extreme points in the order of the meeting's, by what features they lie on; empty if they are not the same.
std::vector<std::size_t> matching(const Intersection& m, const Truth& truth) {
  std::vector<FeaturesOfPoint> features;
  for (const RationalPoint& p : truth.common.extreme_points)
    features.push_back({to_feature(oracle::feature_at(truth.a, p)), to_feature(oracle::feature_at(truth.b, p))});
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < m.count; ++i)
    for (std::size_t k = 0; k < features.size(); ++k)
      if (features[k].on_a == m.points[i].on_a && features[k].on_b == m.points[i].on_b) order.push_back(k);
  return order.size() == m.count ? order : std::vector<std::size_t>{};
}

/// From one point to the next is one step around, always the same way.
bool is_cyclic(const std::vector<std::size_t>& order) {
  const std::size_t count = order.size();
  for (const std::size_t step : {std::size_t{1}, count - 1}) {
    bool all = true;
    for (std::size_t i = 0; i + 1 < count; ++i) all = all && order[i + 1] == (order[i] + step) % count;
    if (all) return true;
  }
  return false;
}

bool is_in_order(const Intersection& m) {
  if (m.count < 2) return true;
  const auto least = std::min_element(m.points.begin(), m.points.begin() + m.count);
  return least == m.points.begin() && (m.count < 3 || m.points[1] < m.points[m.count - 1U]);
}

std::string compare_with_truth(const Intersection& m, const Triangle& a, const Triangle& b, const Truth& truth) {
  if (static_cast<int>(m.kind) != static_cast<int>(truth.common.kind)) return "kind";
  if (m.count != truth.common.extreme_points.size()) return "count";
  if (m.coplanar != truth.common.coplanar) return "coplanar";
  if (m.crossing != truth.common.crossing) return "crossing";
  if (m.count == 0) return m.on_a == Feature{} && m.on_b == Feature{} ? "" : "features of nothing";
  const std::vector<std::size_t> order = matching(m, truth);
  if (order.empty()) return "features of the extreme points";
  if (m.count > 2 && !is_cyclic(order)) return "cyclic order";
  if (!is_in_order(m)) return "first point";
  const RationalPoint middle = oracle::centroid(truth.common.extreme_points);
  if (to_feature(oracle::feature_at(truth.a, middle)) != m.on_a) return "on_a";
  if (to_feature(oracle::feature_at(truth.b, middle)) != m.on_b) return "on_b";
  const IntersectionPoints at = intersection_points(m, a, b);
  for (std::size_t i = 0; i < m.count; ++i)
    if (!is_nearest(at.points[i], truth.common.extreme_points[order[i]])) return "coordinates";
  return "";
}

/// As `intersect` must tell it when vertex i of a is called (i + 1) % 3 instead.
Intersection with_a_renumbered(const Intersection& m) {
  const auto renumbered = [](const Feature& f) {
    return f.kind == FeatureKind::face ? f : Feature{f.kind, static_cast<std::uint8_t>((f.index + 1) % 3)};
  };
  Intersection r = m;
  if (m.count == 0) return r;
  r.on_a = renumbered(m.on_a);
  for (std::size_t i = 0; i < m.count; ++i) r.points[i].on_a = renumbered(m.points[i].on_a);
  return flipped(flipped(r));  // puts the points into their order again
}

std::string compare_with_itself(const Intersection& m, const Triangle& a, const Triangle& b, const Truth& truth) {
  if (flipped(flipped(m)) != m) return "flipped twice";
  if (intersect(b, a) != flipped(m)) return "exchanged";
  if (oracle::dimension(truth.a) == 2 && intersect({{a[2], a[0], a[1]}}, b) != with_a_renumbered(m))
    return "renumbered";
  const IntersectionPoints at = intersection_points(m, a, b);
  const IntersectionPoints exchanged = intersection_points(flipped(m), b, a);
  if (!std::is_permutation(at.points.begin(), at.points.begin() + at.count, exchanged.points.begin()))
    return "coordinates exchanged";
  return "";
}

/// Empty, or what is wrong.
std::string check_triangle_pairs(const TrianglePair& pair) {
  const auto& [a, b] = pair;
  const oracle::RationalTriangle exact_a = oracle::exact(a), exact_b = oracle::exact(b);
  const Truth truth{exact_a, exact_b, oracle::common_set(exact_a, exact_b)};
  const bool overlapping = truth.common.kind != oracle::CommonSetKind::none;
  if (overlap_by_penetration(a, b) != overlapping) return "penetration";
  if (overlap_by_separating_axes(a, b) != overlapping) return "separating axes";
  const Intersection m = intersect(a, b);
  if (feature_intersection(a, b) != m) return "intersection by features";
  const std::string wrong = compare_with_truth(m, a, b, truth);
  return wrong.empty() ? compare_with_itself(m, a, b, truth) : wrong;
}

SweepResult run_triangle_pairs(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(Random(seed).bits() + 1);
  for (; result.cases < cases; ++result.cases) {
    const TrianglePair pair = triangle_pair(family, random);
    const std::string wrong = check_triangle_pairs(pair);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure =
          wrong + ", case " + std::to_string(result.cases) + ": a" + to_text(pair.a) + ", b" + to_text(pair.b);
  }
  return result;
}

const bool triangle_pairs_known =
    register_sweep({"triangle-pairs", triangle_pair_families(), 1'000'000, 1000, run_triangle_pairs});

}  // namespace
}  // namespace toccata::test
