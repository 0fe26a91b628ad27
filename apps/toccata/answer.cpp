#include "answer.hpp"

#include "ask.hpp"
#include "view.hpp"

namespace toccata::command {

SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label) {
  const ViewTarget target = target_of(arguments);
  const bool is_drawn = draws_something(target);
  SceneAnswer answer = ask_for(input, question, arguments, {label, is_drawn});
  if (is_drawn) write_view(target, input, answer);
  list_faces(answer, question);
  print_answer(input, question, answer, arguments);
  return answer;
}

}  // namespace toccata::command
