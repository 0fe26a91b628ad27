#pragma once

#include <string>
#include <vector>

#include "toccata/math/vec3.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Reads a points file (docs/reference/nearest-report.md): a line per point, of 3 numbers, in the world. Numbers are
/// the doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. Throws Error naming
/// the file and the line, also for a file without a point.
[[nodiscard]] std::vector<Vec3> read_points(const std::string& path);

/// Reads a poses file (docs/reference/poses-file.md): a line per query, of 12 numbers (the pose of B in A's frame; A
/// stays where it is) or of 24 (the pose of A, then that of B), each pose R row by row and then t. Numbers are the
/// doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. The models' semantics
/// are left automatic. Throws Error naming the file and the line, also for a file without a pose.
[[nodiscard]] std::vector<PairQuery> read_poses(const std::string& path);

/// Reads a rays file (docs/reference/ray-report.md): a line per ray, of 6 numbers, where it starts and where it ends,
/// in the world. Numbers are the doubles nearest to the text, finite, and separated by blanks or commas; # starts a
/// comment. Throws Error naming the file and the line, also for a ray without length and a file without a ray.
[[nodiscard]] std::vector<RayQuery> read_rays(const std::string& path);

}  // namespace toccata
