#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/swept_sphere.hpp"

namespace toccata {

CostFunctions pss_cost_functions() { return cost_functions<Pss>(1); }
CostFunctions lss_cost_functions() { return cost_functions<Lss>(3); }

}  // namespace toccata
