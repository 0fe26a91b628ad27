#include <algorithm>

#include "methods/cost/cost_plan.hpp"
#include "methods/cost/cost_walk.hpp"
#include "toccata/bounds/all_volumes.hpp"

namespace toccata {
namespace {

VolumeCost volume_cost(CostVolume volume, const CostHierarchy& hierarchy, const FitTimes& times) {
  const CostFunctions functions = cost_functions_of(volume);
  VolumeCost cost;
  cost.volume = volume;
  cost.arity = hierarchy.arity;
  cost.balance = hierarchy.balance;
  cost.bytes = hierarchy.nodes() * functions.bytes_of_node + hierarchy.triangles.size() * sizeof(Index);
  cost.build_ns = hierarchy.build_ns + times.all_of(hierarchy);
  return cost;
}

}  // namespace

std::vector<VolumeCost> measure_volumes(const TriangleMesh& mesh, const CostOptions& asked) {
  const CostOptions options = checked_options(asked);
  std::vector<Triangle> triangles;
  for (const auto& corner : mesh.triangles())
    triangles.push_back({{mesh.vertices()[corner[0]], mesh.vertices()[corner[1]], mesh.vertices()[corner[2]]}});
  const double hull = measure(fit<HullBound>(triangles));
  std::array<std::vector<FitTimes>, all_cost_volumes.size()> times;
  std::array<RootSize, all_cost_volumes.size()> roots;
  std::vector<VolumeCost> costs;
  std::size_t done = 0;
  for (const BvhMethod method : options.methods)
    for (const int arity : options.arities) {
      const CostHierarchy hierarchy(triangles, arity, {method, options.leaf_size, BvhDriver::iterative});
      for (const CostVolume volume : options.volumes) {
        if (volume == CostVolume::wide) continue;
        const auto place = static_cast<std::size_t>(volume);
        if (times[place].empty()) {
          times[place].push_back(cost_functions_of(volume).fits(hierarchy));
          roots[place] = cost_functions_of(volume).root(hierarchy);
        }
        VolumeCost cost = volume_cost(volume, hierarchy, times[place].front());
        cost.method = method;
        cost.root_volume = roots[place].volume;
        cost.root_surface = roots[place].surface;
        cost.fill = cost.root_volume > 0 ? std::min(1.0, hull / cost.root_volume) : 0;
        costs.push_back(cost);
      }
      if (options.progress) options.progress(++done, options.methods.size() * options.arities.size());
    }
  return costs;
}

}  // namespace toccata
