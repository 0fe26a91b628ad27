#pragma once

#include <functional>
#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::command {

/// The answer in JSON, with its faces listed as this question asks.
std::string json_as_asked(const CheckInput& input, const SceneQuestion& question, SceneAnswer answer);

/// How a question is asked.
struct Asking {
  std::string label;      ///< of the progress bar that tells how far it is
  bool is_drawn = false;  ///< the answer lists the faces that meet, whatever the question says
  /// Sees each pair that --stream writes; the answer has none of them then, so nothing else may need them.
  std::function<void(const ReportedPair&)> streamed{};
};

/// Where --save-case says so, the question is in that file before it is asked, so that it is there whatever happens,
/// and the answer or the error when there is one: as they are asked, whether drawn or not.
SceneAnswer ask_for(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                    const Asking& asking);

/// Whether what is found has to be drawn.
[[nodiscard]] bool is_drawn(const PosedArguments& arguments);

/// What people read of an answer, where a subcommand has options about it; else `table_of`.
using TableText = std::function<std::string(const SceneAnswer&)>;

/// Prints the warnings of the input, and then the answer in that format; JSON with what was asked.
void print_answer(const CheckInput& input, const SceneQuestion& question, const SceneAnswer& answer,
                  const PosedArguments& arguments, const TableText& table = {});

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
