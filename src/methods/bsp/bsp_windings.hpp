#pragma once

#include <vector>

#include "toccata/query/model.hpp"

namespace toccata {

/// The winding number just in front of each triangle; just behind it is one more. The mesh has to be closed, not to
/// intersect itself, and to have no triangle without area. Exact.
[[nodiscard]] std::vector<int> windings_in_front(const Model& solid);

}  // namespace toccata
