#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "option_kinds.hpp"
#include "over_ranks.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

constexpr int trouble = 2;

/// A mistyped subcommand gets the one that was probably meant; nothing when the first word is one.
std::string mistyped_subcommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return {};
  const std::string word = argv[1];
  std::vector<std::string> known;
  for (const CLI::App* sub : app.get_subcommands({})) known.push_back(sub->get_name());
  if (std::find(known.begin(), known.end(), word) != known.end()) return {};
  if (std::filesystem::exists(word))
    return fmt::format("there is no subcommand '{0}'; to check files, say: {1} check {0} …", word, called_as());
  return fmt::format("there is no subcommand '{}'{}", word, suggestion(word, known));
}

bool is_number(const std::string& word) {
  char* end = nullptr;
  static_cast<void>(std::strtod(word.c_str(), &end));
  return !word.empty() && end == word.c_str() + word.size();
}

/// The words behind the command's name, with the numbers of a pose (at most 16) as one word: a pose has as many as its
/// form asks for, and files may follow.
std::vector<std::string> words_of(int argc, char** argv) {
  constexpr std::size_t most_numbers = 16;
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    words.emplace_back(argv[i]);
    if (words.back() != "--pose-a" && words.back() != "--pose-b") continue;
    std::string pose;
    for (std::size_t count = 0; i + 1 < argc && count < most_numbers && is_number(argv[i + 1]); ++count, ++i)
      pose += (pose.empty() ? "" : " ") + std::string(argv[i + 1]);
    // With the option, or a pose that begins with a minus would be taken for another one.
    if (!pose.empty()) words.back() += "=" + pose;
  }
  return words;
}

/// What to do about words that CLI11 could not take.
std::string hint_for(const CLI::App& app, const CLI::ParseError& error) {
  const std::string_view what = error.what();
  const auto says = [&](std::string_view words) { return what.find(words) != std::string_view::npos; };
  if (says("excludes")) return "give one of the two";
  if (says("--sets")) return "sets are defined in the file of --rules";
  if (says("--pose-")) return "12 numbers are needed, R row by row and then t";
  std::vector<std::string> known;
  for (const CLI::App* sub : app.get_subcommands())
    for (const CLI::Option* option : sub->get_options())
      if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
  for (const std::string& word : app.remaining(true))
    if (const std::string meant = nearest_word(word, known); !meant.empty()) return "did you mean " + meant + "?";
  return "--help tells the options";
}

int report_trouble(const std::string& message) {
  fmt::print(stderr, "toccata: error: {}\n", printable(message));
  return trouble;
}

int main_of(int argc, char** argv) {
  CLI::App app("Toccata tells whether 3-D things touch: exactly, on real files.", "toccata");
  app.set_version_flag("--version", fmt::format("toccata {}", version));
  app.require_subcommand(1);
  app.footer(with_name("Example:\n  {0} demo\n  {0} check a.stl b.obj\n\n`{0} SUBCOMMAND --help` tells more."));
  std::vector<Subcommand> subcommands;
  for (const auto add : all_subcommands) subcommands.push_back(add(app));
  if (const std::string message = mistyped_subcommand(app, argc, argv); !message.empty())
    return report_trouble(message);
  run_over_ranks(app, argc, argv);
  try {
    std::vector<std::string> words = words_of(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::Success& asked_for_text) {
    return app.exit(asked_for_text);
  } catch (const CLI::ParseError& error) {
    return report_trouble(fmt::format("{} ({})", error.what(), hint_for(app, error)));
  }
  const auto given = [](const Subcommand& one) { return one.app->parsed(); };
  return std::find_if(subcommands.begin(), subcommands.end(), given)->run();
}

int reporting_main_of(int argc, char** argv) {
  try {
    return main_of(argc, argv);
  } catch (const std::bad_alloc&) {
    throw;  // a message could not be put together either
  } catch (const std::exception& error) {
    return report_trouble(error.what());
  }
}

}  // namespace
}  // namespace toccata::command

int main(int argc, char** argv) {
  try {
    return toccata::command::reporting_main_of(argc, argv);
  } catch (...) {
    std::fputs("toccata: error: not enough memory for this\n", stderr);
    return toccata::command::trouble;
  }
}
