#pragma once

#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::command {

/// Asks, while a progress bar with that label tells how far it is; writes the pages and pictures that the arguments
/// name, and prints the warnings and the answer.
SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label);

}  // namespace toccata::command
