#pragma once

#include <array>

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// Contains a model in its own frame, whatever nearly rigid pose it is given afterwards.
struct LocalBox {
  Vec3 centre{};
  Vec3 half{};
  double magnitude = 0;  ///< of what is added up where the model is posed; infinite: there is no box
};

[[nodiscard]] LocalBox local_box(const Model& model);

/// A box at its place. Everything that it stands for is within `slack` of it.
struct TurnedBox {
  Vec3 centre{};
  std::array<Vec3, 3> axes{};   ///< of any length; a flat box has all three
  std::array<Vec3, 3> edges{};  ///< half of them, from the centre, along the axes
  double slack = 0;
};

[[nodiscard]] TurnedBox turned_box(const LocalBox& box, const Pose& pose);

/// The radius of a ball around its centre that contains what the box stands for, also when it is turned.
[[nodiscard]] double radius_around(const TurnedBox& box);

[[nodiscard]] Aabb box_around(const TurnedBox& box);

/// Proved, in doubles, to be farther apart than this: along the edges and what is across two of them (S. Gottschalk,
/// M. C. Lin, D. Manocha, "OBBTree", 1996). False says nothing.
[[nodiscard]] bool certainly_apart(const TurnedBox& a, const TurnedBox& b, double by);

}  // namespace toccata
