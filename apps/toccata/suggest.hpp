#pragma once

#include <span>
#include <string>

namespace toccata::command {

/// The candidate nearest to `word` by edit distance, when it is near enough to be what was meant; else empty.
std::string nearest_word(const std::string& word, std::span<const std::string> candidates);

}  // namespace toccata::command
