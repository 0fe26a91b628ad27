#include "query/distance/nearby.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "toccata/generate/meshes.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

// One question with two numbers, of every pair of kinds: whatever they are, the answer is that of the distance.
namespace toccata::test {
namespace {

struct NamedModel {
  std::string name;
  Model model;
};

std::vector<NamedModel> models_of_all_kinds() {
  const Cylinder can(0.3, 0.5);
  const std::vector<CompoundPart> parts{{Sphere(0.4), Pose::translation(0.5, 0, 0)},
                                        {can, Pose::translation(-0.5, 0, 0)},
                                        {ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), {}}};
  return {{"sphere", Sphere(0.7)},
          {"box", Box({0.5, 0.4, 0.3})},
          {"cylinder", can},
          {"half-space", HalfSpace({0, 0, -0.5}, {0.1, 0.2, 1})},
          {"mesh", Model(icosphere_mesh(0.8, 2))},
          {"compound", Model(Compound(parts))}};
}

std::string fault_of(const Model& a, const Model& b, const PairQuery& query, const WantedDistance& wanted) {
  Workspace workspace;
  const Distance truth = distance(a, b, query);
  const auto found = nearby(a, b, wanted, query, workspace);
  if (truth.upper <= wanted.enough)
    return found && found->is_within && found->distance.upper <= wanted.enough ? "" : "not near enough";
  if (truth.lower > wanted.limit * (1 + 1e-11)) return found ? "beyond the limit" : "";
  if (!found || found->distance != truth) return "not the distance";
  return found->is_within == (truth.upper <= wanted.limit) ? "" : "within the limit";
}

TEST(Nearby, WithAnyTwoNumbersAnswersAsTheDistanceDoes) {
  const std::vector<NamedModel> models = models_of_all_kinds();
  for (const NamedModel& a : models)
    for (const NamedModel& b : models)
      for (const double height : {0.3, 4.0}) {
        const PairQuery query{.pose_b = {Pose::rotation({1, 2, 3}, 0.4).linear, {0.2, 0.1, height}}};
        const double length = distance(a.model, b.model, query).upper;
        for (const double limit : {0.0, 0.5 * length, 2 * length, infinity})
          for (const double enough : {-1.0, 0.0, 0.25 * length, 1.5 * length, infinity})
            if (enough <= limit) {
              EXPECT_EQ(fault_of(a.model, b.model, query, {limit, enough}), "")
                  << fmt::format("{} and {}, {} apart, limit {}, enough {}", a.name, b.name, length, limit, enough);
            }
        Workspace workspace;
        EXPECT_EQ(nearby(a.model, b.model, WantedDistance::within(0), query, workspace).has_value(),
                  overlap(a.model, b.model, query));
      }
}

}  // namespace
}  // namespace toccata::test
