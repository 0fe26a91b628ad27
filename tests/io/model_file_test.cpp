#include "toccata/io/model_file.hpp"

#include <gtest/gtest.h>

#include "support/command.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

TEST(LoadModel, TakesAFileOrAGenerator) {
  const test::TemporaryFolder folder;
  write_mesh(generate_mesh("box"), folder.path() / "box.stl");
  const Model read = load_model(folder.path() / "box.stl");
  const Model made = load_model("gen:box");
  EXPECT_EQ(read.mesh().triangle_count(), made.mesh().triangle_count());
  EXPECT_TRUE(read.closed());
  EXPECT_THROW(static_cast<void>(load_model(folder.path() / "gone.stl")), Error);
  EXPECT_THROW(static_cast<void>(load_model("gen:no-such-thing")), Error);
}

}  // namespace
}  // namespace toccata
