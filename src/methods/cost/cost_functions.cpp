#include "methods/cost/cost_walk.hpp"

namespace toccata {

CostFunctions cost_functions_of(CostVolume volume) {
  static constexpr auto functions =
      AllVolumes::of_each([]<class V>(std::type_identity<V>) { return cost_functions<V>(); });
  return functions[static_cast<std::size_t>(volume)];
}

}  // namespace toccata
