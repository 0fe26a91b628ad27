#include "query/cost/cost_walk.hpp"

namespace toccata {

std::string_view name_of(CostVolume volume) {
  constexpr std::array<std::string_view, all_cost_volumes.size()> names{"aabb",   "ball",      "cube",   "obb", "6-dop",
                                                                        "14-dop", "18-dop",    "26-dop", "pss", "lss",
                                                                        "rss",    "ellipsoid", "hull",   "wide"};
  return names[static_cast<std::size_t>(volume)];
}

std::string_view name_of(CostWorkload workload) {
  constexpr std::array<std::string_view, all_cost_workloads.size()> names{"rigid", "refit", "rebuild"};
  return names[static_cast<std::size_t>(workload)];
}

std::string_view name_of(CostTask task) {
  constexpr std::array<std::string_view, 3> names{"overlap", "contacts", "distance"};
  return names[static_cast<std::size_t>(task)];
}

std::string_view name_of(BvhMethod method) {
  constexpr std::array<std::string_view, all_bvh_methods.size()> names{"mean",          "median",    "heuristic",
                                                                       "agglomeration", "insertion", "morton"};
  return names[static_cast<std::size_t>(method)];
}

CostFunctions cost_functions_of(CostVolume volume) {
  constexpr std::array functions{
      aabb_cost_functions,  ball_cost_functions,      cube_cost_functions,  obb_cost_functions, dop6_cost_functions,
      dop14_cost_functions, dop18_cost_functions,     dop26_cost_functions, pss_cost_functions, lss_cost_functions,
      rss_cost_functions,   ellipsoid_cost_functions, hull_cost_functions};
  return functions[static_cast<std::size_t>(volume)]();
}

}  // namespace toccata
