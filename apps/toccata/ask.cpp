#include "ask.hpp"

#include <optional>
#include <variant>

#include "early_end.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "saved.hpp"
#include "stream.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/case_file.hpp"
#include "view.hpp"

namespace toccata::command {
namespace {

void save(const CheckInput& input, const SceneQuestion& question, const std::string& answer, const std::string& path) {
  const UninterruptedWriting writing;
  write_case({input.loaded.scene, question, answer}, path);
}

SceneAnswer asked(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                  const Asking& asking) {
  const Scene& scene = input.loaded.scene;
  AskOptions options{.threads = arguments.threads};
  std::optional<EarlyEnd> end;
  if (std::holds_alternative<CheckQuestion>(question)) {
    end.emplace(arguments.stop_after);
    options.stop = [&] { return end->is_due(); };
  }
  if (arguments.format == Format::stream) {
    print_answer(stream_head(scene));
    options.keeps_found = !asking.streamed;
    options.found = [&](const CheckReport& one) {
      print_answer(pair_line_json(scene, one, 0) + "\n");
      if (asking.streamed) asking.streamed(one.pairs[0]);
    };
  }
  ProgressBar bar(asking.label);
  options.progress = bar.callback();
  return ask(scene, input.models, question, options);
}

bool is_unfinished(const SceneAnswer& answer) {
  const auto* check = std::get_if<CheckReport>(&answer);
  return check != nullptr && check->unfinished > 0;
}

/// The same question with the faces that meet, and faults, which are drawn whether they are listed or not.
SceneQuestion with_faces(SceneQuestion question) {
  if (auto* check = std::get_if<CheckQuestion>(&question)) check->faces = true;
  if (auto* self = std::get_if<SelfQuestion>(&question)) self->faces = true;
  if (auto* inspect = std::get_if<InspectQuestion>(&question)) inspect->faults = true;
  return question;
}

/// Lists the faces, or the faults, of an answer as this question asks: those of one that is drawn are found whether
/// they are listed or not.
void list_faces(SceneAnswer& answer, const SceneQuestion& question) {
  if (auto* check = std::get_if<CheckReport>(&answer)) check->has_faces = std::get<CheckQuestion>(question).faces;
  if (auto* self = std::get_if<SelfReport>(&answer)) self->has_faces = std::get<SelfQuestion>(question).faces;
  auto* inspected = std::get_if<InspectReport>(&answer);
  if (inspected == nullptr || std::get<InspectQuestion>(question).faults) return;
  for (InspectedObject& object : inspected->objects) object.faults.clear();
}

std::string text_of(const CheckInput& input, const SceneAnswer& answer, Format format, const TableText& table) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return report_json(loaded.scene, input.models, answer, loaded.warnings);
  if (format == Format::csv) return report_csv(loaded.scene, answer);
  if (format == Format::stream) return stream_end(input, std::get<CheckReport>(answer));
  if (table) return table(answer);
  return std::visit([&](const auto& report) { return table_of(input, report); }, answer);
}

}  // namespace

bool is_drawn(const PosedArguments& arguments) {
  const ExchangeFiles& files = arguments.exchange;
  return draws_something(target_of(arguments)) || !files.bcf.empty() || !files.junit.empty() || !files.sarif.empty();
}

void print_answer(const CheckInput& input, const SceneQuestion& question, const SceneAnswer& answer,
                  const PosedArguments& arguments, const TableText& table) {
  std::string text = text_of(input, answer, arguments.format, table);
  if (arguments.format == Format::json) text = with_asked(std::move(text), asked_of(input, arguments, question));
  print_warnings(untold_warnings(input.loaded));
  print_answer(text);
}

std::string json_as_asked(const CheckInput& input, const SceneQuestion& question, SceneAnswer answer) {
  list_faces(answer, question);
  return report_json(input.loaded.scene, input.models, answer);
}

SceneAnswer ask_for(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                    const Asking& asking) {
  const SceneQuestion wanted = asking.is_drawn ? with_faces(question) : question;
  if (arguments.save_case.empty()) return asked(input, wanted, arguments, asking);
  require_distinct({{"--save-case", arguments.save_case}}, arguments.input.files);
  save(input, question, "", arguments.save_case);  // also tells at once where it cannot be written
  try {
    SceneAnswer answer = asked(input, wanted, arguments, asking);
    if (is_unfinished(answer)) return answer;  // which is none that asking again gives
    save(input, question, json_as_asked(input, question, answer), arguments.save_case);
    return answer;
  } catch (const Error& error) {
    save(input, question, error_json(error.what()), arguments.save_case);
    throw;
  }
}

SceneAnswer answer_to(const SceneQuestion& question, const CheckInput& input, const PosedArguments& arguments,
                      const std::string& label, const AlsoWritten& also) {
  SceneAnswer answer = ask_for(input, question, arguments, {label, is_drawn(arguments)});
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
