#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "arguments.hpp"
#include "ask.hpp"
#include "check_input.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/case_file.hpp"
#include "toccata/reports/output_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct ReplayArguments {
  std::string file;
  std::string save_case;  ///< the case with the answer of now; empty: none
  Format format = Format::table;
  int threads = 0;
};

/// The answer of now, as a case has it.
struct Replayed {
  CheckInput input;
  std::optional<SceneAnswer> answer;
  std::string json;
};

Replayed asked_again(const Case& content, int threads) {
  const Scene& scene = content.scene;
  Replayed now{{{scene, {0, scene.objects.size()}, {0, scene.nodes.size()}, {}, {scene.unit}}, {}}, {}, {}};
  try {
    now.input.models = scene_models(content.scene, threads);
    now.answer = ask(content.scene, now.input.models, *content.question, {threads, {}});
    now.json = report_json(content.scene, now.input.models, *now.answer);
  } catch (const Error& error) {
    now.json = error_json(error.what());
  }
  return now;
}

std::string verdict(const Case& content, const std::string& difference) {
  const std::size_t objects = content.scene.objects.size();
  const std::string what = fmt::format("the question {}{}", name_of(*content.question),
                                       objects == 0 ? "" : " about " + counted(objects, "object"));
  if (content.answer.empty()) return fmt::format("No answer was recorded to {}.\n", what);
  if (difference.empty()) return fmt::format("The same answer as recorded, bit for bit, to {}.\n", what);
  return fmt::format("Another answer than recorded to {}, first at\n  {}\n", what, printable(difference));
}

/// Prints what was answered; for an error, which is an answer too, its message. A report says that it is about the
/// case.
void print_replayed(const Case& content, const Replayed& now, const ReplayArguments& arguments) {
  if (!now.answer) return print_answer(now.json + "\n");
  PosedArguments asked;
  asked.input.files = {arguments.file};
  asked.format = arguments.format;
  print_answer(now.input, *content.question, *now.answer, asked);
}

int run_replay(const ReplayArguments& arguments) {
  Case content = read_case(arguments.file);
  if (!content.question)
    throw Error(
        fmt::format("{}: this scene holds no question to be asked again; `{} check` answers about scenes, and "
                    "--save-case keeps a question",
                    arguments.file, called_as()));
  if (!arguments.save_case.empty()) require_output(arguments.save_case, OutputKind::case_file);
  const Replayed now = asked_again(content, arguments.threads);
  const std::string difference = content.answer.empty() ? "" : answer_difference(content.answer, now.json);
  const std::string told = verdict(content, difference);
  if (!arguments.save_case.empty()) {
    content.answer = now.json;
    const UninterruptedWriting writing;
    write_case(content, arguments.save_case);
  }
  print_replayed(content, now, arguments);
  if (arguments.format == Format::table)
    print_answer(told);
  else
    fmt::print(stderr, "{}", told);
  return difference.empty() ? 0 : 1;
}

}  // namespace

Subcommand add_replay(CLI::App& app) {
  const auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* replay = app.add_subcommand("replay", "ask what a case file asks again, and compare the answer");
  replay->add_option("file", arguments->file, "a file that --save-case wrote")->required();
  add_formats(*replay, arguments->format, "that of the question");
  add_threads(*replay, arguments->threads, "answer");
  add_save_case(*replay, arguments->save_case, "write the case with the answer of now");
  replay->footer(with_name(
      "Exit code: 0 the answer is the recorded one to the bit, or none is recorded; 1 it is another; 2 trouble.\n\n"
      "Example:\n"
      "  {0} distance a.stl b.obj --save-case case.json\n"
      "  {0} replay case.json"));
  return {replay, [arguments] { return run_replay(*arguments); }};
}

}  // namespace toccata::command
