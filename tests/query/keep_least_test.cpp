// Where many elements are equally near but for rounding, the exact least of all must lie in the interval that is told,
// and not only that of the element named.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "query/ray_checks.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/distance.hpp"

namespace toccata {
namespace {

/// Boxes turned about the origin: all are equally far from it, but for rounding.
std::vector<CompoundPart> boxes_around_origin(Random& random) {
  std::vector<CompoundPart> parts;
  const Box box({0.25, 0.5, 0.125}, {2, 0.25, 0.0625});
  for (int i = 0; i < 30; ++i) {
    const Vec3 axis{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1) + 2};
    parts.push_back({box, {rotation_about(axis, random.between(0, 360)), {}}});
  }
  return parts;
}

template <class Ask>
double least_lower(const std::vector<CompoundPart>& parts, const Ask& ask) {
  double least = HUGE_VAL;
  for (const CompoundPart& part : parts) least = std::min(least, ask(Model(part.shape), part.pose).lower);
  return least;
}

TEST(KeepLeast, NoPartOfACompoundIsNearerThanTheInterval) {
  const Model ball = Sphere(0.1);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const std::vector<CompoundPart> parts = boxes_around_origin(random);
    const auto from_ball = [&](const Model& model, const Pose& pose) {
      return distance(model, ball, {.pose_a = pose});
    };
    const Distance found = from_ball(Model(Compound(parts)), {});
    ASSERT_EQ(found.lower, least_lower(parts, from_ball)) << "seed " << seed;
    ASSERT_EQ(distance_within(Model(Compound(parts)), ball, found.upper), found) << "seed " << seed;
  }
}

TEST(KeepLeast, NoPartOfACompoundIsMetBeforeTheInterval) {
  const Model ball = Sphere(0.1);
  const Vec3 motion{4, 0.25, 0.125};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    std::vector<CompoundPart> parts;
    for (int i = 0; i < 30; ++i)
      parts.push_back({Box({1, 2, 2}, {4, 0, 0}), {rotation_about(motion, random.between(0, 1e-6)), {}}});
    const auto ray = [&](const Model& model, const Pose& pose) { return *cast_ray({}, motion, model, pose); };
    const auto shape = [&](const Model& model, const Pose& pose) {
      return *cast_shape(ball, motion, model, {.pose_b = pose});
    };
    ASSERT_EQ(ray(Model(Compound(parts)), {}).lower, least_lower(parts, ray)) << "seed " << seed;
    ASSERT_EQ(shape(Model(Compound(parts)), {}).lower, least_lower(parts, shape)) << "seed " << seed;
  }
}

TEST(KeepLeast, NoTriangleIsMetBeforeTheInterval) {
  struct Found {
    const char* family;
    std::uint64_t seed;
  };
  for (const auto& [family, seed] :
       {Found{"at corners", 4244656011794373618U}, {"along edges", 14285111502501585521U}}) {
    Random random(seed);
    const test::RayCase c = test::ray_case(family, random);
    const std::optional<RayHit> hit = cast_ray(c.origin, c.motion, Model(c.mesh), c.pose, Solid::none);
    EXPECT_EQ(test::ray_fault(c, hit), "") << family;
  }
}

}  // namespace
}  // namespace toccata
