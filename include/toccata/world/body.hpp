#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// Names a body of a World, and of copies of it, for as long as it is there. Indices are dense and are given out again;
/// with another generation, so that the id of a body that was removed never names another. `BodyId{}` is of no body.
struct BodyId {
  Index index = 0;
  std::uint32_t generation = 0;  ///< from 1
  std::uint32_t world = 0;  ///< from 1, in the order in which a program makes its Worlds; a copy has its original's
  friend constexpr auto operator<=>(const BodyId&, const BodyId&) = default;
};

}  // namespace toccata

template <>
struct std::hash<toccata::BodyId> {
  std::size_t operator()(const toccata::BodyId& id) const noexcept {
    return std::hash<std::uint64_t>()(std::uint64_t{id.generation} << 32 | id.index);
  }
};

namespace toccata {

/// Which pairs are of interest. Any body may be given another pose at any time.
enum class BodyType : std::uint8_t {
  static_body,     ///< part of the surroundings: two static bodies never make a pair
  kinematic_body,  ///< goes where its owner says, whatever it meets
  dynamic_body,    ///< reacts to what it meets
};

/// A shape at its place and what a World is to know of it. The model and what it refers to are shared, so a body is
/// small.
struct Body {
  Model model;
  Pose pose{};
  BodyType type = BodyType::dynamic_body;
  Solid solid = Solid::automatic;
  /// Categories that it is in, and categories that it is to be compared with, a bit each: two bodies make a pair only
  /// if each is in a category of the other's mask.
  std::uint64_t category = 1;
  std::uint64_t mask = ~std::uint64_t{0};
  /// In world units, 0 or more, also +∞: two bodies are a pair when their exact distance is at most the sum of their
  /// margins (as rounded to nearest), or what a PairRule says. 0 and 0: when they have a point in common.
  double margin = 0;
  /// What its owner expects of its motion, for WorldOptions::space_time: by how much at most the way of one of its
  /// points in a step differs from that in the step before, and how far at most a point moves in a step. In world
  /// units, 0 or more; +∞: not known. They save time where they are kept and cost time where not; no answer depends on
  /// them.
  double max_acceleration = std::numeric_limits<double>::infinity();
  double max_speed = std::numeric_limits<double>::infinity();
  std::uint64_t user_data = 0;  ///< for the owner; the World does not look at it
  std::string name{};           ///< for messages
};

}  // namespace toccata
