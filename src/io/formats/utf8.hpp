#pragma once

#include <string>
#include <string_view>

namespace toccata::io {

/// Whether these bytes are UTF-8 (RFC 3629): no overlong forms, no surrogates, nothing beyond U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view bytes);

/// The bytes with each that is no part of a UTF-8 character written as \xff in hexadecimal. UTF-8 stays as it is.
[[nodiscard]] std::string as_utf8(std::string_view bytes);

}  // namespace toccata::io
