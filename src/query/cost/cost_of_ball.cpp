#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/ball.hpp"

namespace toccata {

CostFunctions ball_cost_functions() { return cost_functions<Ball>(1); }

}  // namespace toccata
