#pragma once

#include <string>
#include <string_view>

namespace toccata::io {

/// Where two reports say something else, and what; empty where every bit is the same. Which program wrote them, and
/// what it warned of, and times that it
/// measured (members whose names end with _ns or _ms), are not compared. Throws Error for what is no JSON.
[[nodiscard]] std::string first_difference(std::string_view recorded, std::string_view now);

}  // namespace toccata::io
