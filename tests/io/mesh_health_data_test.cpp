#include <gtest/gtest.h>

#include "support/data.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

MeshHealth health_of(const std::string& name) {
  return inspect(read_mesh(*test::data_folder() / "meshes" / (name + ".obj")));
}

TEST(MeshHealthOfRealMeshes, ClosedOnes) {
  if (!test::data_folder()) GTEST_SKIP() << "set TOCCATA_DATA";
  for (const char* name : {"rocker-arm", "fandisk", "spot", "cow"}) {
    const MeshHealth health = health_of(name);
    EXPECT_TRUE(health.closed) << name;
    EXPECT_GT(health.signed_volume, 0) << name;
  }
}

TEST(MeshHealthOfRealMeshes, OpenOnes) {
  if (!test::data_folder()) GTEST_SKIP() << "set TOCCATA_DATA";
  const MeshHealth bunny = health_of("stanford-bunny");
  EXPECT_FALSE(bunny.closed);
  EXPECT_EQ(bunny.unbalanced_edges, 223U);
  EXPECT_EQ(bunny.triangles, 69451U);
  for (const char* name : {"env", "rob", "teapot", "suzanne"}) EXPECT_FALSE(health_of(name).closed) << name;
}

}  // namespace
}  // namespace toccata
