#pragma once

#include "io/formats/json_value.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {

/// "auto", "all", "none".
[[nodiscard]] const char* word_of(Solid solid);

/// The same backwards. Throws Error naming the place.
[[nodiscard]] Solid solid_of(const JsonValue& value);

}  // namespace toccata::io
