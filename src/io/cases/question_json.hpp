#pragma once

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// The "query" of a case (docs/reference/scene-file.md), and back. Reading throws Error naming the place.
[[nodiscard]] Json json_of(const SceneQuestion& question);
[[nodiscard]] SceneQuestion question_of(const JsonValue& value);

}  // namespace toccata::io
