#pragma once

#include <memory>
#include <vector>

#include "library.hpp"

namespace toccata::bench {

/// A library that finds all pairs of triangles in which a mesh intersects itself, other than by what neighbours share:
/// Toccata, or a peer.
class SelfLibrary {
 public:
  virtual ~SelfLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured; false when the library does not take such a mesh.
  virtual bool prepare(const TriangleMesh& mesh) = 0;
  /// In any order.
  virtual TrianglePairs pairs() = 0;
};

using SelfLibraries = std::vector<std::unique_ptr<SelfLibrary>>;

SelfLibraries toccata_self_libraries();
SelfLibraries cgal_self_libraries();

}  // namespace toccata::bench
