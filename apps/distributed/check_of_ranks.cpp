// mpirun -np N toccata-check-ranks FILE…: what `toccata check FILE…` tells with --csv or --json, of scenes that no rank
// has all of. A program of its own, so that the command needs no MPI.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check_input.hpp"
#include "clearance.hpp"
#include "distributed/ranks.hpp"
#include "named_files.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "run_ranks.hpp"
#include "saved.hpp"
#include "toccata/core/error.hpp"
#include "toccata/distributed.hpp"
#include "toccata/reports/scene_question.hpp"
#include "told_part.hpp"
#include "view.hpp"

namespace toccata::command {
namespace {

/// For what other ranks read and decide.
constexpr double patience_seconds = 1800;

/// What is asked over ranks, in the words of `check`.
struct Arguments : CheckArguments {
  bool volume = false;
  std::string tolerance;  ///< a length; empty: none
  bool costs = false;
};

/// A file with its models.
struct PartRead {
  ConvertedScene file;
  std::vector<SceneInstance> models;
};

PartRead read_part(const Arguments& arguments, std::size_t part) {
  PartRead read{read_file(arguments.input.files[part], arguments.input), {}};
  if (arguments.solid)
    for (SceneObject& object : read.file.scene.objects) object.solid = *arguments.solid;
  read.models = scene_models(read.file.scene, arguments.threads);
  return read;
}

/// The files, as all ranks know them.
struct ToldFiles {
  LoadedScene loaded;  ///< shapes are not the objects' own (ToldPart)
  std::vector<std::string> summaries;
  std::vector<bool> is_open;
};

ToldFiles told_files(const Arguments& arguments, std::span<const Bytes> messages) {
  std::map<std::size_t, ToldPart> parts;
  for (const Bytes& bytes : messages)
    for (MessageReader reader(bytes); !reader.is_at_end();) {
      const auto number = reader.get<std::uint64_t>();
      parts.emplace(number, get_told_part(reader));
    }
  ToldFiles told;
  std::map<std::string, ConvertedScene> files;
  for (auto& [number, part] : parts) {
    told.summaries.insert(told.summaries.end(), part.summaries.begin(), part.summaries.end());
    told.is_open.insert(told.is_open.end(), part.is_open.begin(), part.is_open.end());
    files.emplace(arguments.input.files[number], std::move(part.file));
  }
  if (const std::string different = different_units(files); !different.empty())
    throw Error(
        fmt::format("{}: over ranks files of one unit are compared; `toccata check` makes metres of both", different));
  told.loaded = joined(arguments.input, files);
  return told;
}

/// The part of the first open mesh is read once more: what would close it is seen in its shape.
void warn_of_told_meshes(ToldFiles& told, const Arguments& arguments) {
  const auto first = static_cast<std::size_t>(std::ranges::find(told.is_open, true) - told.is_open.begin());
  if (first == told.is_open.size()) return;
  std::vector<std::string> open;
  for (std::size_t i = first; i < told.is_open.size(); ++i)
    if (told.is_open[i]) open.push_back(told.loaded.scene.objects[i].name);
  const std::vector<std::size_t>& first_of = told.loaded.first_object;
  const auto part = static_cast<std::size_t>(std::ranges::upper_bound(first_of, first) - first_of.begin()) - 1;
  SceneInstance model = read_part(arguments, part).models[first - first_of[part]];
  model.name = open.front();
  warn_of_open_meshes(told.loaded, open, model);
}

CheckQuestion question_of(const Arguments& arguments, const Scene& scene) {
  CheckQuestion question = check_question(arguments, false, read_clearances(arguments, scene));
  question.volume = arguments.volume;
  if (!arguments.tolerance.empty())
    question.tolerance =
        read_length("--tolerance", arguments.tolerance, length_units(scene, arguments.input), Longest::finite);
  return question;
}

std::vector<AskedFile> asked_files(const ToldFiles& told, const std::vector<std::string>& names) {
  const std::span<const SceneObject> objects = told.loaded.scene.objects;
  const std::span<const std::string> summaries = told.summaries;
  std::vector<AskedFile> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t first = told.loaded.first_object[i], count = told.loaded.first_object[i + 1] - first;
    files.push_back({names[i], content_digest(objects.subspan(first, count), summaries.subspan(first, count),
                                              told.loaded.units[i])});
  }
  return files;
}

void print_report(ToldFiles& told, const Arguments& arguments, const CheckQuestion& question,
                  const CheckReport& report) {
  warn_of_told_meshes(told, arguments);
  const LoadedScene& loaded = told.loaded;
  print_warnings(loaded.warnings);
  if (arguments.format == Format::json)
    print_answer(with_asked(check_report_json(loaded.scene, told.summaries, report, loaded.warnings),
                            asked_of(asked_files(told, arguments.input.files), arguments, question)));
  else
    print_answer(report_csv(loaded.scene, report));
}

void print_costs(const DistributedCheckCosts& own) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::array<double, 4> row{static_cast<double>(own.parts), static_cast<double>(own.elements),
                                  static_cast<double>(own.candidates), static_cast<double>(own.bytes_sent)};
  std::vector<double> rows(row.size() * static_cast<std::size_t>(ranks));
  MPI_Gather(row.data(), static_cast<int>(row.size()), MPI_DOUBLE, rows.data(), static_cast<int>(row.size()),
             MPI_DOUBLE, 0, MPI_COMM_WORLD);
  if (rank != 0) return;
  fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", "rank", "files", "elements", "pairs", "bytes sent");
  for (std::size_t i = 0; i < static_cast<std::size_t>(ranks); ++i)
    fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", i, rows[4 * i], rows[4 * i + 1], rows[4 * i + 2],
               rows[4 * i + 3]);
}

