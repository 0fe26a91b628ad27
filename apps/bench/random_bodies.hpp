#pragma once

#include <string>

#include "convex_library.hpp"
#include "toccata/core/random.hpp"

// What the benchmarks of pairs of shapes ask about, drawn from a seed.
namespace toccata::bench {

/// So many different pairs are asked about, so that shapes are not always in the nearest cache.
inline constexpr std::size_t different_pairs = 50;

Vec3 unit_vector(Random& random);
Mat3 random_rotation(Random& random);

/// A random body of about size 1; `kind` is one of those that the names of pairs consist of, `vertices` that of a hull.
ConvexBody random_body(const std::string& kind, std::size_t vertices, Random& random);

/// The radius of a ball around the origin that holds it.
double reach_of(const ConvexBody& body);

}  // namespace toccata::bench
