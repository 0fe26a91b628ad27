#pragma once

#include <filesystem>
#include <vector>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// Reads a points file (docs/reference/nearest-report.md): a line per point, of 3 numbers, in the world. Numbers are
/// the doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. Throws Error naming
/// the file and the line, also for a file without a point.
[[nodiscard]] std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace toccata
