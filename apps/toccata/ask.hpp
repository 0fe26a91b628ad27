#pragma once

#include <functional>
#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::command {

/// Lists the faces, or the faults, of an answer as this question asks: those of one that is drawn are found whether
/// they are listed or not.
void list_faces(SceneAnswer& answer, const SceneQuestion& question);

/// The answer in JSON, with its faces listed as this question asks.
std::string json_as_asked(const CheckInput& input, const SceneQuestion& question, SceneAnswer& answer);

/// How a question is asked.
struct Asking {
  std::string label;      ///< of the progress bar that tells how far it is
  bool is_drawn = false;  ///< the answer lists the faces that meet, whatever the question says
};

/// Where --save-case says so, the question is in that file before it is asked, so that it is there whatever happens,
/// and the answer or the error when there is one: as they are asked, whether drawn or not.
SceneAnswer ask_for(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                    const Asking& asking);

/// What people read of an answer, where a subcommand has options about it; else `table_of`.
using TableText = std::function<std::string(const SceneAnswer&)>;

/// Prints the warnings of the input, and then the answer in that format; JSON as it is, or with what was asked.
void print_answer(const CheckInput& input, const SceneAnswer& answer, Format format);
void print_answer(const CheckInput& input, const SceneQuestion& question, const SceneAnswer& answer,
                  const PosedArguments& arguments, const TableText& table = {});

}  // namespace toccata::command
