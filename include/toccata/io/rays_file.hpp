#pragma once

#include <filesystem>
#include <vector>

#include "toccata/query/batch.hpp"

namespace toccata {

/// Reads a rays file (docs/reference/ray-report.md): a line per ray, of 6 numbers, where it starts and where it ends,
/// in the world. Numbers are the doubles nearest to the text, finite, and separated by blanks or commas; # starts a
/// comment. Throws Error naming the file and the line, also for a ray without length and a file without a ray.
[[nodiscard]] std::vector<RayQuery> read_rays(const std::filesystem::path& path);

}  // namespace toccata
