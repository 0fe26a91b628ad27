#pragma once

#include <filesystem>
#include <vector>

#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Reads a poses file (docs/reference/poses-file.md): a line per query, of 12 numbers (the pose of B in A's frame; A
/// stays where it is) or of 24 (the pose of A, then that of B), each pose R row by row and then t. Numbers are the
/// doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. The models' semantics
/// are left automatic. Throws Error naming the file and the line, also for a file without a pose.
[[nodiscard]] std::vector<PairQuery> read_poses(const std::filesystem::path& path);

}  // namespace toccata
