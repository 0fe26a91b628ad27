#pragma once

#include <string_view>

namespace toccata {

/// Throws Error, "NAME is -1; it has to be a length of 0 or more", for what is negative or no number.
void require_length(double length, std::string_view name);

}  // namespace toccata
