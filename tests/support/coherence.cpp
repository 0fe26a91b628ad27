#include "support/coherence.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/distance_cache.hpp"

namespace toccata::test {
namespace {

Pose moved(const Pose& pose, Random& random, double share) {
  const Vec3 axis = random_vector(random, 1) + Vec3{0, 0, 2};
  const Pose turn{rotation_about(axis, random.between(-1, 1) * share * 60), random_vector(random, share)};
  return turn * pose;
}

Model random_model(const std::string& family, Random& random) {
  if (family == "solids") return Model(icosphere_mesh(random.between(0.2, 1.5), static_cast<int>(random.below(3))));
  if (random.below(3) == 0) return Model(torus_mesh({.radius = 0.5, .tube_radius = random.between(0.1, 0.3)}));
  const auto triangles = static_cast<Index>(1 + random.below(120));
  return Model(random_soup(random, triangles, std::exp2(random.between(-6, -1)), random.below(2) == 0 ? 0 : 8));
}

double share_of(const std::string& family, Random& random) {
  static const std::map<std::string, double> shares{{"1e-6", 1e-6}, {"1e-4", 1e-4}, {"1 %", 1e-2}, {"10 %", 0.1}};
  const auto found = shares.find(family);
  if (found != shares.end()) return found->second;
  if (family == "jumps") return random.below(8) == 0 ? 1 : 1e-3;
  return std::pow(10, random.between(-8, -0.5));
}

/// Apart by up to some of their size, or not at all.
PairQuery first_poses(const std::string& family, Random& random) {
  const double way = random.below(4) == 0 ? 0 : std::exp2(random.between(-3, 2));
  PairQuery query;
  if (family == "deformed") query = random_poses("sheared", random);
  query.pose_b.offset = query.pose_b.offset + way * (random_vector(random, 1) + Vec3{0, 0, 1});
  if (family == "far") query.pose_a.offset = query.pose_b.offset = {1e6, -1e6, 1e6};
  return query;
}

}  // namespace

const std::vector<std::string>& motion_families() {
  static const std::vector<std::string> families{"1e-6", "1e-4", "1 %",      "10 %",  "jumps",
                                                 "both", "far",  "deformed", "solids"};
  return families;
}

std::string fault_of_coherence(const std::string& family, std::uint64_t seed, int steps) {
  Random random(seed);
  const Model a = random_model(family, random), b = random_model(family, random);
  PairQuery query = first_poses(family, random);
  const double share = share_of(family, random);
  DistanceCache cache;
  for (int step = 0; step < steps; ++step) {
    if (!(distance(a, b, query, cache) == distance(a, b, query))) return fmt::format("step {}", step);
    const double by = family == "jumps" ? share_of(family, random) : share;
    query.pose_b = moved(query.pose_b, random, by);
    if (family == "both" || family == "far") query.pose_a = moved(query.pose_a, random, by);
  }
  return {};
}

}  // namespace toccata::test
