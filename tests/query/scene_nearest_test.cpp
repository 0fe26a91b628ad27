#include "toccata/query/scene_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// Models of every kind, near and far, one around others.
std::vector<SceneInstance> some_scene(Random& random) {
  const Model knot(generate_mesh("torus-knot"));
  const std::vector<double> heights{0, 1, 0, 2, 0, 1, 1, 1, 0};
  const std::vector<CompoundPart> parts{{Box({1, 1, 1}), {}}, {Sphere(0.5), Pose::translation(1, 1, 1)}};
  const std::vector<Model> models{knot,
                                  Model(HeightField(3, 3, 2, 2, heights)),
                                  Model(Sphere(2)),
                                  Model(Capsule({0, 0, -1}, {0, 0, 1}, 0.5)),
                                  Model(Compound(parts)),
                                  Model(test::box_between({-1, -1, -1}, {1, 1, 1})),
                                  Model(Point{})};
  std::vector<SceneInstance> scene;
  for (int i = 0; i < 20; ++i) {
    const Vec3 at{random.between(-20, 20), random.between(-20, 20), random.between(-20, 20)};
    const Model& model = models[random.below(models.size())];
    scene.push_back({model, {test::random_rotation(random), at}, Solid::automatic, "part " + std::to_string(i)});
  }
  scene.push_back({Model(Box({30, 30, 30})), {}, Solid::automatic, "hall"});
  return scene;
}

std::vector<Vec3> some_points(Random& random, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.push_back({random.between(-40, 40), random.between(-25, 25), random.between(-25, 25)});
  return points;
}

std::vector<ScenePoint> one_by_one(const Vec3& point, std::size_t k, const std::vector<SceneInstance>& scene,
                                   double within) {
  std::vector<ScenePoint> all;
  for (std::size_t i = 0; i < scene.size(); ++i)
    for (const SurfacePoint& one :
         nearest_points(point, k, scene[i].model, {.pose = scene[i].pose, .max_distance = within}))
      all.push_back({one, static_cast<Index>(i)});
  std::sort(all.begin(), all.end(), [](const ScenePoint& a, const ScenePoint& b) {
    return std::tie(a.nearest.upper, a.object, a.nearest.element) <
           std::tie(b.nearest.upper, b.object, b.nearest.element);
  });
  all.resize(std::min(k, all.size()));
  return all;
}

TEST(SceneNearest, IsThatOfEveryModelByItself) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    Random random(seed);
    const std::vector<SceneInstance> scene = some_scene(random);
    const std::vector<Vec3> points = some_points(random, 40);
    for (const std::size_t k : {1U, 3U, 30U})
      for (const double within : {infinity, 5.0}) {
        const auto found = nearest_points_each(points, k, scene, within, {.threads = 3});
        EXPECT_EQ(found, nearest_points_each(points, k, scene, within, {.threads = 1}));
        for (std::size_t i = 0; i < points.size(); ++i)
          ASSERT_EQ(found[i], one_by_one(points[i], k, scene, within)) << "seed " << seed << ", point " << i;
      }
  }
}

TEST(SceneNearest, SignedDistancesAreThoseOfTheCompound) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    Random random(seed);
    const std::vector<SceneInstance> scene = some_scene(random);
    std::vector<CompoundPart> parts;
    std::vector<Index> first_element{0};
    for (const SceneInstance& posed : scene) {
      parts.push_back({posed.model.shape(), posed.pose});
      first_element.push_back(first_element.back() + posed.model.element_count());
    }
    const Model whole((Compound(parts)));
    const std::vector<Vec3> points = some_points(random, 40);
    const auto found = signed_distance_each(points, scene, SignBy::automatic, {.threads = 3});
    EXPECT_EQ(found, signed_distance_each(points, scene, SignBy::automatic, {.threads = 1}));
    for (std::size_t i = 0; i < points.size(); ++i) {
      SignedDistance expected = signed_distance(points[i], whole);
      expected.element -= first_element[found[i].object];
      expected.face = found[i].distance.face;
      ASSERT_EQ(found[i].distance, expected) << "seed " << seed << ", point " << i;
      ASSERT_EQ(found[i].inside_of.has_value(), expected.side == Side::inside);
      if (found[i].inside_of) {
        const SceneInstance& holder = scene[*found[i].inside_of];
        EXPECT_EQ(signed_distance(points[i], holder.model, holder.pose).side, Side::inside);
      }
    }
  }
}

TEST(SceneNearest, TellsWhoseSurfaceAndInWhat) {
  const std::vector<SceneInstance> scene{{Model(Sphere(5)), {}, Solid::automatic, "room"},
                                         {Model(Box({1, 1, 1})), {}, Solid::automatic, "chest"}};
  const std::vector<Vec3> points{{2, 0, 0}, {0, 0, 0.5}, {9, 0, 0}, {1, 0, 0}};
  const auto found = signed_distance_each(points, scene);
  EXPECT_EQ(found[0].object, 1U);
  EXPECT_EQ(found[0].inside_of, 0U);
  EXPECT_NEAR(found[0].distance.upper, -1, 1e-12);
  EXPECT_EQ(found[1].inside_of, 0U);
  EXPECT_EQ(found[2].inside_of, std::nullopt);
  EXPECT_NEAR(found[2].distance.upper, 4, 1e-11);
  EXPECT_EQ(found[3].distance.side, Side::boundary);
}

TEST(SceneNearest, BadInputIsRefusedByName) {
  const auto message_of = [](const auto& ask) -> std::string {
    try {
      static_cast<void>(ask());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  Pose lost;
  lost.offset.x = NAN;
  const std::vector<SceneInstance> scene{{Model(Sphere(5)), {}, Solid::automatic, "room"},
                                         {Model(Sphere(5)), lost, Solid::automatic, "chest"}};
  const std::vector<Vec3> points{{2, 0, 0}, {0, NAN, 0.5}};
  EXPECT_NE(message_of([&] { return nearest_points_each(points, 1, scene); }).find("chest"), std::string::npos);
  const std::span<const SceneInstance> room = std::span(scene).first(1);
  EXPECT_EQ(message_of([&] { return nearest_points_each(points, 1, room); }), "point 1: the point is not finite");
  EXPECT_EQ(message_of([&] { return signed_distance_each(points, room); }), "point 1: the point is not finite");
  EXPECT_NE(message_of([&] { return signed_distance_each(points, {}); }), "");
  EXPECT_NE(message_of([&] { return nearest_points_each(points, 1, room, -1); }), "");
  EXPECT_TRUE(nearest_points_each(std::vector<Vec3>{{1, 2, 3}}, 1, std::span<const SceneInstance>())[0].empty());
}

}  // namespace
}  // namespace toccata
