#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/generate/scenes.hpp"

namespace toccata {

/// Boxes that move, for trying and measuring broad phases: about three pairs a box overlap. The same name, count and
/// seed give the same boxes in every frame, on every machine.
class Crowd {
 public:
  /// Throws Error naming the closest when there is no such scene.
  Crowd(std::string_view scene, std::size_t count, std::uint64_t seed = 1);

  [[nodiscard]] const std::vector<Aabb>& boxes() const { return boxes_; }
  /// The next frame. Gives the numbers of the boxes that moved, ascending.
  std::span<const Index> step();

 private:
  void place(Index number);

  struct Body {
    Vec3 centre, half, velocity;  ///< a frame
  };
  std::vector<Body> bodies_;
  std::vector<Aabb> boxes_;
  std::vector<Index> moving_;
  Vec3 room_;               ///< centres stay between 0 and this
  bool on_ground_ = false;  ///< z follows x and y
};

/// uniform, clustered, sizes, static, terrain and fast.
[[nodiscard]] std::span<const NamedScene> crowd_scenes();

}  // namespace toccata
