#pragma once

#include <span>

#include "io/formats/json.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// Adds to a page's header its "words" for each finding, and the "methods" that these name
/// (docs/reference/view-page.md).
void add_words(Json& header, std::span<const SceneInstance> models, const SceneAnswer& answer);

}  // namespace toccata::io
