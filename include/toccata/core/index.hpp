#pragma once

#include <cstdint>

namespace toccata {

/// The index type of vertices, triangles, faces and objects. Numbers start at 0.
using Index = std::uint32_t;

}  // namespace toccata
