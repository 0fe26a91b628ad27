#include "ask.hpp"

#include "output.hpp"
#include "progress_bar.hpp"
#include "saved.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/case_file.hpp"

namespace toccata::command {
namespace {

void save(const CheckInput& input, const SceneQuestion& question, const std::string& answer, const std::string& path) {
  const UninterruptedWriting writing;
  write_case({input.loaded.scene, question, answer}, path);
}

SceneAnswer asked(const CheckInput& input, const SceneQuestion& question, int threads, const std::string& label) {
  ProgressBar bar(label);
  return ask(input.models, question, {threads, bar.callback()});
}

std::string text_of(const CheckInput& input, const SceneAnswer& answer, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return report_json(loaded.scene, input.models, answer, loaded.warnings);
  if (format == Format::csv) return report_csv(loaded.scene, answer);
  return std::visit([&](const auto& report) { return table_of(input, report); }, answer);
}

}  // namespace

void print_answer(const CheckInput& input, const SceneAnswer& answer, Format format) {
  const std::string text = text_of(input, answer, format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
}

void print_answer(const CheckInput& input, const SceneQuestion& question, const SceneAnswer& answer,
                  const PosedArguments& arguments) {
  if (arguments.format != Format::json) return print_answer(input, answer, arguments.format);
  const std::string text = with_asked(text_of(input, answer, Format::json), asked_of(input, arguments, question));
  print_warnings(input.loaded.warnings);
  print_answer(text);
}

SceneAnswer ask_for(const CheckInput& input, const SceneQuestion& question, const PosedArguments& arguments,
                    const std::string& label) {
  if (arguments.save_case.empty()) return asked(input, question, arguments.threads, label);
  require_distinct({{"--save-case", arguments.save_case}}, arguments.input.files);
  save(input, question, "", arguments.save_case);  // also tells at once where it cannot be written
  try {
    SceneAnswer answer = asked(input, question, arguments.threads, label);
    save(input, question, report_json(input.loaded.scene, input.models, answer), arguments.save_case);
    return answer;
  } catch (const Error& error) {
    save(input, question, error_json(error.what()), arguments.save_case);
    throw;
  }
}

}  // namespace toccata::command
