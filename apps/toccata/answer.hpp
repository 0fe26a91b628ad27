#pragma once

#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::command {

/// The same question with the faces that meet, which are drawn whether they are listed or not.
SceneQuestion with_faces(SceneQuestion question);

/// Lists the faces of an answer to `with_faces` as this question asks.
void list_faces(SceneAnswer& answer, const SceneQuestion& question);

/// Asks, while a progress bar with that label tells how far it is; writes the pages and pictures that the arguments
/// name, and prints the warnings and the answer.
SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label);

}  // namespace toccata::command
