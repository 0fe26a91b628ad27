#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/obb.hpp"

namespace toccata {

CostFunctions obb_cost_functions() { return cost_functions<Obb>(3); }

}  // namespace toccata
