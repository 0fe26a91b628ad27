#include "narrow/exact/nearest_formula.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

// Errors are in units of u = 2^-53. World vertices are exact; a difference x of two of them is off by u|x|. Bounds are
// of first order and rounded up by some per cent: terms of second order are 2^-20 of them at most, as `nearly` asks,
// and computing a bound takes less than fifty roundings. Lengths are between 2^-100 and 2^100 and squares of areas not
// less than 2^-400, so that what underflow takes, at most 2^-1074 times a few lengths, is less than 2^-300 of any
// bound.
constexpr double u = 0x1p-53;

bool in_range(double least_squared_length, double greatest_squared_length) {
  return least_squared_length >= 0x1p-200 && greatest_squared_length <= 0x1p200;
}

/// An error is small enough for its square to be left aside.
bool nearly(double relative_error) { return relative_error <= 0x1p-20; }

/// Exact arithmetic does better there: distances along an axis are often doubles.
bool is_along_axis(const Vec3& v) {
  return static_cast<int>(v.x == 0) + static_cast<int>(v.y == 0) + static_cast<int>(v.z == 0) > 1;
}

struct DistinctVertices {
  std::array<Index, 3> vertex{};
  std::size_t count = 0;
};

/// Of up to three vertices, in ascending order, each once; without branches that none could foresee. The rest of the
/// three is left as 0.
DistinctVertices distinct(const std::array<Index, 4>& vertices, std::size_t size) {
  const Index x = vertices[0], y = size > 1 ? vertices[1] : x, z = size > 2 ? vertices[2] : x;
  const Index low = std::min(x, y), high = std::max(x, y);
  const Index least = std::min(low, z), middle = std::max(low, std::min(high, z)), greatest = std::max(high, z);
  const bool two = middle != least, three = greatest != middle;
  const Index second = two ? middle : three ? greatest : 0;
  return {{least, second, two && three ? greatest : 0}, std::size_t{1} + (two ? 1 : 0) + (three ? 1 : 0)};
}

/// The interval around a gap that is off by at most `error`.
std::optional<Distance> interval(double gap, double error, const Vec3& on_a, const Vec3& on_b) {
  if (!(error <= 0.45e-12 * gap)) return {};
  const double off = 1.0625 * error + 4 * u * gap;
  return Distance{gap - off, gap + off, on_a, on_b, Status::exact};
}

constexpr Index most_close = 12;

}  // namespace

std::optional<NearestFeatures> canonical_features(const VertexPairs& simplex) {
  if (simplex.size == 0 || simplex.size > 3) return {};
  const DistinctVertices a = distinct(simplex.a, simplex.size), b = distinct(simplex.b, simplex.size);
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
  return NearestFeatures{distinct(a, count_a).vertex, distinct(b, count_b).vertex, count_a, count_b};
}

FeaturePoints points_of(const NearestFeatures& features, const SupportSearch& a, const SupportSearch& b) {
  FeaturePoints points;
  for (std::size_t i = 0; i < features.count_a; ++i) points.a[i] = a.vertex(features.a[i]);
  for (std::size_t i = 0; i < features.count_b; ++i) points.b[i] = b.vertex(features.b[i]);
  return points;
}

NearestFormula::NearestFormula(const NearestFeatures& features, const FeaturePoints& points)
    : features_(features),
      points_(points),
      first_(points.a[0] - points.b[0]),
      edges_(features.count_a + features.count_b - 2) {}

bool NearestFormula::solve() {
  const bool solved = edges_ == 2 ? on_plane() : edges_ == 1 ? on_edge() : at_vertices();
  return solved && !is_along_axis(nearest_.difference);
}

bool NearestFormula::at_vertices() {
  const double squared = dot(first_, first_);
  if (!in_range(squared, squared)) return false;
  const double distance = std::sqrt(squared);
  nearest_ = {points_.a[0], points_.b[0], 0, first_, 2 * u * distance, distance, 4 * u * distance};
  across_ = first_;
  slack_ = 2 * u * distance;
  return true;
}

/// The share t = −first · e / e · e is off by 12u |first| / |e|. What that moves the difference by lies along the edge,
/// across the difference: its length changes in second order only. `other` is what rounds apart from that.
bool NearestFormula::on_edge() {
  const Vec3 way = along(0);
  const double squared = dot(way, way), first_squared = dot(first_, first_);
  if (!in_range(std::min(squared, first_squared), std::max(squared, first_squared))) return false;
  const double share = -dot(first_, way) / squared;
  const double length = std::sqrt(squared), first_length = std::sqrt(first_squared);
  const double share_error = 13 * u * (first_length / length);
  if (!(share > share_error && 1 - share > share_error + 2 * u)) return false;
  const Vec3 moved = share * way, difference = first_ + moved;
  const double distance = std::sqrt(dot(difference, difference));
  const double other = 1.25 * u * (first_length + 2 * length + distance), aside = 1.0625 * share_error * length;
  if (!(distance >= 0x1p-100) || !nearly((aside + other) / distance)) return false;
  const bool of_a = features_.count_a == 2;
  nearest_ = {of_a ? points_.a[0] + moved : points_.a[0],
              of_a ? points_.b[0] : points_.b[0] - moved,
              aside,
              difference,
              1.0625 * (aside + other),
              distance,
              other + aside * (aside / distance) + 5 * u * distance};
  across_ = difference;
  slack_ = nearest_.difference_error;
  return true;
}

