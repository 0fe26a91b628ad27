#pragma once

#include "arguments.hpp"
#include "casts.hpp"

namespace toccata::bench {

/// Pairs, poses and ways for a benchmark of casts: shapes of about size 1 that are apart at the start, in random
/// rotations, 2 to 5 of their sizes away. Deterministic by the seed.
CastWork cast_work(const CastsArguments& arguments);

/// What Toccata tells.
std::optional<Cast> cast_of(const CastPair& pair, const CastQuestion& question);

}  // namespace toccata::bench
