#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/json_value.hpp"

namespace toccata::io {

/// The bytes of a "data:…;base64,…" URI. `place` is where it stands, for messages.
[[nodiscard]] std::vector<char> decode_data_uri(const JsonValue& place, std::string_view uri);

/// The file that a relative URI names. It must lie within `folder`, links followed: a model that somebody sent must not
/// be able to read other files.
[[nodiscard]] std::filesystem::path file_of_uri(const JsonValue& place, std::string_view uri,
                                                const std::filesystem::path& folder);

}  // namespace toccata::io
