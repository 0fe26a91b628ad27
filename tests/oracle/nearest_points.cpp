#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "oracle/convex.hpp"

// The nearest points of two polytopes: a search in doubles, then the same search in whole numbers from where the first
// one ended, which proves the end or goes on. Whole numbers, because rationals spend their time in common divisors.
namespace toccata::oracle {
namespace {

template <class Number>
struct Vector {
  Number x{}, y{}, z{};
};

template <class Number>
Vector<Number> operator-(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The vertices of two hulls.
template <class Number>
struct Hulls {
  std::vector<Vector<Number>> a;
  std::vector<Vector<Number>> b;
};

/// A vertex of A less one of B.
template <class Number>
struct Corner {
  std::size_t on_a = 0;
  std::size_t on_b = 0;
  Vector<Number> difference{};
};

template <class Number>
using Simplex = std::vector<Corner<Number>>;

/// Corners, and the point nearest to the origin of what they span: the sum of weight · corner / total.
template <class Number>
struct Support {
  Simplex<Number> simplex;
  std::vector<Number> weights;
  Number total = 0;          ///< of the weights
  Vector<Number> nearest{};  ///< times total
};

/// Weights of the point nearest to the origin in the affine hull, by Cramer's rule; not divided by their sum.
template <class Number>
std::vector<Number> weights_of(const Simplex<Number>& s) {
  const auto d = [&](std::size_t i) -> const Vector<Number>& { return s[i].difference; };
  if (s.size() == 1) return {Number(1)};
  if (s.size() == 2) {
    const Vector<Number> edge = d(1) - d(0);
    return {dot(d(1), edge), Number(-dot(d(0), edge))};
  }
  if (s.size() == 3) {
    const Vector<Number> normal = cross(d(1) - d(0), d(2) - d(0));
    return {dot(normal, cross(d(1), d(2))), dot(normal, cross(d(2), d(0))), dot(normal, cross(d(0), d(1)))};
  }
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(d(i), cross(d(j), d(k))); };
  std::vector<Number> weights{volume(1, 2, 3), volume(0, 3, 2), volume(0, 1, 3), volume(0, 2, 1)};
  Number total = weights[0] + weights[1] + weights[2] + weights[3];
  if (total < 0)
    for (Number& w : weights) w = -w;
  return weights;
}

template <class Number>
Support<Number> supported(Simplex<Number> simplex) {
  Support<Number> result{std::move(simplex), {}, 0, {}};
  result.weights = weights_of(result.simplex);
  for (std::size_t i = 0; i < result.simplex.size(); ++i) {
    const Vector<Number>& d = result.simplex[i].difference;
    const Number& w = result.weights[i];
    result.total += w;
    result.nearest = {result.nearest.x + w * d.x, result.nearest.y + w * d.y, result.nearest.z + w * d.z};
  }
  if (result.simplex.size() == 4) result.nearest = {};  // exactly
  return result;
}

/// The nearest point of the affine hull lies in the simplex, between all corners.
template <class Number>
bool is_between(const Support<Number>& support) {
  return support.total > 0 && std::ranges::all_of(support.weights, [](const Number& w) { return w > 0; });
}

/// d · x ≥ |x|² of the nearest point x: d lies no nearer along it.
template <class Number>
bool is_behind(const Vector<Number>& d, const Support<Number>& support) {
  return dot(d, support.nearest) * support.total >= dot(support.nearest, support.nearest);
}

enum class Subsets { all, with_first };

/// The point nearest to the origin of the hull of at most four corners, by trying their subsets. Nothing only in
/// doubles.
template <class Number>
std::optional<Support<Number>> nearest_of_few(const Simplex<Number>& few, Subsets which) {
  const unsigned step = which == Subsets::all ? 1 : 2;
  for (unsigned subset = 1; subset < 1U << few.size(); subset += step) {
    Simplex<Number> chosen;
    for (std::size_t i = 0; i < few.size(); ++i)
      if ((subset >> i & 1U) != 0) chosen.push_back(few[i]);
    Support<Number> candidate = supported(std::move(chosen));
    if (!is_between(candidate)) continue;
    const auto behind = [&](const Corner<Number>& corner) { return is_behind(corner.difference, candidate); };
    if (std::ranges::all_of(few, behind)) return candidate;
  }
  return std::nullopt;
}

/// The corner of A − B that lies farthest against a direction. It is found from A and from B alone, as A − B has far
/// more corners.
template <class Number>
Corner<Number> farthest_against(const Vector<Number>& direction, const Hulls<Number>& hulls) {
  const auto along = [&](const Vector<Number>& v) { return dot(v, direction); };
  const auto on_a = std::ranges::min_element(hulls.a, {}, along);
  const auto on_b = std::ranges::max_element(hulls.b, {}, along);
  return {static_cast<std::size_t>(on_a - hulls.a.begin()), static_cast<std::size_t>(on_b - hulls.b.begin()),
          *on_a - *on_b};
}

template <class Number>
bool is_nearer(const Support<Number>& one, const Support<Number>& other) {
  return dot(one.nearest, one.nearest) * other.total * other.total <
         dot(other.nearest, other.nearest) * one.total * one.total;
}

/// Grows a simplex by the corner that lies farthest against the nearest point found so far, and drops what that point
/// does not need (P. Wolfe, "Finding the nearest point in a polytope", 1976). The distance falls strictly, so it ends:
/// at the nearest point, or in doubles where rounding stops it.
template <class Number>
Support<Number> descended(const Hulls<Number>& hulls, Support<Number> support) {
  while (true) {
    const Corner<Number> farthest = farthest_against(support.nearest, hulls);
    if (is_behind(farthest.difference, support)) return support;
    Simplex<Number> grown{farthest};
    grown.insert(grown.end(), support.simplex.begin(), support.simplex.end());
    std::optional<Support<Number>> next = nearest_of_few(grown, Subsets::with_first);
    if (!next || !is_nearer(*next, support)) return support;
    support = std::move(*next);
  }
}

template <class Number>
Corner<Number> corner(const Hulls<Number>& hulls, std::size_t on_a, std::size_t on_b) {
  return {on_a, on_b, hulls.a[on_a] - hulls.b[on_b]};
}

/// Both hulls moved so that A's first vertex is the origin, and shrunk to about size 1; rounded.
Hulls<double> rounded(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b) {
  const auto moved = [&](const std::vector<RationalPoint>& points) {
    std::vector<Vector<double>> result;
    for (const RationalPoint& p : points) {
      const RationalPoint v = p - a[0];
      result.push_back({v.x.to_double(), v.y.to_double(), v.z.to_double()});
    }
    return result;
  };
  Hulls<double> result{moved(a), moved(b)};
  double size = 0;
  for (const auto* points : {&result.a, &result.b})
    for (const Vector<double>& v : *points) size = std::max({size, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (size == 0) return result;
  for (auto* points : {&result.a, &result.b})
    for (Vector<double>& v : *points) v = {v.x / size, v.y / size, v.z / size};
  return result;
}

/// Coordinates as whole numbers: each is times 2^exponent / denominator.
struct Unit {
  Integer denominator = 1;
  long exponent = 0;
};

Unit common_unit(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b) {
  Unit unit;
  for (const auto* points : {&a, &b})
    for (const RationalPoint& p : *points)
      for (const Rational* c : {&p.x, &p.y, &p.z}) {
        unit.exponent = std::min(unit.exponent, c->exponent());
        if (!c->is_dyadic()) unit.denominator = lcm(unit.denominator, c->denominator());
      }
  return unit;
}

std::vector<Vector<Integer>> whole(const std::vector<RationalPoint>& points, const Unit& unit) {
  const auto of = [&](const Rational& c) {
    const Integer value = shifted(c.numerator(), c.exponent() - unit.exponent);
    return unit.denominator == 1 ? value : Integer(value * (unit.denominator / c.denominator()));
  };
  std::vector<Vector<Integer>> result;
  for (const RationalPoint& p : points) result.push_back({of(p.x), of(p.y), of(p.z)});
  return result;
}

/// Where the search in doubles ends, exactly.
Support<Integer> start(const Hulls<Integer>& hulls, const Simplex<double>& found) {
  Simplex<Integer> few;
  for (const Corner<double>& c : found) few.push_back(corner(hulls, c.on_a, c.on_b));
  Support<Integer> all = supported(few);
  if (is_between(all)) return all;
  std::optional<Support<Integer>> support = nearest_of_few(few, Subsets::all);
  if (!support) throw std::logic_error("oracle: a hull without a nearest point");
  return *support;
}

/// The search with its proof, and what its whole numbers stand for.
struct Found {
  Hulls<Integer> hulls;
  Unit unit;
  Support<Integer> support;
};

Found found(const ConvexSet& a, const ConvexSet& b) {
  const Hulls<double> near = rounded(a.vertices, b.vertices);
  const Simplex<double> simplex = descended(near, supported(Simplex<double>{corner(near, 0, 0)})).simplex;
  const Unit unit = common_unit(a.vertices, b.vertices);
  const Hulls<Integer> hulls{whole(a.vertices, unit), whole(b.vertices, unit)};
  const Support<Integer> support = descended(hulls, start(hulls, simplex));
  if (!is_behind(farthest_against(support.nearest, hulls).difference, support))
    throw std::logic_error("oracle: the distance did not fall");
  return {hulls, unit, support};
}

Rational squared_distance(const Found& result) {
  const Integer length = result.support.total * result.unit.denominator;
  const Integer squared = dot(result.support.nearest, result.support.nearest);
  return Rational(squared, Integer(length * length)).scaled(2 * result.unit.exponent);
}

RationalPoint mean(const std::vector<Vector<Integer>>& points, const Found& result,
                   std::size_t Corner<Integer>::*vertex) {
  Vector<Integer> sum;
  for (std::size_t i = 0; i < result.support.simplex.size(); ++i) {
    const Integer& w = result.support.weights[i];
    const Vector<Integer>& p = points[result.support.simplex[i].*vertex];
    sum = {sum.x + w * p.x, sum.y + w * p.y, sum.z + w * p.z};
  }
  const Integer length = result.support.total * result.unit.denominator;
  const auto of = [&](const Integer& c) { return Rational(c, length).scaled(result.unit.exponent); };
  return {of(sum.x), of(sum.y), of(sum.z)};
}

}  // namespace

NearestPoints nearest_points(const ConvexSet& a, const ConvexSet& b) {
  const Found result = found(a, b);
  return {mean(result.hulls.a, result, &Corner<Integer>::on_a), mean(result.hulls.b, result, &Corner<Integer>::on_b),
          squared_distance(result)};
}

Nearness nearness(const ConvexSet& a, const ConvexSet& b) {
  const Found result = found(a, b);
  return {squared_distance(result), result.support.simplex.size() == 4};
}

Rational squared_distance(const ConvexSet& a, const ConvexSet& b) { return nearness(a, b).squared_distance; }

}  // namespace toccata::oracle
