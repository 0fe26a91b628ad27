#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace toccata {

/// The one exception type of the library. Thrown at the edges only: reading files, building shapes, and questions
/// that are asked wrongly (a pose that is not finite, an open mesh asked about as a solid). The message names the file
/// and line, or the element, and says what to do.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// The candidate nearest to a mistyped word by edit distance, when it is near enough to be what was meant; else empty.
[[nodiscard]] std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// For the end of a message about an unknown word: "; did you mean 'x'?", or when none is near "; known are a, b, c".
[[nodiscard]] std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace toccata
