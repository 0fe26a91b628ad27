#pragma once

#include <span>
#include <string>
#include <string_view>

namespace toccata {

/// The candidate nearest to a mistyped word by edit distance, when it is near enough to be what was meant; else empty.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// For the end of a message about an unknown word: "; did you mean 'x'?", or when none is near "; known are a, b, c".
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace toccata
