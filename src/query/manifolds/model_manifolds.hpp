#pragma once

#include <vector>

#include "toccata/query/manifolds.hpp"

namespace toccata {

/// What `overlap` and `manifolds` answer.
struct MetManifolds {
  bool in_contact = false;
  std::vector<ModelManifold> manifolds{};
};

[[nodiscard]] MetManifolds manifolds_where_met(const Model& a, const Model& b, const PairQuery& query,
                                               Workspace& workspace);

}  // namespace toccata
