#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata {

CostFunctions aabb_cost_functions() { return cost_functions<Aabb>(0.2); }

}  // namespace toccata
