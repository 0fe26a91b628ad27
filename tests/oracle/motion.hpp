#pragma once

#include <optional>

#include "oracle/polynomials.hpp"
#include "toccata/motion/time_of_impact.hpp"

namespace toccata::oracle {

/// The first time in [0, 1] at which the two features have a point in common, if there is one.
std::optional<AlgebraicNumber> contact_time(const VertexFace& pair);
std::optional<AlgebraicNumber> contact_time(const EdgeEdge& pair);

/// Whether the two have a point in common at a time in [0, 1].
bool meet_at(const VertexFace& pair, const AlgebraicNumber& time);
bool meet_at(const EdgeEdge& pair, const AlgebraicNumber& time);

}  // namespace toccata::oracle
