#pragma once

#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::command {

/// Asks, while a progress bar with that label tells how far it is. Where --save-case says so, the question is in that
/// file before it is asked, so that it is there whatever happens, and the answer or the error when there is one.
SceneAnswer ask_for(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                    const std::string& label);

/// Prints the warnings of the input, and then the answer in that format; JSON as it is, or with what was asked.
void print_answer(const CheckInput& input, const SceneAnswer& answer, Format format);
void print_answer(const CheckInput& input, const SceneQuestion& question, const SceneAnswer& answer,
                  const PosedArguments& arguments);

// What people read of each answer.
std::string table_of(const CheckInput& input, const CheckReport& report);
std::string table_of(const CheckInput& input, const PosesReport& report);
std::string table_of(const CheckInput& input, const SelfReport& report);
std::string table_of(const CheckInput& input, const DistanceReport& report);
std::string table_of(const CheckInput& input, const DistancePosesReport& report);
std::string table_of(const CheckInput& input, const RayReport& report);
std::string table_of(const CheckInput& input, const FacesReport& report);
std::string table_of(const CheckInput& input, const NearestReport& report);

}  // namespace toccata::command
