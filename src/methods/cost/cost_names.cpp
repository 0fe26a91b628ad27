#include "toccata/methods/cost.hpp"

namespace toccata {

std::string_view name_of(CostVolume volume) {
  if (volume == CostVolume::wide) return "wide";
  constexpr auto names =
      AllVolumes::of_each([]<class V>(std::type_identity<V>) -> std::string_view { return V::name; });
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
  constexpr std::array<std::string_view, all_bvh_methods.size()> names{
      "mean", "median", "heuristic", "agglomeration", "insertion", "morton", "equal-regions"};
  return names[static_cast<std::size_t>(method)];
}

}  // namespace toccata
