#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/kdop.hpp"

namespace toccata {

CostFunctions dop6_cost_functions() { return cost_functions<Kdop<6>>(0.3); }
CostFunctions dop14_cost_functions() { return cost_functions<Kdop<14>>(0.5); }

}  // namespace toccata
