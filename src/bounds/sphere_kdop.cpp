#include "toccata/bounds/kdop.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "math/wide_integer.hpp"
#include "narrow/exact/exact_distance.hpp"
#include "toccata/core/error.hpp"

// Let h_j be the height of the centre above plane j, scaled by the length of its normal n_j. The nearest point of the
// intersection of planes S is the centre less Σ λ_i n_i, where G λ = h and G_ij = n_i · n_j; the square of its distance
// is h · λ. Where all λ are positive, that is the distance of the intersection of the half-spaces of S, so a lower
// bound of that of the k-DOP; and where the point violates no other plane, it is the distance. A plane that it violates
// is added; among the subsets of S and that plane with positive λ one has a greater distance. Distances grow, so it
// ends. G is a matrix of small integers: all conditions are signs of sums of few small multiples of heights, and of
// products of two such.
namespace toccata {
namespace {

using PlaneNormal = std::array<int, 3>;

constexpr int dot(const PlaneNormal& u, const PlaneNormal& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// Plane 2i is the lower one of slab i, plane 2i + 1 the upper.
template <std::size_t k>
constexpr std::array<PlaneNormal, k> plane_normals() {
  std::array<PlaneNormal, k> planes{};
  constexpr auto normals = kdop_normals<k>();
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int component = static_cast<int>(normals[i][static_cast<int>(axis)]);
      planes[2 * i][axis] = -component;
      planes[2 * i + 1][axis] = component;
    }
  return planes;
}

/// Up to three planes, and for each λ times the determinant of G.
template <class Number>
struct ActivePlanes {
  std::array<std::size_t, 3> plane{};
  std::size_t count = 0;
  std::array<Number, 3> lambda{};
  int determinant = 1;
  Number square{};  ///< of the distance, times the determinant
};

/// Heights in doubles: each is off by at most `error`, and nothing is certain that is not farther from zero than what
/// sums of multiples of them may be off by. Multiples add up to less than 1,000.
struct RoundedHeights {
  using Number = double;
  double error = 0;
  double greatest = 0;  ///< magnitude of a height

