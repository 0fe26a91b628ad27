#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/meshes.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {
namespace {

/// Against the truth in rational arithmetic, which shares nothing with the library: world vertices and all.
TEST(Contacts, AreThoseOfTheOracle) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const PairQuery query = test::random_poses(family, random);
      const double grid = seed % 2 == 0 ? 8 : 0;
      const Model a(test::random_soup(random, 15, 0.3, grid)), b(test::random_soup(random, 15, 0.3, grid));
      std::vector<oracle::TrianglePair> found;
      for (const Contact& contact : contacts(a, b, query)) found.push_back({contact.element_a, contact.element_b});
      EXPECT_EQ(found, oracle::intersecting_pairs(oracle::surface_set(a.mesh(), query.pose_a),
                                                  oracle::surface_set(b.mesh(), query.pose_b)));
    }
}

}  // namespace
}  // namespace toccata