/// With the normal n = e × f of the edges and the height h = n · first, the difference is (h / n · n) n. As a vector, n
/// is off by 6u |e||f|, and h is by 11u |e||f||first|. The shares of e and f, (f × first) · n and (first × e) · n, are
/// in units of n · n, and off by 16u |first||e||f| times |f| and |e|.
bool NearestFormula::on_plane() {
  const Vec3 e = along(0), f = along(1), normal = cross(e, f);
  const double e_squared = dot(e, e), f_squared = dot(f, f), first_squared = dot(first_, first_);
  const double squared = dot(normal, normal), height = dot(normal, first_);
  const double longest_squared = std::max(e_squared, f_squared);
  if (!in_range(std::min(std::min(e_squared, f_squared), first_squared), std::max(longest_squared, first_squared)) ||
      !(squared >= 0x1p-400))
    return false;
  const double area = std::sqrt(e_squared * f_squared), longest = std::sqrt(longest_squared);
  const double first_length = std::sqrt(first_squared), normal_length = std::sqrt(squared);
  const double skew = area / normal_length;

  const double share_e = dot(cross(f, first_), normal), share_f = dot(cross(first_, e), normal);
  const double share_off = 17 * u * (first_length * area) * longest;
  const bool two_edges = features_.count_a == 2;
  const double rest = two_edges ? squared - std::max(share_e, share_f) : (squared - share_e) - share_f;
  // n · n is off by 12u skew of itself, and rounds.
  const double rest_off = 2.125 * share_off + (13 * skew + 8) * u * squared;
  if (!(std::min(share_e, share_f) > share_off && rest > rest_off)) return false;

  const double height_off = 11 * u * (area * first_length) / std::fabs(height), normal_off = 6 * u * skew;
  if (!nearly(height_off + 2 * normal_off)) return false;  // NaN included
  const double distance = std::fabs(height) / normal_length, inverse = 1 / squared;
  const Vec3 difference = (height * inverse) * normal;
  nearest_.difference = difference;
  nearest_.difference_error = 1.0625 * distance * (height_off + 3 * normal_off + 9 * u);
  nearest_.distance = distance;
  nearest_.distance_error = 1.0625 * distance * (height_off + normal_off + 6 * u);
  if (two_edges) {
    nearest_.on_a = points_.a[0] + (share_e * inverse) * e;
    nearest_.on_b = points_.b[0] - (share_f * inverse) * f;
    nearest_.point_error = 1.0625 * u * (17 * first_length * skew * skew + longest * (13 * skew + 10));
  } else {
    const bool of_a = features_.count_a == 3;
    nearest_.on_a = of_a ? points_.b[0] + difference : points_.a[0];
    nearest_.on_b = of_a ? points_.b[0] : points_.a[0] - difference;
    nearest_.point_error = nearest_.difference_error;
  }
  across_ = height > 0 ? normal : -normal;
  slack_ = 6 * u * area;
  side_ = height > 0 ? Sign::positive : Sign::negative;
  return true;
}

/// Of a plane: the exact sign of a height along `across_`.
Sign NearestFormula::height_sign(const Difference& vector) const {
  return side_ * triple_product_sign(edge(0), edge(1), vector);
}

/// All vertices of the shapes but those of the features lie beyond the planes through the features.
bool NearestFormula::others_beyond(const SupportSearch& a, const SupportSearch& b) {
  if (!in_certain_range(across_)) return false;
  std::array<Index, most_close> close_a, close_b;
  const Index count_a =
      a.close(across_, slack_, points_.a[0], std::span(features_.a).first(features_.count_a), close_a);
  const Index count_b =
      b.close(-across_, slack_, points_.b[0], std::span(features_.b).first(features_.count_b), close_b);
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
  const double reach = radius_a + radius_b;
  const Vec3 &on_a = nearest_.on_a, &on_b = nearest_.on_b;
  // What either point is off by, apart from roundings of coordinates of the shapes; the promise is about a greatest
  // coordinate that is at least each of these.
  const double turned = reach == 0 ? 0 : 2.125 * (nearest_.difference_error / nearest_.distance) + 8 * u;
  const double off = nearest_.point_error + turned * std::max(radius_a, radius_b);
  const double size =
      std::max(std::max(largest_magnitude(on_a), largest_magnitude(on_b)), std::max(radius_a, radius_b));
  if (!(off <= 0.9e-12 * size)) return {};
  if (reach == 0) return interval(nearest_.distance, nearest_.distance_error, on_a, on_b);

  const double gap = nearest_.distance - reach;
  const double error = nearest_.distance_error + 1.0625 * u * (reach + std::fabs(gap));
  if (gap < -error) {
    // From both sides, so that exchanging the shapes does not show.
    const Vec3 from_a = on_a - (radius_a / reach) * nearest_.difference;
    const Vec3 from_b = on_b + (radius_b / reach) * nearest_.difference;
    const Vec3 common = 0.5 * from_a + 0.5 * from_b;
    return Distance{0, 0, common, common, Status::exact};
  }
  return interval(gap, error, on_a - (radius_a / nearest_.distance) * nearest_.difference,
                  on_b + (radius_b / nearest_.distance) * nearest_.difference);
}

}  // namespace toccata