  [[nodiscard]] bool positive(double sum) const { return sum > 0x1p12 * error; }
  [[nodiscard]] bool not_positive(double sum) const { return sum < -0x1p12 * error; }
  static double times(int factor, double value) { return factor * value; }
};

struct ExactHeights {
  using Number = WideInteger;
  [[nodiscard]] bool positive(const WideInteger& sum) const { return sum > 0; }
  [[nodiscard]] bool not_positive(const WideInteger& sum) const { return sum <= 0; }
  static WideInteger times(int factor, const WideInteger& value) { return factor * value; }
};

/// The adjugate of G, and the determinant of G; rows beyond `count` are not used.
struct Adjugate {
  std::array<std::array<int, 3>, 3> of{};
  int determinant = 1;
};

Adjugate adjugate_of(const std::array<PlaneNormal, 3>& n, std::size_t count) {
  const auto g = [&](std::size_t i, std::size_t j) { return dot(n[i], n[j]); };
  if (count == 1) return {{{{1, 0, 0}, {}, {}}}, g(0, 0)};
  if (count == 2)
    return {{{{g(1, 1), -g(0, 1), 0}, {-g(0, 1), g(0, 0), 0}, {}}}, g(0, 0) * g(1, 1) - g(0, 1) * g(0, 1)};
  Adjugate result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      result.of[i][j] = g(a, c) * g(b, d) - g(a, d) * g(b, c);
    }
  result.determinant = g(0, 0) * result.of[0][0] + g(0, 1) * result.of[1][0] + g(0, 2) * result.of[2][0];
  return result;
}

/// Solves G λ = h by Cramer's rule; false where the normals are dependent or a λ is not certain to be positive.
template <class Arithmetic, std::size_t k, class Number = typename Arithmetic::Number>
bool solve(const Arithmetic& arithmetic, const std::array<Number, k>& h, ActivePlanes<Number>& s) {
  static constexpr auto normals = plane_normals<k>();
  std::array<PlaneNormal, 3> n{};
  for (std::size_t i = 0; i < s.count; ++i) n[i] = normals[s.plane[i]];
  const Adjugate adjugate = adjugate_of(n, s.count);
  s.determinant = adjugate.determinant;
  if (s.determinant == 0) return false;
  s.square = Number(0);
  for (std::size_t i = 0; i < s.count; ++i) {
    s.lambda[i] = Number(0);
    for (std::size_t j = 0; j < s.count; ++j) s.lambda[i] += Arithmetic::times(adjugate.of[i][j], h[s.plane[j]]);
    if (!arithmetic.positive(s.lambda[i])) return false;
    s.square += s.lambda[i] * h[s.plane[i]];
  }
  return true;
}

/// Among the subsets of the planes and one more that contain this one, that of the greatest distance.
template <class Arithmetic, std::size_t k, class Number = typename Arithmetic::Number>
std::optional<ActivePlanes<Number>> with_plane(const Arithmetic& arithmetic, const std::array<Number, k>& h,
                                               const ActivePlanes<Number>& s, std::size_t added) {
  std::optional<ActivePlanes<Number>> best;
  for (unsigned kept = 0; kept < 1U << s.count; ++kept) {
    if (std::popcount(kept) > 2) continue;
    ActivePlanes<Number> subset;
    subset.plane[subset.count++] = added;
    for (std::size_t i = 0; i < s.count; ++i)
      if ((kept >> i & 1U) != 0) subset.plane[subset.count++] = s.plane[i];
    if (!solve(arithmetic, h, subset)) continue;
    if (!best || subset.square * best->determinant > best->square * subset.determinant) best = subset;
  }
  return best;
}

/// The planes of the nearest point; nothing where rounding leaves a doubt.
template <class Arithmetic, std::size_t k, class Number = typename Arithmetic::Number>
std::optional<ActivePlanes<Number>> nearest(const Arithmetic& arithmetic, const std::array<Number, k>& h,
                                            std::size_t first) {
  static constexpr auto normals = plane_normals<k>();
  std::optional<ActivePlanes<Number>> s = with_plane(arithmetic, h, {}, first);
  for (int step = 0; s && step < 1000; ++step) {
    std::optional<std::size_t> violated;
    Number worst{};
    for (std::size_t j = 0; j < k; ++j) {
      if (std::find(s->plane.begin(), s->plane.begin() + s->count, j) != s->plane.begin() + s->count) continue;
      Number beyond = Arithmetic::times(s->determinant, h[j]);
      for (std::size_t i = 0; i < s->count; ++i)
        beyond -= Arithmetic::times(dot(normals[j], normals[s->plane[i]]), s->lambda[i]);
      if (arithmetic.not_positive(beyond)) continue;
      if (!arithmetic.positive(beyond)) return std::nullopt;
      if (!violated || beyond > worst) worst = beyond, violated = j;
    }
    if (!violated) return s;
    s = with_plane(arithmetic, h, *s, *violated);
  }
  return std::nullopt;
}

/// normal · p − offset for the upper planes, offset − normal · p for the lower ones.
template <class Number, std::size_t k, class Convert>
std::array<Number, k> heights(const Vec3& p, const Kdop<k>& kdop, const Convert& convert) {
  static constexpr auto normals = plane_normals<k>();
  const std::array<Number, 3> at{convert(p.x), convert(p.y), convert(p.z)};
  std::array<Number, k> h;
  for (std::size_t i = 0; i < k / 2; ++i) {
    Number along(0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const int n = normals[2 * i + 1][axis]; n != 0) along += n > 0 ? at[axis] : -at[axis];
    h[2 * i] = convert(kdop.lower[i]) - along;
    h[2 * i + 1] = along - convert(kdop.upper[i]);
  }
  return h;
}

template <std::size_t k>
RoundedHeights arithmetic_of(const Vec3& p, const Kdop<k>& kdop, const std::array<double, k>& h) {
  double size = std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z), bound = 0;
  for (std::size_t i = 0; i < k / 2; ++i) bound = std::max({bound, std::fabs(kdop.lower[i]), std::fabs(kdop.upper[i])});
  RoundedHeights result{0x1p-50 * (size + bound), 0};
  for (const double height : h) result.greatest = std::max(result.greatest, std::fabs(height));
  return result;
}

template <std::size_t k>
int exponent_of(const Vec3& p, const Kdop<k>& kdop, double radius) {
  int exponent = std::min(common_exponent(std::span(&p, 1)), common_exponent({radius}));
  for (std::size_t i = 0; i < k / 2; ++i)
    exponent = std::min(exponent, common_exponent({kdop.lower[i], kdop.upper[i]}));
  return exponent;
}

template <std::size_t k>
std::array<WideInteger, k> exact_heights(const Vec3& p, const Kdop<k>& kdop, int exponent) {
  return heights<WideInteger>(p, kdop, [&](double value) { return scaled_wide(value, exponent); });
}

/// The plane that a point lies beyond by most: of its region, that whose own nearest point is the farthest.
template <class Number, std::size_t k>
std::optional<std::size_t> farthest_plane(const std::array<Number, k>& h) {
  static constexpr auto normals = plane_normals<k>();
  std::optional<std::size_t> best;
  for (std::size_t j = 0; j < k; ++j) {
    if (!(h[j] > 0)) continue;
    const auto is_farther = [&](std::size_t other) {
      return h[j] * h[j] * dot(normals[other], normals[other]) > h[other] * h[other] * dot(normals[j], normals[j]);
    };
    if (!best || is_farther(*best)) best = j;
  }
  return best;
}

