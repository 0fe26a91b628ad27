#pragma once

#include <functional>
#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::command {

/// Writes what else a subcommand writes of its answer, and tells that in a line, where it did.
using AlsoWritten = std::function<std::string(const CheckInput&, const SceneAnswer&)>;

/// Asks, while a progress bar with that label tells how far it is; writes the pages and pictures that the arguments
/// name, and prints the warnings and the answer.
SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label, const AlsoWritten& also = {});

/// What is done with an answer that was found: it is drawn, written and printed, with faces as the question lists them.
void give_answer(const SceneQuestion& question, const CheckInput& input, SceneAnswer& answer,
                 const PosedArguments& arguments, const AlsoWritten& also);

}  // namespace toccata::command
