#pragma once

#include <toccata/query/pair_query.hpp>

namespace toccata::python {

/// Memory that single questions need, kept for the calling thread: to make it anew took longer than to answer about two
/// convex shapes. Not for questions that leave long lists in it.
[[nodiscard]] inline Workspace& kept_workspace() {
  static thread_local Workspace workspace;
  return workspace;
}

}  // namespace toccata::python
