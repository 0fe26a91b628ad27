#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>

#include "load.hpp"
#include "options.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

constexpr int trouble = 2;

Format format_of(const Options& options) {
  return options.json ? Format::json : options.csv ? Format::csv : Format::table;
}

std::optional<Solid> solid_of(const std::string& word) {
  static const std::map<std::string, Solid> words{
      {"auto", Solid::automatic}, {"all", Solid::all}, {"none", Solid::none}};
  if (word.empty()) return std::nullopt;
  return words.at(word);
}

void take_poses_and_format(PosedArguments& arguments, const Options& options) {
  arguments.format = format_of(options);
  if (!options.pose_a.empty()) arguments.pose_a = parse_pose(options.pose_a, "--pose-a");
  if (!options.pose_b.empty()) arguments.pose_b = parse_pose(options.pose_b, "--pose-b");
}

int run(const CLI::App& app, Options& options) {
  if (app.got_subcommand("check")) {
    take_poses_and_format(options.check, options);
    options.check.solid = solid_of(options.solid);
    options.check.touching = options.touching == "ignore" ? Touching::ignore : Touching::count;
    return run_check(options.check);
  }
  if (app.got_subcommand("view")) {
    take_poses_and_format(options.view, options);
    options.view.solid = solid_of(options.solid);
    return run_view(options.view);
  }
  if (app.got_subcommand("distance")) {
    take_poses_and_format(options.distance, options);
    options.distance.solid = solid_of(options.solid);
    return run_distance(options.distance);
  }
  if (app.got_subcommand("ray")) {
    take_poses_and_format(options.ray, options);
    options.ray.solid = solid_of(options.solid);
    if (!options.from.empty()) options.ray.from = parse_point(options.from, "--from");
    if (!options.to.empty()) options.ray.to = parse_point(options.to, "--to");
    return run_ray(options.ray);
  }
  if (app.got_subcommand("faces")) {
    take_poses_and_format(options.faces, options);
    if (!options.box.empty()) options.faces.region = parse_box(options.box, "--box");
    if (!options.ball.empty()) options.faces.region = parse_ball(options.ball, "--ball");
    return run_faces(options.faces);
  }
  if (app.got_subcommand("cost")) {
    take_poses_and_format(options.cost, options);
    options.cost.options = cost_options_of(options.cost_words);
    return run_cost(options.cost);
  }
  if (app.got_subcommand("plot")) return run_plot(options.plot);
  if (app.got_subcommand("tree")) return run_tree(options.tree);
  if (app.got_subcommand("decompose")) {
    options.decompose.format = format_of(options);
    return run_decompose(options.decompose);
  }
  if (app.got_subcommand("nearest")) {
    options.nearest.format = format_of(options);
    if (!options.point.empty()) options.nearest.point = parse_point(options.point, "--point");
    return run_nearest(options.nearest);
  }
  if (app.got_subcommand("minkowski")) {
    take_poses_and_format(options.minkowski, options);
    if (!options.point.empty()) options.minkowski.question.point = parse_point(options.point, "--point");
    return run_minkowski(options.minkowski);
  }
  if (app.got_subcommand("replay")) {
    options.replay.format = format_of(options);
    return run_replay(options.replay);
  }
  if (app.got_subcommand("pairs")) return run_pairs({format_of(options)});
  if (app.got_subcommand("inspect")) {
    options.inspect.format = format_of(options);
    return options.inspect.hierarchy ? run_inspect_hierarchy(options.inspect) : run_inspect(options.inspect);
  }
  if (app.got_subcommand("crowd")) {
    options.crowd.format = format_of(options);
    return run_crowd(options.crowd);
  }
  options.demo.format = format_of(options);
  return run_demo(options.demo);
}

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

/// What to do about words that CLI11 could not take.
std::string hint_for(const CLI::App& app, const CLI::ParseError& error) {
  const std::string_view what = error.what();
  const auto says = [&](std::string_view words) { return what.find(words) != std::string_view::npos; };
  if (says("excludes")) return "give one of the two";
  if (says("--pose-")) return "12 numbers are needed, R row by row and then t; write -0.5 and not -.5";
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
  Options options;
  app.set_version_flag("--version", fmt::format("toccata {}", version));
  app.require_subcommand(1);
  app.footer(with_name("Example:\n  {0} demo\n  {0} check a.stl b.obj\n\n`{0} SUBCOMMAND --help` tells more."));
  add_subcommands(app, options);
  if (const std::string message = mistyped_subcommand(app, argc, argv); !message.empty())
    return report_trouble(message);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_text) {
    return app.exit(asked_for_text);
  } catch (const CLI::ParseError& error) {
    return report_trouble(fmt::format("{} ({})", error.what(), hint_for(app, error)));
  }
  return run(app, options);
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
