#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// Adds to a page's header its "words" for each finding, and the "methods" that these name
/// (docs/reference/view-page.md).
void add_words(nlohmann::ordered_json& header, std::span<const Posed> models, const SceneAnswer& answer);

}  // namespace toccata::io
