// Every stage of every orientation predicate against rationals.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "math/filter.hpp"
#include "math/orientation_families.hpp"
#include "math/stages.hpp"
#include "oracle/rational.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

using oracle::exact;

Sign sign_of(const oracle::Rational& value) { return static_cast<Sign>(value.sign()); }

/// The filter's claim is stronger than its sign: but for the last rounding, the value is off by no more than the error.
bool agrees(const Filtered& filtered, const oracle::Rational& truth) {
  if (filtered.is_positive() && truth <= 0) return false;
  if (filtered.is_negative() && truth >= 0) return false;
  if (!std::isfinite(filtered.error)) return true;
  const oracle::Rational value = oracle::exact(filtered.value), last_rounding = abs(value) * oracle::exact(0x1p-53);
  return abs(value - truth) <= oracle::exact(filtered.error) + last_rounding;
}

bool agrees(const std::optional<Sign>& sign, Sign truth) { return !sign || *sign == truth; }

/// The stage that is wrong about four points, or nothing.
std::optional<std::string> wrong_stage(const FourPoints& p) {
  const auto& [a, b, c, d] = p;
  const oracle::Rational volume = oracle::orientation(exact(a), exact(b), exact(c), exact(d));
  const Sign truth = sign_of(volume);
  // The edges of the path a, b, c, d span the same determinant, from three different tails.
  const Difference u{b, a}, v{c, b}, w{d, c};
  if (orient3d(a, b, c, d) != truth) return "orient3d";
  if (orient3d(a, c, b, d) != -truth) return "orient3d, b and c exchanged";
  if (triple_product_sign(u, v, w) != truth) return "triple_product_sign";
  if (triple_product_sign(u, v, {w.tail, w.head}) != -truth) return "triple_product_sign, w turned";
  if (!agrees(filtered_orient3d(a, b, c, d), volume)) return "filter";
  if (!agrees(triple_product_sign_by_machine_integers(u, v, w), truth)) return "machine integers";
  if (!agrees(triple_product_sign_by_expansions(u, v, w), truth)) return "expansions";
  if (triple_product_sign_by_integers(u, v, w) != truth) return "integers";
  return std::nullopt;
}

std::optional<std::string> wrong_stage(const ThreePoints& p) {
  const auto& [a, b, c] = p;
  const oracle::Rational area =
      (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) - (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
  const Sign truth = sign_of(area);
  if (orient2d(a, b, c) != truth) return "orient2d";
  if (orient2d(a, c, b) != -truth) return "orient2d, b and c exchanged";
  if (!agrees(filtered_orient2d(a, b, c), area)) return "filter 2d";
  if (!agrees(orient2d_by_machine_integers(a, b, c), truth)) return "machine integers 2d";
  if (!agrees(orient2d_by_expansions(a, b, c), truth)) return "expansions 2d";
  if (orient2d_by_integers(a, b, c) != truth) return "integers 2d";
  return std::nullopt;
}

std::string told(const Vec2& p) { return fmt::format("({:a}, {:a}) ", p.x, p.y); }
std::string told(const Vec3& p) { return fmt::format("({:a}, {:a}, {:a}) ", p.x, p.y, p.z); }

/// Compares `cases` of what `draw` makes of a family's points.
template <typename Draw>
SweepResult compare(const std::string& family, std::uint64_t seed, std::uint64_t cases, Draw draw) {
  SweepResult result;
  for (const OrientationFamily& f : orientation_families()) {
    if (f.name != family) continue;
    Random random(seed);
    for (; result.cases < cases; ++result.cases) {
      const auto points = draw(random, f.draw(random));
      const std::optional<std::string> wrong = wrong_stage(points);
      if (!wrong || result.wrong++ > 0) continue;
      result.first_failure = *wrong + " at ";
      for (const auto& p : points) result.first_failure += told(p);
    }
  }
  return result;
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const OrientationFamily& family : orientation_families()) names.push_back(family.name);
  return names;
}

SweepResult compare_3d(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return compare(family, seed, cases, [](Random&, const FourPoints& points) { return points; });
}

SweepResult compare_2d(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return compare(family, seed, cases, flattened);
}

const bool orientation_known = register_sweep({"orient3d", family_names(), 1'000'000, 500, compare_3d}) &&
                               register_sweep({"orient2d", family_names(), 1'000'000, 500, compare_2d});

}  // namespace
}  // namespace toccata::test
