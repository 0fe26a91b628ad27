// How questions may be called, and what the compiler refuses.
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

template <class A, class B>
concept MayBeAsked = requires(const A& a, const B& b) {
  overlap(a, b, {});
}
|| requires(const A& a, const B& b) { distance(a, b, {}); }
|| requires(const A& a, const B& b) { manifold(a, b, {}); }
|| requires(const A& a, const B& b) { relation(a, b); }
|| requires(const A& a, const B& b) { penetration(a, b); }
|| requires(const A& a, const B& b) { contacts(a, b); };

static_assert(MayBeAsked<Model, Sphere> && MayBeAsked<Sphere, Box>);
static_assert(!MayBeAsked<TriangleMesh, Sphere> && !MayBeAsked<Model, std::shared_ptr<const TriangleMesh>>);
static_assert(!MayBeAsked<Shape, Shape> && !MayBeAsked<Sphere, Compound> && !MayBeAsked<HeightField, Model>);

TEST(Calls, AnEmptyQueryIsNoContact) {
  const Box box({1, 1, 1});
  EXPECT_EQ(manifold(box, box, {}), manifold(box, box));
  EXPECT_EQ(manifold(box, box, Contact{}), manifold(box, box));
}

TEST(Calls, CompoundsOfAThousandLevelsAreAsked) {
  Shape nested = Sphere(1);
  for (int level = 0; level < most_compound_levels; ++level)
    nested = Compound({{nested, Pose::translation(0.25, 0, 0)}});
  const Model model(nested);
  EXPECT_TRUE(overlap(model, Box({1, 1, 1}, {250, 0, 0})));
  EXPECT_FALSE(overlap(model, Box({1, 1, 1})));
  EXPECT_NEAR(distance(model, Point({0, 0, 0})).lower, 249, 1e-9);
  EXPECT_EQ(relation(model, model).containment, Containment::equal);
}

}  // namespace
}  // namespace toccata
