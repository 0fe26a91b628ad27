#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::bench {

/// A library that finds which bodies of a moving crowd are in contact: Toccata, or a peer.
class WorldLibrary {
 public:
  virtual ~WorldLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured: spheres, boxes, capsules along z, hulls, and height fields.
  virtual void add(std::span<const Shape> shapes, std::span<const Pose> poses) = 0;
  /// Measured: every body goes to its pose, which the ground has had before, and all pairs in contact are found.
  virtual void step(std::span<const Pose> poses) = 0;
  /// Not measured: what the last step found, in any order.
  [[nodiscard]] virtual std::vector<IndexPair> contacts() const = 0;
};

/// `manifolds`: contact points are told too, as Bullet tells them always and FCL never here.
std::unique_ptr<WorldLibrary> toccata_world(int threads, bool manifolds);
std::unique_ptr<WorldLibrary> bullet_world();
std::unique_ptr<WorldLibrary> fcl_world();

}  // namespace toccata::bench
