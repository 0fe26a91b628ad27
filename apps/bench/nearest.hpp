#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"

namespace toccata::bench {

/// A library that tells how far points are from the surface of a mesh: Toccata, or a peer.
class NearestLibrary {
 public:
  virtual ~NearestLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// How much of the distance and of the mesh's size its answers may be off by.
  [[nodiscard]] virtual double tolerance() const { return 1e-12; }
  /// Not measured. The mesh outlives the library.
  virtual void prepare(const TriangleMesh& mesh) = 0;
  virtual void answer(std::span<const Vec3> points, std::span<double> distances) = 0;
};

using NearestLibraries = std::vector<std::unique_ptr<NearestLibrary>>;

NearestLibraries toccata_nearest_libraries();
NearestLibraries embree_nearest_libraries();
NearestLibraries cgal_nearest_libraries();

}  // namespace toccata::bench
