#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace toccata::io {

/// "1 pair", "2 pairs".
[[nodiscard]] inline std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace toccata::io
