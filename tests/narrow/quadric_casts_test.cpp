// Casts of cylinders, cones and ellipsoids that are asked for what is met until a limit.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/vec3_measures.hpp"
#include "narrow/quadric_cases.hpp"
#include "narrow/quadrics/casts/quadric_cast_until.hpp"

namespace toccata::test {
namespace {

constexpr std::uint64_t limits_seed = 20261123;

/// Towards the other one, past it, or away.
Vec3 random_way(const Pose& a, const Pose& b, Random& random) {
  const Vec3 between = b.offset - a.offset;
  const double size = largest_magnitude(between);
  return random.between(-0.5, 2) * between + random.between(0, 0.5) * size * quadric_direction(random);
}

/// A limit before the first time makes the cast nothing, and one after it changes no bit.
template <class A, class B>
std::string limit_fault(const A& a, const Vec3& way, const B& b) {
  const std::optional<Cast> whole = cast_shape(a, way, b);
  const auto until = [&](double limit) { return cast_shape_until(a, way, b, limit); };
  if (!whole) return until(1) || until(0.5) ? "met until a limit, but not at all" : "";
  for (const double limit : {1.0, whole->upper, whole->lower})
    if (until(limit) != whole) return fmt::format("another cast with the limit {}", limit);
  if (whole->lower > 0 && until(whole->lower * (1 - 1e-9))) return "told, though it is later than the limit";
  return "";
}

template <class A, class B>
std::string bound_fault(const A& a, const Vec3& way, const B& b) {
  const std::optional<Cast> whole = cast_shape(a, way, b);
  const double bound = free_until(a, way, b, 1);
  if (bound > 1) return whole ? "proved free, but met" : "";
  if (whole && bound > whole->lower) return fmt::format("free until {}, but met from {} on", bound, whole->lower);
  for (const double limit : {0.25, 0.5}) {
    const double cut = free_until(a, way, b, limit);
    if (cut != bound && !(cut > limit)) return fmt::format("another bound with the limit {}", limit);
  }
  return "";
}

TEST(QuadricCasts, ALimitLeavesOutWhatIsLaterAndChangesNothingElse) {
  std::uint64_t number = 0;
  for (const std::string& kind : quadric_kinds())
    for (const std::string& other : quadric_other_kinds())
      for (int i = 0; i < 6; ++i) {
        const std::string& regime = quadric_regimes()[++number % quadric_regimes().size()];
        Random random(limits_seed + number);
        const QuadricCase pair = quadric_case(kind, other, regime, random);
        const PosedQuadric a = posed(pair.a);
        const std::string fault = std::visit(
            [&](const auto& placed) -> std::string {
              const auto b = posed(placed);
              if constexpr (std::same_as<decltype(b), const PosedHalfSpace>) {
                return "";
              } else {
                const Vec3 way = random_way(pair.a.pose, placed.pose, random);
                if (std::string wrong = limit_fault(a, way, b); !wrong.empty()) return wrong;
                if constexpr (std::same_as<decltype(b), const PosedPolytope>) {
                  for (const std::string& wrong :
                       {bound_fault(a, way, b), bound_fault(b, way, a), limit_fault(b, way, a)})
                    if (!wrong.empty()) return wrong;
                }
                return "";
              }
            },
            pair.b);
        EXPECT_EQ(fault, "") << kind << " at " << other << ", " << regime << ", seed " << limits_seed + number;
      }
}

void expect_time(const PosedQuadric& target, const Vec3& from, const Vec3& way, double time) {
  const std::optional<Cast> cast = cast_ray(from, way, target);
  ASSERT_TRUE(cast);
  EXPECT_LE(cast->lower, time);
  EXPECT_GE(cast->upper, time);
  EXPECT_LE(cast->upper - cast->lower, 0x1p-40);
  EXPECT_EQ(cast->status, Status::exact);
}

TEST(QuadricCasts, RaysAlongAxesAndAcrossThemMeetCapsAndSidesAtTheirTimes) {
  for (const bool mirrored : {false, true}) {
    Pose place = Pose::translation(3, 4, 5);
    place.linear[2].z = mirrored ? -1 : 1;
    const PosedQuadric can(Cylinder(1, 2), place), cone(Cone(1, 2), place), egg(Ellipsoid({1, 1, 2}), place);
    const double tip = mirrored ? -1 : 1;
    expect_time(can, {3, 4, 9}, {0, 0, -4}, 0.5);
    expect_time(can, {3.5, 4, 9}, {0, 0, -4}, 0.5);
    expect_time(can, {1, 4, 6}, {4, 0, 0}, 0.25);
    expect_time(egg, {3, 4, 9}, {0, 0, -4}, 0.5);
    expect_time(cone, {3, 4, 5 - 4 * tip}, {0, 0, 4 * tip}, 0.5);
    expect_time(cone, {3.5, 4, 5 + 4 * tip}, {0, 0, -8 * tip}, 0.5);
    expect_time(cone, {1, 4, 5}, {4, 0, 0}, 0.375);
    for (const PosedQuadric* target : {&can, &cone, &egg}) {
      EXPECT_FALSE(cast_ray({4.5, 4, 9}, {0, 0, -9}, *target));      // beside, along the axis
      EXPECT_FALSE(cast_ray({1, 4, 8}, {4, 0, 0}, *target));         // above, across it
      EXPECT_FALSE(cast_ray({3, 4, 9}, {0, 0, 4}, *target));         // away
      EXPECT_FALSE(cast_ray({3, 4, 9}, {0, 0, -1}, *target));        // too short
      EXPECT_EQ(cast_ray({3, 4, 5}, {0, 0, 4}, *target)->upper, 0);  // from within
      EXPECT_TRUE(cast_ray({3, 4, 5}, {4, 0, 0}, *target));
    }
  }
  // Past the tip: the cone that goes on beyond it is none.
  const PosedQuadric cone(Cone(1, 1));
  EXPECT_FALSE(cast_ray({-3, 0, 2}, {6, 0, 0}, cone));
  EXPECT_FALSE(cast_ray({-3, 0, 1.5}, {6, 0, 1e-3}, cone));
  EXPECT_FALSE(cast_ray({0.1, 0, 9}, {0, 0, -7}, cone));
  // From above the tip down into it, and down beside its base.
  expect_time(cone, {0.25, 0, 4.5}, {0, 0, -8}, 0.5);
  EXPECT_FALSE(cast_ray({1.25, 0, 4}, {0, 0, -8}, cone));
}

}  // namespace
}  // namespace toccata::test
