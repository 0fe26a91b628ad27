#include "answer.hpp"

#include "ask.hpp"
#include "view.hpp"

namespace toccata::command {

SceneQuestion with_faces(SceneQuestion question) {
  if (auto* check = std::get_if<CheckQuestion>(&question)) check->faces = true;
  if (auto* self = std::get_if<SelfQuestion>(&question)) self->faces = true;
  return question;
}

void list_faces(SceneAnswer& answer, const SceneQuestion& question) {
  if (auto* check = std::get_if<CheckReport>(&answer)) check->has_faces = std::get<CheckQuestion>(question).faces;
  if (auto* self = std::get_if<SelfReport>(&answer)) self->has_faces = std::get<SelfQuestion>(question).faces;
}

SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label) {
  const ViewTarget target = target_of(arguments);
  const bool is_drawn = draws_something(target);
  SceneAnswer answer = ask_for(input, is_drawn ? with_faces(question) : question, arguments, label);
  if (is_drawn) write_view(target, input, answer);
  list_faces(answer, question);
  print_answer(input, question, answer, arguments);
  return answer;
}

}  // namespace toccata::command
