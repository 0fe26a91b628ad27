// Real meshes against themselves: the numbers that CGAL finds where it takes the mesh, and these numbers kept.
#include <gtest/gtest.h>

#include "query/self_cgal.hpp"
#include "support/data.hpp"
#include "toccata/io/model_file.hpp"

namespace toccata::test {
namespace {

struct RealMesh {
  const char* file;
  std::size_t pairs;  ///< of triangles in which it meets itself
};

void PrintTo(const RealMesh& mesh, std::ostream* out) { *out << mesh.file; }

class RealMeshAgainstItself : public testing::TestWithParam<RealMesh> {};

TEST_P(RealMeshAgainstItself, AsCgalSays) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TriangleMesh mesh = read_mesh(*data / "meshes" / GetParam().file);
  const auto surface = surface_of(mesh, {});
  ASSERT_TRUE(surface.has_value());
  const TrianglePairs found = pairs_by_toccata(mesh, {});
  EXPECT_EQ(found, pairs_by_cgal(*surface));
  EXPECT_EQ(found.size(), GetParam().pairs);
}

INSTANTIATE_TEST_SUITE_P(Files, RealMeshAgainstItself,
                         testing::Values(RealMesh{"fandisk.obj", 0}, RealMesh{"rocker-arm.obj", 0},
                                         RealMesh{"spot.obj", 0}, RealMesh{"stanford-bunny.obj", 0}));

}  // namespace
}  // namespace toccata::test
