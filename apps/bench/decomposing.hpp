#pragma once

#include "library.hpp"

namespace toccata::bench {

/// What a library cuts a closed mesh into.
struct PeerParts {
  Description who;
  double seconds = 0;  ///< of the thread, all of it
  std::size_t parts = 0;
  double volume = 0;  ///< of all
};

/// CGAL's exact decomposition, which has no limit of parts. Throws Error where it takes no such mesh.
PeerParts cgal_convex_parts(const TriangleMesh& mesh);

}  // namespace toccata::bench
