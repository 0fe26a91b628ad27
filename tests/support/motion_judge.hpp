#pragma once

#include <optional>
#include <string>

#include "toccata/motion/time_of_impact.hpp"

namespace toccata::test {

/// What is wrong with an answer, judged by the oracle; nothing where it is right.
std::optional<std::string> wrong_answer(const VertexFace& pair, const std::optional<TimeOfImpact>& answer);
std::optional<std::string> wrong_answer(const EdgeEdge& pair, const std::optional<TimeOfImpact>& answer);

/// The pair as numbers that can be copied into a test.
std::string told(const VertexFace& pair);
std::string told(const EdgeEdge& pair);

}  // namespace toccata::test
