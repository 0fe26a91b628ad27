// Relations of real models, taken as solids.
#include <gtest/gtest.h>

#include "support/data.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

class RelationOfRealModels : public testing::TestWithParam<std::string> {
 protected:
  /// Nothing, and the test skipped, where the data is not there.
  std::optional<TriangleMesh> load() {
    const auto folder = data_folder();
    if (!folder) return std::nullopt;
    return read_mesh(*folder / "meshes" / GetParam());
  }
};

Aabb box_of(const TriangleMesh& mesh) { return fit_aabb(mesh.vertices()); }

TEST_P(RelationOfRealModels, FollowHowTheyArePlaced) {
  const std::optional<TriangleMesh> mesh = load();
  if (!mesh) GTEST_SKIP() << "set TOCCATA_DATA";
  const Model model(*mesh);
  ASSERT_TRUE(model.closed());
  const Aabb box = box_of(*mesh);
  const Vec3 size = box.upper - box.lower;
  const auto asked = [&](const Model& other, const Pose& pose = {}) { return relation(model, other, {Pose{}, pose}); };

  EXPECT_EQ(asked(model).containment, Containment::equal);
  const Pose aside = Pose::translation(0.1 * size.x, 0.03 * size.y, 0.02 * size.z);
  EXPECT_EQ(asked(model, aside).kind, RelationKind::overlapping);
  EXPECT_EQ(asked(model, aside).containment, Containment::none);
  EXPECT_EQ(asked(model, Pose::translation(2 * size.x, 0, 0)).kind, RelationKind::apart);

  const Model around(box_between(box.lower - size, box.upper + size));
  EXPECT_EQ(asked(around).containment, Containment::a_in_b);
  const Model below(box_between(box.lower - size, {box.upper.x, box.upper.y, box.lower.z}));
  EXPECT_EQ(asked(below).kind, RelationKind::touching);
}

TEST_P(RelationOfRealModels, PointsOfThemLieOnThem) {
  const std::optional<TriangleMesh> mesh = load();
  if (!mesh) GTEST_SKIP() << "set TOCCATA_DATA";
  const Model model(*mesh);
  const Aabb box = box_of(*mesh);
  for (std::size_t i = 0; i < mesh->vertices().size(); i += 97) {
    const Vec3& v = mesh->vertices()[i];
    EXPECT_EQ(locate(v, model).side, Side::boundary) << i;
    EXPECT_EQ(locate({box.lower.x - 1, v.y, v.z}, model).side, Side::outside) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Data, RelationOfRealModels,
                         testing::Values("rocker-arm.obj", "fandisk.obj", "spot.obj", "cow.obj"), [](const auto& name) {
                           std::string text = name.param;
                           return text.substr(0, text.find_first_of("-."));
                         });

}  // namespace
}  // namespace toccata::test
