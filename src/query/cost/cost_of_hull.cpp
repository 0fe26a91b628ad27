#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/hull_bound.hpp"

namespace toccata {

CostFunctions hull_cost_functions() { return cost_functions<HullBound>(20); }

}  // namespace toccata