template <std::size_t k>
bool overlap_exactly(const PosedSphere& sphere, const Kdop<k>& kdop) {
  const int exponent = exponent_of(sphere.centre, kdop, sphere.radius);
  const auto h = exact_heights(sphere.centre, kdop, exponent);
  const std::optional<std::size_t> first = farthest_plane(h);
  if (!first) return true;
  const auto s = nearest(ExactHeights{}, h, *first);
  const WideInteger radius = scaled_wide(sphere.radius, exponent);
  return s && s->square <= radius * radius * s->determinant;
}

/// The centre, which is outside, and the nearest point, as far from it as the planes tell.
template <std::size_t k>
ExactNearest centre_and_nearest(const Vec3& centre, const ActivePlanes<WideInteger>& s, int exponent) {
  static constexpr auto normals = plane_normals<k>();
  ExactNearest nearest;
  nearest.exponent = exponent;
  for (std::size_t i = 0; i < s.count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) nearest.direction[axis] += normals[s.plane[i]][axis] * s.lambda[i];
  nearest.on_a = {scaled_wide(centre, exponent), 1};
  nearest.on_b = {WideInteger(s.determinant) * nearest.on_a.numerator - nearest.direction, s.determinant};
  nearest.squared_numerator = s.square;
  nearest.squared_denominator = s.determinant;
  return nearest;
}

template <std::size_t k>
std::optional<bool> overlap_fast(const PosedSphere& sphere, const Kdop<k>& kdop) {
  const auto h = heights<double>(sphere.centre, kdop, [](double value) { return value; });
  const RoundedHeights arithmetic = arithmetic_of(sphere.centre, kdop, h);
  if (std::ranges::all_of(h, [&](double height) { return arithmetic.not_positive(height); })) return true;
  const std::optional<std::size_t> first = farthest_plane(h);
  if (!first) return std::nullopt;
  const auto s = nearest(arithmetic, h, *first);
  if (!s) return std::nullopt;
  const double limit = sphere.radius * sphere.radius * s->determinant;
  // λ is off by less than 100 errors and its products with heights by as much times them; products round.
  const double error =
      0x1p12 * arithmetic.error * (arithmetic.greatest + arithmetic.error) + 0x1p-48 * (s->square + limit) + 0x1p-1000;
  if (s->square < limit - error) return true;
  if (s->square > limit + error) return false;
  return std::nullopt;
}

}  // namespace

template <std::size_t k>
std::uint32_t kdop_region(const Vec3& p, const Kdop<k>& kdop) {
  const auto h = heights<double>(p, kdop, [](double value) { return value; });
  const double error = arithmetic_of(p, kdop, h).error;
  const auto code = [](const auto& of, const auto& is_beyond) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < k; ++j) bits |= (is_beyond(of[j]) ? 1U : 0U) << j;
    return bits;
  };
  if (std::ranges::all_of(h, [&](double height) { return std::fabs(height) > error; }))
    return code(h, [](double height) { return height > 0; });
  return code(exact_heights(p, kdop, exponent_of(p, kdop, 0)), [](const WideInteger& height) { return height > 0; });
}

template <std::size_t k>
bool overlap_by_regions(const PosedSphere& sphere, const Kdop<k>& kdop) {
  if (is_empty(kdop)) return false;
  if (const std::optional<bool> quick = overlap_fast(sphere, kdop)) return *quick;
  return overlap_exactly(sphere, kdop);
}

template <std::size_t k>
Distance distance(const PosedSphere& sphere, const Kdop<k>& kdop) {
  if (is_empty(kdop)) throw Error("the k-DOP is empty, and nothing has a distance to it; fit it to something first");
  const Distance inside{0, 0, sphere.centre, sphere.centre, Status::exact};
  const int exponent = exponent_of(sphere.centre, kdop, 0);
  const auto h = exact_heights(sphere.centre, kdop, exponent);
  const std::optional<std::size_t> first = farthest_plane(h);
  if (!first) return inside;
  const auto s = nearest(ExactHeights{}, h, *first);
  if (!s) throw Error("the slabs of the k-DOP have no point in common; fit it to something, or merge such ones");
  return rounded_distance(centre_and_nearest<k>(sphere.centre, *s, exponent), sphere.radius, 0);
}

template std::uint32_t kdop_region(const Vec3&, const Kdop<6>&);
template std::uint32_t kdop_region(const Vec3&, const Kdop<14>&);
template std::uint32_t kdop_region(const Vec3&, const Kdop<18>&);
template std::uint32_t kdop_region(const Vec3&, const Kdop<26>&);
template bool overlap_by_regions(const PosedSphere&, const Kdop<6>&);
template bool overlap_by_regions(const PosedSphere&, const Kdop<14>&);
template bool overlap_by_regions(const PosedSphere&, const Kdop<18>&);
template bool overlap_by_regions(const PosedSphere&, const Kdop<26>&);
template Distance distance(const PosedSphere&, const Kdop<6>&);
template Distance distance(const PosedSphere&, const Kdop<14>&);
template Distance distance(const PosedSphere&, const Kdop<18>&);
template Distance distance(const PosedSphere&, const Kdop<26>&);

}  // namespace toccata
