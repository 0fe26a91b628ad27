#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/cube.hpp"

namespace toccata {

CostFunctions cube_cost_functions() { return cost_functions<Cube>(0.2); }

}  // namespace toccata
