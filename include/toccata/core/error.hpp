#pragma once

#include <stdexcept>
#include <string>

namespace toccata {

/// The one exception type of the library. Thrown at the edges only: reading files, building shapes, and questions
/// that are asked wrongly (a pose that is not finite, an open mesh asked about as a solid). The message names the file
/// and line, or the element, and says what to do.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace toccata
