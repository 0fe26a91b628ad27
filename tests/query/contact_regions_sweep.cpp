// Depths, areas and normals of the regions in which random solids meet, against a slow oracle in doubles; and against
// the closed forms of boxes that overlap in a slab.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "query/slow_solids.hpp"
#include "support/case_seeds.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata::test {
namespace {

/// The bracket of a depth is no wider than this.
constexpr double promised_width = 1.1 + 1e-9;

bool is_close_to(double found, double truth, double error) { return std::abs(found - truth) <= error * (1 + truth); }

const std::vector<TriangleMesh>& solids_of(const std::string& family) {
  static const std::vector<TriangleMesh> all = some_solids();
  static const std::vector<TriangleMesh> convex = {box_mesh({0.7, 0.8, 0.9}), icosphere_mesh(0.9, 1),
                                                   prism_mesh(0.6, 1.5, 5), box_mesh({1, 1, 0.1})};
  return family == "convex" ? convex : all;
}

std::string fault_of_depth(const ContactRegion& region, const SlowSolid& a, const SlowSolid& b, Random& random) {
  if (!region.depth) return "no depth of two solids";
  if (!contains(region.box, Aabb{region.deepest, region.deepest})) return "the deepest point is outside of its box";
  const auto depth_at = [&](const Vec3& p) { return a.distance(p) + b.distance(p); };
  if (depth_at(region.deepest) < region.depth->lower * (1 - 1e-9) - 1e-12) return "less deep than its lower bound";
  const auto is_in = [&](const SlowSolid& solid) {  // also on its surface
    return solid.holds(region.deepest) || solid.distance(region.deepest) < 1e-9;
  };
  if (!is_in(a) || !is_in(b)) return "the deepest point is not in both";
  if (region.depth->upper > promised_width * region.depth->lower) return "the bracket is wide";
  for (int i = 0; i < 60; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(region.box.lower[axis], region.box.upper[axis]);
    if (a.holds(p) && b.holds(p) && depth_at(p) > region.depth->upper * (1 + 1e-9) + 1e-12)
      return "deeper than its upper bound";
  }
  return "";
}

/// Exchanged, the same numbers and the other way.
std::string fault_of_exchange(const ContactRegion& region, const ContactRegion& other) {
  if (other.depth != region.depth || other.deepest != region.deepest || other.box != region.box) return "exchanged";
  if (!is_close_to(-dot(other.normal, region.normal), 1, 1e-9)) return "exchanged, another normal";
  return is_close_to(other.area, region.area, 1e-9) ? "" : "exchanged, another area";
}

/// What both hold is in one of the regions.
std::string fault_of_parts(const std::vector<ContactRegion>& regions, const SlowSolid& a, const SlowSolid& b,
                           Random& random) {
  Aabb all;
  for (const ContactRegion& region : regions) all = merge(all, region.box);
  for (int i = 0; i < (regions.empty() ? 0 : 60); ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = random.between(all.lower[axis], all.upper[axis]);
    const auto holds_it = [&](const ContactRegion& region) { return contains(region.box, Aabb{p, p}); };
    if (a.holds(p) && b.holds(p) && std::none_of(regions.begin(), regions.end(), holds_it))
      return "a point of both is in no region";
  }
  return "";
}

std::string fault_of_contact_regions(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const Meeting made = random_meeting(solids_of(family), random);
  const PairQuery& query = made.query;
  const Model a(made.a), b(made.b);
  const SlowSolid slow_a(made.a, query.pose_a), slow_b(made.b, query.pose_b);
  const std::vector<ContactRegion> regions = contact_regions(a, b, query);
  const auto others = contact_regions(b, a, {.pose_a = query.pose_b, .pose_b = query.pose_a});
  if (regions.empty() != contacts(a, b, query).empty()) return "no region where they meet, or one where they do not";
  if (others.size() != regions.size()) return "exchanged, another number of regions";
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!is_close_to(dot(regions[i].normal, regions[i].normal), 1, 1e-12)) return "the normal is not of length 1";
    std::string fault = fault_of_depth(regions[i], slow_a, slow_b, random);
    if (fault.empty()) fault = fault_of_exchange(regions[i], others[i]);
    if (!fault.empty()) return fault;
  }
  if (regions.size() != 1) return fault_of_parts(regions, slow_a, slow_b, random);
  // All that they have in common is in it.
  const double shadow = slow_shadow(slow_a, slow_b, regions[0].normal);
  if (!is_close_to(regions[0].area, shadow, 1e-8))
    return fmt::format("area {}, and {} slowly", regions[0].area, shadow);
  return "";
}

/// Two boxes that overlap least along an axis, placed anywhere: the closed form.
std::string fault_of_slab(std::uint64_t seed) {
  Random random(seed);
  const Vec3 half_a{random.between(0.3, 1), random.between(0.3, 1), random.between(0.3, 1)},
      half_b{random.between(0.3, 1), random.between(0.3, 1), random.between(0.3, 1)};
  const int axis = static_cast<int>(random.below(3));
  const double depth = random.between(0.001, 0.2), sign = random.below(2) == 0 ? -1 : 1;
  Vec3 offset;
  double area = 1;
  for (int other = 0; other < 3; ++other) {
    const double reach = half_a[other] + half_b[other];
    if (other == axis) {
      offset[other] = sign * (reach - depth);
      continue;
    }
    offset[other] = random.between(-1, 1) * (reach - 0.5);  // they have more in common this way
    const double lower = std::max(-half_a[other], offset[other] - half_b[other]);
    area *= std::min(half_a[other], offset[other] + half_b[other]) - lower;
  }
  const Pose place{random_rotation(random), random_vector(random, 3)};
  const auto regions = contact_regions(Model(box_mesh(half_a)), Model(box_mesh(half_b)),
                                       {.pose_a = place, .pose_b = place * Pose::translation(offset)});
  if (regions.size() != 1 || !regions[0].depth) return "not one region with a depth";
  const ContactRegion& region = regions[0];
  if (region.depth->lower > depth + 1e-11 || region.depth->upper < depth - 1e-11)
    return fmt::format("the depth is {}, outside of [{}, {}]", depth, region.depth->lower, region.depth->upper);
  if (!is_close_to(region.area, area, 1e-9)) return fmt::format("area {}, and {} by its edges", region.area, area);
  const double along = sign * dot(region.normal, place.linear.column(axis));
  return is_close_to(along, 1, 1e-6) ? "" : fmt::format("the normal is off by the cosine {}", along);
}

SweepResult run_contact_regions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    return family == "slabs" ? fault_of_slab(case_seed) : fault_of_contact_regions(family, case_seed);
  });
}

const bool contact_regions_known =
    register_sweep({"contact-regions", {"slabs", "convex", "solids"}, 10'000, 60, run_contact_regions, 500, 10});

}  // namespace
}  // namespace toccata::test
