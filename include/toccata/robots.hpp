#pragma once

// Robots: trees of links and joints, read from URDF or described; what they meet at configurations and between them.

#include "toccata/robots/allowed_pairs.hpp"
#include "toccata/robots/generated_arm.hpp"
#include "toccata/robots/robot.hpp"
#include "toccata/robots/robot_files.hpp"
#include "toccata/robots/robot_scene.hpp"
