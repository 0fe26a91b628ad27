#pragma once

#include <string>

#include "toccata/shapes/shape.hpp"

namespace toccata::command {

/// What the shape is and its numbers, for people: "sphere of radius 1 around (0, 0, 0)".
std::string shape_text(const Shape& shape);

}  // namespace toccata::command
