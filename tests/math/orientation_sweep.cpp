// Every stage of every orientation predicate against rationals.
#include <cstdio>
#include <optional>

#include "math/filter.hpp"
#include "math/orientation_families.hpp"
#include "math/stages.hpp"
#include "oracle/rational.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

Sign sign_of(const oracle::Rational& value) { return static_cast<Sign>(value.sign()); }

bool agrees(const Filtered& filtered, Sign truth) {
  if (filtered.is_positive()) return truth == Sign::positive;
  if (filtered.is_negative()) return truth == Sign::negative;
  return true;
}

bool agrees(const std::optional<Sign>& sign, Sign truth) { return !sign || *sign == truth; }

/// The stage that is wrong about four points, or nothing.
std::optional<std::string> wrong_stage_3d(const FourPoints& p) {
  const auto& [a, b, c, d] = p;
  const Sign truth =
      sign_of(oracle::orientation(oracle::exact(a), oracle::exact(b), oracle::exact(c), oracle::exact(d)));
  // The edges of the path a, b, c, d span the same determinant, from three different tails.
  const Difference u{b, a}, v{c, b}, w{d, c};
  if (orient3d(a, b, c, d) != truth) return "orient3d";
  if (orient3d(a, c, b, d) != -truth) return "orient3d, b and c exchanged";
  if (triple_product_sign(u, v, w) != truth) return "triple_product_sign";
  if (triple_product_sign(u, v, {w.tail, w.head}) != -truth) return "triple_product_sign, w turned";
  if (!agrees(filtered_orient3d(a, b, c, d), truth)) return "filter";
  if (!agrees(triple_product_sign_by_expansions(u, v, w), truth)) return "expansions";
  if (triple_product_sign_by_integers(u, v, w) != truth) return "integers";
  return std::nullopt;
}

std::optional<std::string> wrong_stage_2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  using oracle::exact;
  const Sign truth = sign_of((exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) -
                             (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x)));
  if (orient2d(a, b, c) != truth) return "orient2d";
  if (orient2d(a, c, b) != -truth) return "orient2d, b and c exchanged";
  if (!agrees(filtered_orient2d(a, b, c), truth)) return "filter 2d";
  if (!agrees(orient2d_by_expansions(a, b, c), truth)) return "expansions 2d";
  if (orient2d_by_integers(a, b, c) != truth) return "integers 2d";
  return std::nullopt;
}

std::optional<std::string> wrong_stage_2d(const FourPoints& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (auto wrong = wrong_stage_2d(drop_axis(p[0], axis), drop_axis(p[1], axis), drop_axis(p[2], axis))) return wrong;
  return std::nullopt;
}

std::string told(const FourPoints& points) {
  std::string text;
  for (const Vec3& p : points) {
    char line[128];
    std::snprintf(line, sizeof line, "(%a, %a, %a) ", p.x, p.y, p.z);
    text += line;
  }
  return text;
}

template <typename WrongStage>
SweepResult compare(const std::string& family, std::uint64_t seed, std::uint64_t cases, WrongStage wrong_stage) {
  SweepResult result;
  for (const OrientationFamily& f : orientation_families()) {
    if (f.name != family) continue;
    Random random(seed);
    for (; result.cases < cases; ++result.cases) {
      const FourPoints points = f.draw(random);
      const std::optional<std::string> wrong = wrong_stage(points);
      if (!wrong) continue;
      if (result.wrong++ == 0) result.first_failure = *wrong + " at " + told(points);
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
  return compare(family, seed, cases, wrong_stage_3d);
}

SweepResult compare_2d(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return compare(family, seed, cases, [](const FourPoints& points) { return wrong_stage_2d(points); });
}

const bool known = register_sweep({"orient3d", family_names(), 1'000'000, 500, compare_3d}) &&
                   register_sweep({"orient2d", family_names(), 1'000'000, 500, compare_2d});

}  // namespace
}  // namespace toccata::test
