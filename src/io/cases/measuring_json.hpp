#pragma once

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// The keys of questions that measure (docs/reference/case-file.md), those of costs without their poses, and back.
/// Reading throws Error naming the place.
[[nodiscard]] Json json_of_measuring(const CostQuestion& question);
[[nodiscard]] Json json_of_measuring(const CrowdQuestion& question);
[[nodiscard]] Json json_of_measuring(const CrowdWorldQuestion& question);
[[nodiscard]] CostQuestion cost_question_of(const JsonValue& value);
[[nodiscard]] SceneQuestion crowd_question_of(const JsonValue& value);
[[nodiscard]] SceneQuestion crowd_world_question_of(const JsonValue& value);

}  // namespace toccata::io
