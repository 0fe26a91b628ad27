#include "narrow/exact/nearest_formula.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/vec3_measures.hpp"
#include "narrow/exact/distinct_vertices.hpp"

namespace toccata {
namespace {

/// The distinct ones of up to three vertices, in ascending order, each once; without branches that none could foresee.
/// The rest of the three is left as 0.
DistinctVertices distinct_ascending(const std::array<Index, 4>& vertices, std::size_t size) {
  const Index x = vertices[0], y = size > 1 ? vertices[1] : x, z = size > 2 ? vertices[2] : x;
  const Index low = std::min(x, y), high = std::max(x, y);
  const Index least = std::min(low, z), middle = std::max(low, std::min(high, z)), greatest = std::max(high, z);
  const bool two = middle != least, three = greatest != middle;
  const Index second = two ? middle : three ? greatest : 0;
  return {{least, second, two && three ? greatest : 0}, std::size_t{1} + (two ? 1 : 0) + (three ? 1 : 0)};
}

constexpr Index most_close = 12;

}  // namespace

std::optional<NearestFeatures> canonical_features(const VertexPairs& simplex) {
  if (simplex.size == 0 || simplex.size > 3) return {};
  const DistinctVertices a = distinct_ascending(simplex.a, simplex.size),
                         b = distinct_ascending(simplex.b, simplex.size);
  if (a.count + b.count > 4) return {};
  return NearestFeatures{a.vertex, b.vertex, a.count, b.count};
}

std::optional<NearestFeatures> exchanged(const NearestFeatures& features, std::size_t i, const VertexBefore& before) {
  std::array<Index, 4> a{}, b{};
  std::size_t count_a = 0, count_b = 0;
  for (std::size_t k = 0; k < features.count_a; ++k)
    if (k != i) a[count_a++] = features.a[k];
  for (std::size_t k = 0; k < features.count_b; ++k)
    if (features.count_a + k != i) b[count_b++] = features.b[k];
  if (before.of_a)
    a[count_a++] = before.vertex;
  else
    b[count_b++] = before.vertex;
  if (count_a == 0 || count_b == 0 || count_a > 3 || count_b > 3) return {};
  return NearestFeatures{distinct_ascending(a, count_a).vertex, distinct_ascending(b, count_b).vertex, count_a,
                         count_b};
}

FeaturePoints points_of(const NearestFeatures& features, const SupportSearch& a, const SupportSearch& b) {
  FeaturePoints points;
  for (std::size_t i = 0; i < features.count_a; ++i) points.a[i] = a.vertex(features.a[i]);
  for (std::size_t i = 0; i < features.count_b; ++i) points.b[i] = b.vertex(features.b[i]);
  return points;
}

NearestFormula::NearestFormula(const NearestFeatures& features, const FeaturePoints& points)
    : features_(features), points_(points), edges_(features.count_a + features.count_b - 2) {}

bool NearestFormula::solve() {
  SpreadFeatures spread{points_.a[0], points_.b[0], {}, features_.count_a - 1, features_.count_b - 1};
  for (std::size_t i = 0; i < edges_; ++i) spread.edge[i] = along(i);
  return solve_formula(spread, numbers_);
}

/// For features spread by two edges: the exact sign of a height along `across`.
Sign NearestFormula::height_sign(const Difference& vector) const {
  const Sign side = numbers_.is_turned ? Sign::negative : Sign::positive;
  return side * triple_product_sign(edge(0), edge(1), vector);
}

/// All vertices of the shapes but those of the features lie beyond the planes through the features.
bool NearestFormula::others_beyond(const SupportSearch& a, const SupportSearch& b) {
  const Vec3& across = numbers_.across;
  if (!in_certain_range(across)) return false;
  std::array<Index, most_close> close_a, close_b;
  const Index count_a =
      a.close(across, numbers_.slack, points_.a[0], std::span(features_.a).first(features_.count_a), close_a);
  const Index count_b =
      b.close(-across, numbers_.slack, points_.b[0], std::span(features_.b).first(features_.count_b), close_b);
  if (count_a + count_b == 0) return true;
  if (count_a > most_close || count_b > most_close || edges_ < 2) return false;
  // What rounding does not tell apart, exact signs do.
  for (const Index i : std::span(close_a).first(count_a))
    if (const Sign sign = height_sign({a.vertex(i), points_.a[0]}); sign != Sign::positive) {
      if (sign == Sign::negative) before_ = {true, i};
      return false;
    }
  for (const Index i : std::span(close_b).first(count_b))
    if (const Sign sign = height_sign({points_.b[0], b.vertex(i)}); sign != Sign::positive) {
      if (sign == Sign::negative) before_ = {false, i};
      return false;
    }
  return true;
}

std::optional<Distance> NearestFormula::distance(double radius_a, double radius_b) const {
  return radius_a + radius_b == 0 ? plain_formula_distance(numbers_.nearest)
                                  : offset_formula_distance(numbers_.nearest, radius_a, radius_b);
}

/// The points are off as those of the cores, and as the difference turns.
std::optional<Distance> offset_formula_distance(FormulaNearest nearest, double radius_a, double radius_b) {
  constexpr double u = formula_unit;
  const double reach = radius_a + radius_b;
  const Vec3 &on_a = nearest.on_a, &on_b = nearest.on_b;
  const double turned = 2.125 * (nearest.difference_error / nearest.distance) + 8 * u;
  const double off = nearest.point_error + turned * std::max(radius_a, radius_b);
  const double size =
      std::max(std::max(largest_magnitude(on_a), largest_magnitude(on_b)), std::max(radius_a, radius_b));
  if (!(off <= 0.9e-12 * size)) return {};

  const double gap = nearest.distance - reach;
  const double error = nearest.distance_error + 1.0625 * u * (reach + std::fabs(gap));
  if (gap < -error) {
    // From both sides, so that exchanging the shapes does not show.
    const Vec3 from_a = on_a - (radius_a / reach) * nearest.difference;
    const Vec3 from_b = on_b + (radius_b / reach) * nearest.difference;
    const Vec3 common = 0.5 * from_a + 0.5 * from_b;
    return Distance{0, 0, common, common, Status::exact};
  }
  return formula_interval(gap, error, on_a - (radius_a / nearest.distance) * nearest.difference,
                          on_b + (radius_b / nearest.distance) * nearest.difference);
}

}  // namespace toccata
