#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/kdop.hpp"

namespace toccata {

CostFunctions dop18_cost_functions() { return cost_functions<Kdop<18>>(0.7); }
CostFunctions dop26_cost_functions() { return cost_functions<Kdop<26>>(1); }

}  // namespace toccata
