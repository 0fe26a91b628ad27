#pragma once

#include <vector>

#include "toccata/query/manifolds.hpp"

namespace toccata {

/// What `manifolds` answers, where it may be known that the two are in contact.
[[nodiscard]] std::vector<ModelManifold> manifolds_of(const Model& a, const Model& b, const PairQuery& query,
                                                      bool in_contact, Workspace& workspace);

}  // namespace toccata
