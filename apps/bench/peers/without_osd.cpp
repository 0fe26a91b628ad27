#include "library.hpp"
#include "subdivisions.hpp"

namespace toccata::bench {

LimitLibraries osd_limit_libraries() { peer_is_missing("osd"); }

}  // namespace toccata::bench
