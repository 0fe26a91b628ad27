#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace toccata::io {

/// Where a JSON text has the first number that no double holds.
struct JsonOverflow {
  std::string number;  ///< as it is written
  std::string path;    ///< by RFC 6901
  std::string name;    ///< of the innermost object around it that has told one before; else empty
  std::size_t byte = 0;
};

/// Finds where a text that is JSON but for such a number has it.
[[nodiscard]] JsonOverflow overflow_of(std::span<const char> text);

}  // namespace toccata::io
