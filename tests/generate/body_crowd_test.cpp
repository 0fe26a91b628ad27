#include <gtest/gtest.h>

#include <string>

#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {
namespace {

/// In contact, with each other and with the ground.
struct Counted {
  std::size_t pairs = 0;
  std::size_t on_ground = 0;
};

Counted contacts_of(const BodyCrowd& crowd) {
  std::vector<SceneInstance> bodies;
  for (std::size_t i = 0; i < crowd.shapes().size(); ++i)
    bodies.push_back({Model(crowd.shapes()[i]), crowd.poses()[i]});
  Counted counted;
  for (const PairAnswer& pair : check_all(bodies).pairs) {
    ++counted.pairs;
    if (pair.a < crowd.ground_count()) ++counted.on_ground;
  }
  return counted;
}

TEST(BodyCrowd, DoesWhatItsSceneSays) {
  for (const NamedScene& scene : body_crowd_scenes()) {
    BodyCrowd crowd(scene.name, 300, 3), same(scene.name, 300, 3);
    EXPECT_EQ(crowd.shapes().size(), 300 + crowd.ground_count());
    EXPECT_EQ(crowd.ground_count(), scene.name == "fly" ? 0U : 1U);
    for (int frame = 0; frame < 80; ++frame) {
      crowd.step();
      same.step();
    }
    EXPECT_EQ(crowd.poses(), same.poses());
    const Counted counted = contacts_of(crowd);
    EXPECT_TRUE(scene.name != "stacks" || counted.pairs >= 240U) << counted.pairs;
    EXPECT_TRUE(scene.name != "pile" || counted.pairs >= 300U) << counted.pairs;
    EXPECT_TRUE(scene.name != "floor" || counted.on_ground >= 200U) << counted.on_ground;
    EXPECT_TRUE(scene.name != "terrain" || counted.on_ground >= 100U) << counted.on_ground;
    EXPECT_GE(counted.pairs, 1U) << scene.name;
  }
  EXPECT_THROW(BodyCrowd("stack", 10), Error);
  EXPECT_EQ(BodyCrowd("pile", 0).shapes().size(), 1U);
}

TEST(BodyCrowd, FliesAsItDidBeforeThereWereScenes) {
  BodyCrowd crowd(50, 0.05, 7), named("fly", 50, 7);
  EXPECT_EQ(crowd.poses(), named.poses());
}

}  // namespace
}  // namespace toccata
