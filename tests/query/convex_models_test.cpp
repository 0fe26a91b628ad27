#include <gtest/gtest.h>

#include <fmt/format.h>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "narrow/casts_checks.hpp"
#include "query/casts/start_normal.hpp"
#include "support/convex_cases.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"

// Models of convex shapes are answered about as the shapes are, bit for bit; compounds as the least of their parts;
// scenes as the oracle says.
namespace toccata {
namespace {

Model model_of_shape(const test::ConvexShape& shape) {
  return std::visit([](const auto& given) { return Model(given); }, shape);
}

Shape shape_of(const test::ConvexShape& shape) {
  return std::visit([](const auto& given) { return Shape(given); }, shape);
}

std::string fault_of(const test::ConvexCase& pair, Random& random) {
  const Model a = model_of_shape(pair.a.shape), b = model_of_shape(pair.b.shape);
  const PosedPolytope posed_a = test::posed(pair.a), posed_b = test::posed(pair.b);
  const PairQuery query{.pose_a = pair.a.pose, .pose_b = pair.b.pose};
  const PairQuery other_way{.pose_a = pair.b.pose, .pose_b = pair.a.pose};
  if (distance(a, b, query) != distance(posed_a, posed_b)) return "distance";
  const Manifold points = manifold(posed_a, posed_b);
  if (manifold(a, b, query) != points) return "manifold";
  const std::vector<Contact> found = contacts(a, b, query);
  if (found.size() != (points.count > 0 ? 1U : 0U)) return "contacts";
  if (!found.empty() && manifold(a, b, found[0], query) != points) return "manifold of the contact";
  if (posed_a.solid() && posed_b.solid()) {
    if (penetration(a, b, query) != penetration(posed_a, posed_b)) return "penetration";
    if (penetration(b, a, other_way).upper != penetration(posed_a, posed_b).upper) return "penetration, exchanged";
  }
  const Vec3 motion = test::random_motion(pair, random);
  const std::optional<Cast> cast = cast_shape(a, motion, b, query);
  if (cast != with_start_normal(cast_shape(posed_a, motion, posed_b), posed_a, posed_b)) return "cast";
  const std::string fault = test::cast_fault(cast, test::set_of(pair.a), motion, test::set_of(pair.b));
  if (!fault.empty()) return "cast: " + fault;
  if (motion == Vec3{}) return "";
  const Vec3 origin = posed_a.vertex(0);
  const std::optional<Cast> ray = cast_ray(origin, motion, b, pair.b.pose);
  if (ray != cast_ray(origin, motion, posed_b)) return "ray";
  const std::string ray_fault = test::cast_fault(ray, oracle::point_set(origin), motion, test::set_of(pair.b));
  return ray_fault.empty() ? "" : "ray: " + ray_fault;
}

class ConvexModels : public testing::TestWithParam<std::string> {};

TEST_P(ConvexModels, AreAnsweredAboutAsTheirShapes) {
  constexpr std::uint64_t seed = 20261121;
  Random random(seed);
  for (std::uint64_t number = 0; number < 210; ++number) {
    const test::ConvexCase pair = test::numbered_case(GetParam(), number, random);
    EXPECT_EQ(fault_of(pair, random), "") << "seed " << seed << ", case " << number << "\n" << test::to_text(pair);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ConvexModels, testing::ValuesIn(test::convex_kinds()), [](const auto& kind) {
  std::string name = kind.param;
  std::erase(name, '-');
  return name;
});

TEST(ModelsAndHalfSpaces, AreAnsweredAboutAsTheirShapesBothWaysRound) {
  constexpr std::uint64_t seed = 20261121;
  Random random(seed);
  for (const std::string& kind : test::convex_kinds())
    for (const std::string& regime : test::convex_regimes()) {
      const test::HalfSpaceCase pair = test::half_space_case(kind, regime, random);
      SCOPED_TRACE(fmt::format("seed {}, {}, {}\n{}", seed, kind, regime, to_text(pair)));
      const Model a = model_of_shape(pair.a.shape), b(pair.b.shape);
      const PosedPolytope posed_a = test::posed(pair.a);
      const PosedHalfSpace posed_b = test::posed(pair.b);
      const PairQuery query{.pose_a = pair.a.pose, .pose_b = pair.b.pose};
      const PairQuery other_way{.pose_a = pair.b.pose, .pose_b = pair.a.pose};
      EXPECT_EQ(distance(a, b, query), distance(posed_a, posed_b));
      EXPECT_EQ(distance(b, a, other_way), flipped(distance(posed_a, posed_b)));
      EXPECT_EQ(manifold(a, b, query), manifold(posed_a, posed_b));
      EXPECT_EQ(manifold(b, a, other_way), flipped(manifold(posed_a, posed_b)));
      if (posed_a.solid()) {
        EXPECT_EQ(penetration(a, b, query), penetration(posed_a, posed_b));
        EXPECT_EQ(penetration(b, a, other_way), flipped(penetration(posed_a, posed_b)));
      }
      const Vec3 motion = 2.0 * (posed_b.point - posed_a.vertex(0)) + Vec3{0.5, 0.25, -0.125};
      const std::optional<Cast> cast = cast_shape(a, motion, b, query);
      EXPECT_EQ(cast, with_start_normal(cast_shape(posed_a, motion, posed_b), posed_a, posed_b));
      // The half-space moves the opposite way: the same times.
      const std::optional<Cast> moved = cast_shape(b, -motion, a, other_way);
      ASSERT_EQ(moved.has_value(), cast.has_value());
      if (cast) {
        EXPECT_EQ(moved->lower, cast->lower);
        EXPECT_EQ(moved->upper, cast->upper);
        EXPECT_EQ(moved->normal, -cast->normal);
      }
      EXPECT_EQ(cast_ray(posed_a.vertex(0), motion, b, pair.b.pose), cast_ray(posed_a.vertex(0), motion, posed_b));
    }
}

/// Some shapes around one place, of the same regime.
std::vector<test::PlacedPolytope> some_shapes(const std::string& regime, std::size_t count, Random& random) {
  const std::vector<std::string>& kinds = test::convex_kinds();
  std::vector<test::PlacedPolytope> shapes;
  while (shapes.size() < count) {
    const std::string& kind_a = kinds[random.below(kinds.size())];
    const std::string& kind_b = kinds[random.below(kinds.size())];
    const test::ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
    shapes.push_back(pair.a);
    shapes.push_back(pair.b);
  }
  return shapes;
}

Model compound_of(const test::PlacedPolytope& first, const test::PlacedPolytope& second) {
  const std::array<CompoundPart, 2> parts{CompoundPart{shape_of(first.shape), first.pose},
                                          CompoundPart{shape_of(second.shape), second.pose}};
  return Model(Compound{parts});
}

TEST(CompoundModels, AreAnsweredAboutAsTheLeastOfTheirParts) {
  constexpr std::uint64_t seed = 20261122;
  Random random(seed);
  for (const std::string& regime : test::convex_regimes())
    for (int repeat = 0; repeat < 6; ++repeat) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + regime + " " + std::to_string(repeat));
      const std::vector<test::PlacedPolytope> shapes = some_shapes(regime, 4, random);
      const Model a = compound_of(shapes[0], shapes[2]), b = compound_of(shapes[1], shapes[3]);
      const Vec3 motion = test::random_motion({shapes[0], shapes[1]}, random);
      std::optional<Distance> least;
      std::optional<ShapeHit> earliest;
      std::vector<std::pair<Index, Index>> meeting;
      for (const std::size_t i : {0U, 2U})
        for (const std::size_t j : {1U, 3U}) {
          const PosedPolytope part_a = test::posed(shapes[i]), part_b = test::posed(shapes[j]);
          Distance d = distance(part_a, part_b);
          d.element_a = d.face_a = static_cast<Index>(i / 2);
          d.element_b = d.face_b = static_cast<Index>(j / 2);
          if (!least || d.upper < least->upper) least = d;
          const std::optional<Cast> cast = with_start_normal(cast_shape(part_a, motion, part_b), part_a, part_b);
          if (cast && (!earliest || cast->upper < earliest->upper)) {
            const auto part = [](std::size_t number) { return static_cast<Index>(number / 2); };
            earliest = ShapeHit{*cast, part(i), part(j), part(i), part(j)};
          }
          if (oracle::overlap(test::set_of(shapes[i]), test::set_of(shapes[j]))) meeting.emplace_back(i / 2, j / 2);
        }
      EXPECT_EQ(distance(a, b), *least);
      EXPECT_EQ(cast_shape(a, motion, b), earliest);
      EXPECT_EQ(overlap(a, b), !meeting.empty());
      std::vector<std::pair<Index, Index>> found;
      for (const Contact& contact : contacts(a, b)) {
        found.emplace_back(contact.element_a, contact.element_b);
        const PosedPolytope part_a = test::posed(shapes[2 * contact.element_a]);
        const PosedPolytope part_b = test::posed(shapes[2 * contact.element_b + 1]);
        EXPECT_EQ(manifold(a, b, contact), manifold(part_a, part_b));
      }
      EXPECT_EQ(found, meeting);
    }
}

TEST(Scenes, OfConvexShapesAreCheckedAsTheOracleDoes) {
  constexpr std::uint64_t seed = 20261123;
  Random random(seed);
  for (const std::string& regime : test::convex_regimes()) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + regime);
    const std::vector<test::PlacedPolytope> shapes = some_shapes(regime, 12, random);
    Scene scene;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      SceneObject& object = scene.objects.emplace_back();
      object.name = std::to_string(i);
      object.shape = shape_of(shapes[i].shape);
      object.pose = shapes[i].pose;
    }
    const CheckAnswer answer = check_all(scene_models(scene));
    std::size_t next = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (std::size_t j = i + 1; j < shapes.size(); ++j) {
        const oracle::Relation truth = oracle::relation(test::set_of(shapes[i]), test::is_solid(shapes[i]),
                                                        test::set_of(shapes[j]), test::is_solid(shapes[j]));
        if (truth.kind == oracle::RelationKind::apart) continue;
        ASSERT_LT(next, answer.pairs.size());
        const PairAnswer& found = answer.pairs[next++];
        ASSERT_EQ(std::pair(found.a, found.b), std::pair(static_cast<Index>(i), static_cast<Index>(j)));
        EXPECT_EQ(static_cast<int>(found.relation.kind), static_cast<int>(truth.kind));
        EXPECT_EQ(static_cast<int>(found.relation.containment), static_cast<int>(truth.containment));
        EXPECT_EQ(found.relation.side_unresolved, truth.side_unresolved);
      }
    EXPECT_EQ(next, answer.pairs.size());
  }
}

}  // namespace
}  // namespace toccata
