#include "query/cost/cost_walk.hpp"
#include "toccata/bounds/swept_sphere.hpp"

namespace toccata {

CostFunctions rss_cost_functions() { return cost_functions<Rss>(3); }

}  // namespace toccata
