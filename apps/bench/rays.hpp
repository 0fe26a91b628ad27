#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"

namespace toccata::bench {

/// From origin to origin + motion; of floats, so that all libraries are asked the same.
struct RayQuestion {
  Vec3 origin;
  Vec3 motion;
};

struct RayAnswer {
  bool hit = false;
  double time = 0;  ///< as a part of the motion
};

/// A library that tells where rays first meet the surface of a mesh: Toccata, or a peer.
class RayLibrary {
 public:
  virtual ~RayLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured.
  virtual void prepare(const TriangleMesh& mesh, std::span<const RayQuestion> questions) = 0;
  /// Answers the questions from `first` on.
  virtual void answer(std::size_t first, std::span<RayAnswer> answers) = 0;
};

using RayLibraries = std::vector<std::unique_ptr<RayLibrary>>;

RayLibraries toccata_ray_libraries();
RayLibraries embree_ray_libraries();

}  // namespace toccata::bench
