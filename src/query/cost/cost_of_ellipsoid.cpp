#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/ellipsoid_bound.hpp"

namespace toccata {

CostFunctions ellipsoid_cost_functions() { return cost_functions<EllipsoidBound>(50); }

}  // namespace toccata