void require_files(const InputArguments& input) {
  if (input.files.empty()) throw Error("no file was named: name " + input.wanted);
  if (std::ranges::find(input.files, standard_input) != input.files.end())
    throw Error("standard input (-) is there for one process: over ranks name a file");
  if (!input.cache.empty()) throw Error("over ranks no trees are kept: leave out --cache");
  require_use_of_unit(input);
}

/// The exit code, on all ranks.
int check(const Arguments& arguments) {
  require_files(arguments.input);
  const MpiCommunicator all{MPI_Comm_c2f(MPI_COMM_WORLD)};
  Ranks ranks(all.fortran_handle, patience_seconds);
  MessageWriter own;
  bool is_first_look = true;
  const ReadPart read_and_tell = [&](std::size_t part) {
    PartRead read = read_part(arguments, part);
    if (is_first_look) {
      own.put(std::uint64_t{part});
      put_told_part(own, read.file, read.models);
    }
    return std::move(read.models);
  };
  DistributedScene scene(all, arguments.input.files.size(), read_and_tell, patience_seconds);
  is_first_look = false;
  ToldFiles told = told_files(arguments, ranks.of_all(own.take()));
  if (scene.model_count() < 2)
    throw Error(fmt::format("{} in all; a check needs two: name another file or a scene with more objects",
                            scene.model_count() == 1 ? "there is one object" : "there are no objects"));
  const CheckQuestion question = question_of(arguments, told.loaded.scene);
  CheckOptions options = check_all_options(question);
  options.threads = arguments.threads;
  const CheckReport report = make_check_report({}, scene.check(options), question);
  if (ranks.rank() == 0) print_report(told, arguments, question, report);
  std::uint64_t clashes = static_cast<std::uint64_t>(std::ranges::count_if(report.pairs, is_clash));
  ranks.add_up({&clashes, 1});
  if (arguments.costs) print_costs(scene.costs());
  return clashes > 0 ? 1 : 0;
}

void add_options(CLI::App& app, Arguments& arguments) {
  add_input(app, arguments.input, any_files);
  add_solid(app, arguments);
  add_clearances(app, arguments);
  app.add_flag("--penetration", arguments.penetration, "how deep solids overlap");
  app.add_flag("--volume", arguments.volume, "how much volume solids have in common");
  add_length(app, "--tolerance", arguments.tolerance,
             "overlaps that are certainly no deeper are told apart and are no clash (0.1mm)");
  app.add_option("--touching", arguments.touching_word, "whether pairs that merely touch are told")
      ->check(CLI::IsMember({"count", "ignore"}))
      ->capture_default_str();
  add_formats(app, arguments.format, "docs/reference/check-report.md");
  app.add_option("--threads", arguments.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  app.add_flag("--costs", arguments.costs, "what each rank had to read and to decide, on the standard error");
}

int main_of(int count, char** words) {
  Arguments arguments;
  arguments.threads = own_thread;
  CLI::App app(
      "Which objects touch, decided exactly: lines of values, or JSON, to the byte what `toccata check` writes with "
      "the "
      "same words and --csv or --json. Each rank of mpirun reads the files that its pairs are in, and no other.");
  add_options(app, arguments);
  app.footer("Exit code: 0 nothing touches or is nearer than its clearance, 1 something is, 2 trouble.");
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  take_words(arguments);
  arguments.touching = arguments.touching_word == "ignore" ? Touching::ignore : Touching::count;
  return check(arguments);
}

}  // namespace
}  // namespace toccata::command

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-check-ranks",
                            [&] { return toccata::command::main_of(count, words); });
}
