#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/formats/json_value.hpp"

namespace toccata::io {

// Bytes as text, RFC 4648.

[[nodiscard]] std::string base64_of(std::string_view bytes);

/// `place` is where the text stands, for messages. Throws Error for what is no base64.
[[nodiscard]] std::vector<char> decode_base64(const JsonValue& place, std::string_view text);

}  // namespace toccata::io
