#pragma once

#include <vector>

#include "toccata/bounds/ball.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// Some balls that lie within a solid, large ones and apart from each other, where the pose places it: what meets one
/// of them certainly meets the solid. None of a surface, nor where none was found.
[[nodiscard]] std::vector<Ball> inner_balls(const Model& model, const Pose& pose, Solid solid);

}  // namespace toccata
