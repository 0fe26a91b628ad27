#include "query/near_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "support/mesh_soups.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

using Pairs = std::vector<ItemPair>;

Shape random_shape_of_part(Random& random) {
  switch (random.below(4)) {
    case 0:
      return Sphere(random.between(0.01, 0.2));
    case 1:
      return Box({random.between(0.01, 0.2), 0.1, 0.05});
    case 2:
      return std::make_shared<const TriangleMesh>(test::random_soup(random, 5, 0.2, 0));
    default:
      return Capsule({0, 0, 0}, test::random_vector(random, 0.2), random.between(0.01, 0.1));
  }
}

Compound random_compound(std::size_t count, double size, Random& random) {
  std::vector<CompoundPart> parts;
  for (std::size_t i = 0; i < count; ++i)
    parts.push_back({random_shape_of_part(random), {test::random_rotation(random), test::random_vector(random, size)}});
  // One in a while has no end.
  if (count > 1 && random.below(4) == 0) parts.back() = {HalfSpace({0, 0, -1.2 * size}, {0, 0, 1}), Pose{}};
  return Compound(parts);
}

Pairs pairs_in_order(const PosedModel& a, const PosedModel& b, double limit) {
  std::vector<std::tuple<double, Index, Index>> all;
  for (Index i = 0; i < a.parts.size(); ++i)
    for (Index j = 0; j < b.parts.size(); ++j) {
      const double gap = gap_of_parts(world_box(a.parts[i].shape), world_box(b.parts[j].shape));
      if (gap <= limit) all.emplace_back(gap, i, j);
    }
  std::sort(all.begin(), all.end());
  Pairs pairs;
  for (const auto& [gap, i, j] : all) pairs.push_back({i, j});
  return pairs;
}

TEST(NearParts, AreAllPairsInTheOrderOfTheirGaps) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const double size = seed % 3 == 0 ? 0.2 : 2;
    const Model a(random_compound(1 + random.below(60), size, random)),
        b(random_compound(1 + random.below(60), size, random));
    const Pose pose{test::random_rotation(random), test::random_vector(random, size)};
    const PosedModel posed_a = pose_model(a, Pose{}, Solid::automatic, "a"),
                     posed_b = pose_model(b, pose, Solid::automatic, "b");
    for (const double limit : {0.0, 0.3, infinity}) {
      SearchScratch scratch;
      NearParts near(posed_a, posed_b, gap_of_parts, limit, scratch);
      Pairs found;
      while (const auto next = near.next(limit)) found.push_back(*next);
      EXPECT_EQ(found, pairs_in_order(posed_a, posed_b, limit)) << seed << ", " << limit;
    }
  }
}

/// Every part by itself against every other: what a question about two compounds has to come to.
template <class See>
void each_pair(const Compound& a, const Compound& b, const PairQuery& query, const See& see) {
  for (const CompoundPart& part_a : a.parts())
    for (const CompoundPart& part_b : b.parts())
      see(Model(Compound({{part_a.shape}})), Model(Compound({{part_b.shape}})),
          PairQuery{query.pose_a * part_a.pose, query.pose_b * part_b.pose});
}

TEST(NearParts, QuestionsAboutCompoundsAreThoseAboutTheirParts) {
  int met = 0, hit = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Compound a = random_compound(1 + random.below(20), 0.7, random),
                   b = random_compound(1 + random.below(20), 0.7, random);
    const PairQuery query{Pose{}, {test::random_rotation(random), {random.between(-3, 3), 0.1, random.between(0, 2)}}};
    const Vec3 motion{query.pose_b.offset.x, random.between(-1, 1), 0};
    const bool half_spaces = std::holds_alternative<HalfSpace>(a.parts().back().shape) &&
                             std::holds_alternative<HalfSpace>(b.parts().back().shape);
    bool meets = false;
    std::size_t contact_count = 0;
    double least = infinity, first = infinity;
    each_pair(a, b, query, [&](const Model& part_a, const Model& part_b, const PairQuery& parts) {
      meets |= overlap(part_a, part_b, parts);
      contact_count += contacts(part_a, part_b, parts).size();
      least = std::min(least, distance(part_a, part_b, parts).upper);
      if (half_spaces) return;
      if (const std::optional<ShapeHit> found = cast_shape(part_a, motion, part_b, parts); found)
        first = std::min(first, found->upper);
    });
    const Model model_a(a), model_b(b);
    EXPECT_EQ(overlap(model_a, model_b, query), meets);
    EXPECT_EQ(contacts(model_a, model_b, query).size(), contact_count);
    EXPECT_EQ(distance(model_a, model_b, query).upper, least);
    EXPECT_EQ(relation(model_a, model_b, query).kind != RelationKind::apart, meets);
    met += meets ? 1 : 0;
    if (half_spaces) continue;
    const std::optional<ShapeHit> found = cast_shape(model_a, motion, model_b, query);
    EXPECT_EQ(found.has_value(), std::isfinite(first));
    EXPECT_EQ(found.has_value() ? found->upper : infinity, first);
    hit += found.has_value() ? 1 : 0;
  }
  EXPECT_GT(met, 5);
  EXPECT_GT(hit, 10);
}

/// A cube of 16³ balls.
Model cube_of_balls() {
  std::vector<CompoundPart> parts;
  for (int i = 0; i < 4096; ++i)
    parts.push_back({Sphere(0.3), {Mat3{}, {double(i % 16), double((i >> 4) % 16), double(i >> 8)}}});
  return Model(Compound(parts));
}

TEST(NearParts, LookAtFewBoxesOfManyParts) {
  const Model cube = cube_of_balls();
  const PosedModel a = pose_model(cube, Pose{}, Solid::automatic, "a");
  for (const double away : {15.9, 17.0, 100.0}) {
    const PosedModel b = pose_model(cube, {Mat3{}, {away, 0.25, 0.5}}, Solid::automatic, "b");
    SearchScratch scratch;
    std::size_t looks = 0;
    const auto counted = [&](const Aabb& x, const Aabb& y) {
      ++looks;
      return gap_of_parts(x, y);
    };
    NearParts near(a, b, counted, infinity, scratch);
    EXPECT_TRUE(near.next(infinity).has_value());
    EXPECT_LT(looks, 30000U) << away << ": there are 16.8 million pairs";
  }
}

}  // namespace
}  // namespace toccata
