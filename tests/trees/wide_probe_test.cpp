#include <gtest/gtest.h>

#include <vector>

#include "toccata/trees/wide_bvh.hpp"
#include "trees/wide_probe.hpp"

namespace toccata {
namespace {

/// A chain of blocks that have seven leaf blocks each beside the next one, so that a search from the top leaves seven
/// blocks behind at every level. No builder makes such a tree.
WideBvh chain_of_blocks(std::size_t levels) {
  WideBvh tree = build_wide_bvh(std::vector<Aabb>(WideBlock::width, {{-1, -1, -1}, {1, 1, 1}}));
  const WideBlock leaf = tree.blocks.front();
  tree.blocks.assign(levels + 1, leaf);
  for (std::size_t level = 0; level < levels; ++level) {
    tree.blocks[level].child.fill(static_cast<std::int32_t>(levels));
    tree.blocks[level].child.back() = static_cast<std::int32_t>(level + 1);
  }
  return tree;
}

TEST(WideProbe, ATreeDeeperThanItsFirstMemoryLosesNothing) {
  constexpr std::size_t levels = 1000;
  const WideBvh tree = chain_of_blocks(levels);
  ASSERT_EQ(tree.blocks.front().count, WideBlock::width);
  std::size_t visits = 0;
  walk_probe(tree, WideProbe{}, [&](Index) {
    ++visits;
    return true;
  });
  EXPECT_EQ(visits, (7 * levels + 1) * WideBlock::width);
}

}  // namespace
}  // namespace toccata
