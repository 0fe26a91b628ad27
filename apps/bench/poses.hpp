#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "library.hpp"
#include "toccata/query/model.hpp"

namespace toccata::bench {

/// The poses file of docs/reference/poses-file.md. Throws Error naming file and line.
std::vector<PosePair> read_poses(const std::filesystem::path& file);

/// Where B stands, as seen from its outermost contact with A.
struct Nearness {
  enum class Kind {
    jittered,   ///< within 2 % of the smaller mesh's diagonal of contact
    close,      ///< within 1e-6 … 1e-14 of that diagonal
    separated,  ///< as the first, but apart
    gap,        ///< moved by `gap` times that diagonal
  };
  Kind kind = Kind::jittered;
  double gap = 0;  ///< away from A; negative: into it
};

/// Random rigid poses of both objects. B comes from outside along a random direction until it touches A (binary search
/// to the outermost contact that 16 steps see), and is then moved along it by a random amount either way, so that about
/// half of the pairs touch, or outwards.
/// The same for any number of threads (0: as many as the machine has).
std::vector<PosePair> random_poses(const Model& a, const Model& b, std::size_t count, std::uint64_t seed,
                                   const Nearness& nearness, int threads);

/// The lengths of ways, as parts of the smaller diagonal.
struct WayShape {
  double motion = 0.01;
  double gap = 0;
};

/// Ways of 50 steps each, from poses that are `separated`: A stays where it is, and B moves on, turning, so that none
/// of its vertices moves farther in a step than `motion`; where it would meet A, or get away farther than 4 % of the
/// diagonal, it turns into another direction. The whole way is then moved away from A by `gap`, along the line of the
/// centres where it starts.
std::vector<PosePair> poses_on_the_way(const Model& a, const Model& b, std::size_t count, std::uint64_t seed,
                                       const WayShape& shape);

/// `count` queries: the given ones in turn, both objects moved together by a random rigid motion, rounded.
std::vector<PosePair> moved_together(const std::vector<PosePair>& poses, std::size_t count, std::uint64_t seed);

/// Both linear parts are rotations up to rounding; peers take no others.
bool are_rigid(const PosePair& poses);

}  // namespace toccata::bench
