#pragma once

#include <span>
#include <string>

#include "toccata/generate/crowds.hpp"

namespace toccata::io {

/// The pairs of all frames, each in its place, as 16 hexadecimal digits.
[[nodiscard]] std::string text_of(std::span<const PairDigest> frames);

/// Throws Error unless there are from 0 to 1024.
void require_threads(int threads);

}  // namespace toccata::io
