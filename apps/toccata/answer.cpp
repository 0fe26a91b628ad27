#include "answer.hpp"

#include "ask.hpp"
#include "output.hpp"
#include "view.hpp"

namespace toccata::command {

SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label, const AlsoWritten& also) {
  SceneAnswer answer = ask_for(input, question, arguments, {label, draws_something(target_of(arguments))});
  give_answer(question, input, answer, arguments, also);
  return answer;
}

void give_answer(const SceneQuestion& question, const CheckInput& input, SceneAnswer& answer,
                 const PosedArguments& arguments, const AlsoWritten& also) {
  const ViewTarget target = target_of(arguments);
  const std::string told = also ? also(input, answer) : "";  // first: it may throw for what the answer is
  if (draws_something(target)) write_view(target, input, answer);
  list_faces(answer, question);
  print_answer(input, question, answer, arguments);
  if (arguments.format == Format::table) print_answer(told);
}

}  // namespace toccata::command
