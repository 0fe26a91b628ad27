#pragma once

#include <memory>

#include "toccata/robots/robot.hpp"

namespace toccata {

/// Checks a description and makes it ready. Throws Error as Robot's constructor does.
[[nodiscard]] std::shared_ptr<const Robot::Tree> robot_tree_of(RobotDescription description, int threads);

}  // namespace toccata
