#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

/// Spheres, boxes, capsules and convex hulls of about size 1 that fly and turn in a room, for trying and measuring
/// worlds of bodies. The same count, share and seed give the same bodies in every frame, on every machine.
class BodyCrowd {
 public:
  /// About this share of them is in contact at a time. Throws Error unless it lies between 0.001 and 1.
  explicit BodyCrowd(std::size_t count, double share_in_contact = 0.05, std::uint64_t seed = 1);

  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }
  /// Where they are now: rotations and translations.
  [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }
  /// The next frame: each moves by up to a fiftieth and turns by up to three degrees.
  void step();

 private:
  void place(std::size_t number);

  struct Flight {
    Vec3 centre, velocity;  ///< a frame
    Vec3 axis;
    double angle = 0, spin = 0;  ///< degrees, a frame
  };
  std::vector<Shape> shapes_;
  std::vector<Flight> flights_;
  std::vector<Pose> poses_;
  double room_ = 0;  ///< centres stay between 0 and this
};

}  // namespace toccata
