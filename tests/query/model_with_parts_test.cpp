#include "toccata/query/convex_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

ModelWithParts with_parts(const TriangleMesh& mesh, std::size_t most) {
  const Model model(mesh);
  return ModelWithParts(model, decompose(model, {.max_parts = most}));
}

Pose any_pose(Random& random, double reach) {
  Pose pose;
  for (int row = 0; row < 3; ++row)
    for (int axis = 0; axis < 3; ++axis) pose.linear[row][axis] = random.between(-1, 1);
  for (int axis = 0; axis < 3; ++axis) pose.offset[axis] = random.between(-reach, reach);
  return pose;
}

TEST(ModelWithParts, AnswersAsTheMeshesDoAtManyPoses) {
  const ModelWithParts torus = with_parts(generate_mesh("torus", {{"around", 24}, {"sides", 8}}), 8);
  const ModelWithParts gear = with_parts(generate_mesh("gear"), 6);
  Random random(8);
  int meeting = 0, ruled_out = 0;
  for (int i = 0; i < 200; ++i) {
    const PairQuery query{.pose_a = any_pose(random, 1.5), .pose_b = any_pose(random, 1.5)};
    const bool truth = overlap(torus.model(), gear.model(), query);
    ASSERT_EQ(overlap(torus, gear, query), truth) << i;
    if (parts_are_apart(torus, gear, query)) {
      ASSERT_FALSE(truth) << i;
      ++ruled_out;
    }
    meeting += truth ? 1 : 0;
    ASSERT_EQ(overlap(torus, Model(Box{{0.3, 0.3, 0.3}}), query), overlap(torus.model(), Box{{0.3, 0.3, 0.3}}, query));
  }
  EXPECT_GT(meeting, 20);
  EXPECT_GT(ruled_out, 20);
}

TEST(ModelWithParts, RulesOutNothingThatTouchesAfterRounding) {
  // Two boxes that touch exactly in the world, where the hulls are a unit in the last place larger or smaller.
  const ModelWithParts box = with_parts(box_between({0, 0, 0}, {1, 1, 1}), 4);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double scale = random.between(0.1, 10), at = random.between(-100, 100);
    PairQuery query{.pose_a = scaled(Pose::translation(0, 0, 0), scale),
                    .pose_b = scaled(Pose::translation(0, 0, 0), scale)};
    query.pose_a.offset.x = at;
    query.pose_b.offset.x = scale + at;
    ASSERT_EQ(overlap(box, box, query), overlap(box.model(), box.model(), query));
    ASSERT_FALSE(overlap(box.model(), box.model(), query) && parts_are_apart(box, box, query));
  }
}

/// The least of all pairs of parts, ascending, with no look at any box.
Distance distance_of_every_pair(const Model& a, const Model& b, const PairQuery& query) {
  const auto& compound_a = std::get<Compound>(a.shape());
  const auto& compound_b = std::get<Compound>(b.shape());
  std::optional<Distance> least;
  for (Index i = 0; i < a.parts().size(); ++i)
    for (Index j = 0; j < b.parts().size(); ++j) {
      PairQuery pair = query;
      pair.pose_a = query.pose_a * compound_a.parts()[i].pose;
      pair.pose_b = query.pose_b * compound_b.parts()[j].pose;
      Distance found = distance(a.parts()[i], b.parts()[j], pair);
      found.element_a = found.face_a = i;
      found.element_b = found.face_b = j;
      const double lower = least ? std::fmin(least->lower, found.lower) : found.lower;
      if (!least || found.upper < least->upper) least = found;
      least->lower = lower;
      if (least->upper == 0) return *least;
    }
  return *least;
}

void expect_as_every_pair(const Model& a, const Model& b, const PairQuery& query) {
  const Distance truth = distance_of_every_pair(a, b, query);
  EXPECT_EQ(distance(a, b, query), truth);
  EXPECT_EQ(overlap(a, b, query), truth.upper == 0);
  for (const double tolerance : {0.0, 0.99 * truth.lower, truth.upper, 1.01 * truth.upper}) {
    const bool is_closer = within_distance(a, b, tolerance, query);
    EXPECT_EQ(is_closer, truth.upper <= tolerance) << tolerance;
    const std::optional<Distance> found = distance_within(a, b, tolerance, query);
    ASSERT_EQ(found.has_value(), is_closer) << tolerance;
    if (found) {
      EXPECT_EQ(*found, truth) << tolerance;
    }
  }
}

TEST(ModelWithParts, PartsThatAreNotLookedAtChangeNoAnswer) {
  const ModelWithParts torus = with_parts(generate_mesh("torus", {{"around", 24}, {"sides", 8}}), 8);
  const ModelWithParts gear = with_parts(generate_mesh("gear"), 6);
  // Equally near parts, one of them twice, and shapes without a hull.
  const Pose left = Pose::translation(-1, 0, 0), right = Pose::translation(1, 0, 0);
  const Model plain(Compound(std::vector<CompoundPart>{
      {Box{{0.2, 0.2, 0.2}}, right}, {Sphere{0.3}, left}, {Box{{0.2, 0.2, 0.2}}, left}, {Sphere{0.3}, left}}));
  Random random(21);
  for (int i = 0; i < 24; ++i) {
    PairQuery query{.pose_b = any_pose(random, 0)};
    query.pose_b.offset = {random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
    expect_as_every_pair(torus.parts(), gear.parts(), query);
    expect_as_every_pair(plain, gear.parts(), query);
  }
  for (const Vec3& offset :
       {Vec3{0, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 0.4}, Vec3{0, 0.6, 0}, Vec3{2, 0, 0}, Vec3{1e200, 0, 0}}) {
    PairQuery query;
    query.pose_b.offset = offset;
    expect_as_every_pair(plain, plain, query);
  }
}

TEST(ModelWithParts, RefusesWhatTheMeshRefuses) {
  const ModelWithParts box = with_parts(box_between({0, 0, 0}, {1, 1, 1}), 4);
  PairQuery query;
  query.pose_b = Pose::translation(9, 9, 9);
  query.pose_b.linear[0] = {0, 0, 0};
  EXPECT_THROW(static_cast<void>(overlap(box.model(), box.model(), query)), Error);
  EXPECT_THROW(static_cast<void>(overlap(box, box, query)), Error);
  query.pose_b.linear[0] = {std::nan(""), 0, 0};
  EXPECT_THROW(static_cast<void>(overlap(box, box, query)), Error);
}

}  // namespace
}  // namespace toccata::test
