#pragma once

namespace toccata {

/// Semantic version of the library and the command.
inline constexpr const char* version = "0.1.0";

}  // namespace toccata
